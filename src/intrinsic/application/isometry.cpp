// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "isometry.h"
#include "../commands.h"
#include "../improve.h"
#include "../load.h"
#include "../output_files.h"
#include "../statistics.h"
#include "../support/naming_file.h"
#include "../support/progress.h"

#include <CGAL/Intrinsic_simplification/isometry/Canonical_form.h>
#include <CGAL/Intrinsic_simplification/isometry/find_isometries.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>

#include <cmath>
#include <cstdint>
#include <iomanip>
#include <optional>
#include <sstream>
#include <string>
#include <utility>

namespace program {

namespace {

IT::Isometry_options shown_by(Progress& progress) {
  IT::Isometry_options options;
  options.progress = [&progress](const IT::Isometry_progress& p) {
    return progress.show(IT::name_of(p.stage));
  };
  return options;
}

// The canonical form of the surface of a file. \param json gets what is known of the surface
IT::Canonical_form form_of(const Options& options, Progress& progress, Json& json) {
  std::optional<IT::Canonical_form> form;
  with_loaded<IT::Integer_coordinates>(options, progress, [&](auto& loaded) {
    json = loaded_json(loaded, options);
    naming_file(options.input,
                [&] { form = IT::canonical_form(loaded.triangulation, shown_by(progress)); });
  });
  return std::move(form).value();
}

// An integer where doubles are as exact.
Json whole(double number) {
  return number < 0x1p53 ? Json(static_cast<std::uint64_t>(number)) : Json(number);
}

Json isometry_json(const IT::Isometries& found) {
  const double difference = found.largest_difference();
  Json json = {{"answer", IT::name_of(found.answer())}, {"count", whole(found.count())}};
  json["largest_difference"] = std::isfinite(difference) ? Json(difference) : Json(nullptr);
  if (!found.note().empty()) json["note"] = found.note();
  return json;
}

std::string hexadecimal(std::uint64_t x) {
  std::ostringstream out;
  out << std::hex << std::setw(16) << std::setfill('0') << x;
  return out.str();
}

} // namespace

void run_isometry(const Options& options) {
  Progress progress(options.logs_progress, options.is_quiet);
  Json json, other;
  const IT::Canonical_form a = form_of(options, progress, json);
  Options second = options;
  if (!options.other.empty()) second.input = options.other;
  const IT::Canonical_form b = options.other.empty() ? a : form_of(second, progress, other);
  IT::Stopwatch watch;
  json["isometry"] = isometry_json(IT::find_isometries(a, b, shown_by(progress)));
  if (!other.is_null()) json["isometry"]["other"] = other["input"];
  json["seconds"]["isometry"] = watch.lap();
  Output_files files;
  finish(json, options, files, watch);
}

void run_info_with_hash(const Options& options) {
  Progress progress(options.logs_progress, options.is_quiet);
  with_loaded<IT::Integer_coordinates>(options, progress, [&](auto& loaded) {
    Options as_it_is = options;
    as_it_is.no_flip = true;
    Json json = improve_and_measure(loaded, as_it_is, progress);
    IT::Stopwatch watch;
    json["hash"] = naming_file(options.input, [&] {
      const IT::Isometry_options shown = shown_by(progress);
      return hexadecimal(IT::canonical_form(loaded.triangulation, shown).hash(shown));
    });
    json["seconds"]["hash"] = watch.lap();
    Output_files files;
    finish(json, options, files, watch);
  });
}

} // namespace program
