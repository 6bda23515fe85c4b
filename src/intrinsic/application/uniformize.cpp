// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../commands.h"
#include "../support/warnings.h"
#include "application.h"
#include "conformal_results.h"
#include "prescribed_angles.h"

#include <CGAL/Intrinsic_conformal/maps/uniformize.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace program {

namespace {

bool is_number(const std::string& word) {
  return word.find_first_not_of("0123456789") == std::string::npos;
}

// The ratio in a word such as 10x or 2.5x; nothing if it is none.
std::optional<double> ratio_of(const std::string& word) {
  if (word.size() < 2 || word.back() != 'x') return std::nullopt;
  const std::string number = word.substr(0, word.size() - 1);
  if (number.find_first_not_of("0123456789.") != std::string::npos) return std::nullopt;
  try {
    return std::stod(number);
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

constexpr std::array<std::pair<const char*, IT::Uniform_target>, 5> targets{
    {{"", IT::Uniform_target::automatic},
     {"plane", IT::Uniform_target::plane},
     {"sphere", IT::Uniform_target::sphere},
     {"torus", IT::Uniform_target::torus},
     {"disk", IT::Uniform_target::disk}}};

void check_words(const Uniformize_options& asked) {
  const bool has_angles = !asked.angles.empty() || !asked.cones.empty();
  if (asked.target == "disk" && !asked.cones.empty() &&
      (is_number(asked.cones) || ratio_of(asked.cones)))
    throw std::runtime_error("--cones " + asked.cones +
                             " places cones of flat surfaces; with --target disk, list cones with "
                             "their angles in a file");
  if (has_angles && (asked.target == "sphere" || asked.target == "torus"))
    throw std::runtime_error("--target " + asked.target +
                             " has no cones; leave --angles and --cones out");
}

IT::Uniformize_options asked_options(const Uniformize_options& asked, Progress& progress) {
  check_words(asked);
  IT::Uniformize_options options;
  options.target = std::ranges::find(targets, asked.target, [](const auto& t) {
                     return std::string(t.first);
                   })->second;
  if (!asked.start.empty())
    options.start = asked.start == "input" ? IT::Uniform_start::input : IT::Uniform_start::delaunay;
  if (!asked.angles.empty())
    options.prescribe = [&asked](IT::Prescribed_angles& angles) {
      angles = read_angles(asked.angles, angles.size());
    };
  else if (!asked.cones.empty() && is_number(asked.cones))
    options.cones = std::stoul(asked.cones);
  else if (const std::optional<double> ratio = ratio_of(asked.cones))
    options.scale_ratio = ratio;
  else if (!asked.cones.empty())
    options.prescribe = [&asked](IT::Prescribed_angles& angles) {
      read_cones(asked.cones, angles);
    };
  options.progress = [&progress](const IT::Conformal_progress& p) {
    return progress.show("solving", std::to_string(p.iteration) + " iterations");
  };
  options.before_layout = [&progress](std::uint64_t crossings) { // each needs up to a kilobyte
    // up to a gigabyte in all
    constexpr std::uint64_t many = 1'000'000;
    if (crossings >= many)
      progress.say("edges cross at " + std::to_string(crossings) +
                   " places; a layout with as many pieces takes long and much memory, scale "
                   "factors alone, in a file .txt, do not");
  };
  return options;
}

Json json_of(const IT::Uniformization& found, const Uniformize_options& asked) {
  Json cones = Json::array();
  for (const std::uint32_t v : found.cones())
    cones.push_back({{"vertex", v}, {"angle", found.angles.radians(v)}});
  const IT::Conformal_metric& m = found.metric;
  const bool starts_from_input = found.start == IT::Uniform_start::input;
  Json json = {
      {"status", IT::name_of(found.status)},
      {"start", starts_from_input ? "input" : "delaunay"},
      {"target",
       std::ranges::find(targets, found.target, &decltype(targets)::value_type::second)->first},
      {"iterations", m.iterations},
      {"residual", m.residual},
      {"flips", m.flips},
      {"cones", cones.size()}};
  json["proven_residual"] = m.proven_residual ? Json(*m.proven_residual) : Json(nullptr);
  if (!asked.cones.empty()) json["cone_angles"] = cones;
  if (found.period) json["period"] = {found.period->real(), found.period->imag()};
  if (found.sphere) {
    json["pole"] = found.sphere->layout.pole;
    json["rounds"] = found.sphere->rounds;
    json["convex"] = found.sphere->is_convex;
    json["injective"] = found.sphere->layout.is_injective();
    json["flipped_faces"] = found.sphere->layout.flipped_faces;
  }
  return json;
}

// Says what the result lacks.
void warn_of_status(const IT::Uniformization& found) {
  std::ostringstream words;
  if (found.status == IT::Status::inaccurate)
    words << "angles are right, but rounding has turned over pieces of the map; cones, or other "
             "ones, bring scales nearer to each other";
  else if (found.sphere && found.status == IT::Status::stalled)
    words << "the map to the sphere is the best that was found, but not the one wanted: edges "
             "between neighbours of the pole are not convex; take --target plane with --cones";
  else
    words << "the solver has stopped before the angles were right: they differ by up to "
          << found.metric.residual << " radians; take other angles or cones";
  if (found.status != IT::Status::done) warn(words.str());
}

// Text has the values alone.
bool writes_text(const Options& options) {
  return !options.output.empty() && !is_mesh_output(options);
}

// Whether files show the surface in its new shape.
bool writes_shape(const Options& options) {
  return needs_subdivision(options) && !writes_text(options);
}

Eigen::MatrixXd displacements_to(const IT::Sphere_layout& layout, const Points& points) {
  Eigen::MatrixXd result(static_cast<Eigen::Index>(layout.positions.size()), 3);
  for (std::size_t v = 0; v < layout.positions.size(); ++v) // without inserted ones
    for (std::size_t c = 0; c < 3; ++c)
      result(static_cast<Eigen::Index>(v), static_cast<Eigen::Index>(c)) =
          layout.positions[v][c] - points[v][c];
  return result;
}

template <class Triangulation>
bool has_inserted(const Triangulation& t) {
  return t.number_of_vertices() > t.input().number_of_rows();
}

// \param is_laid_out whether files show the surface in its new shape
template <class Triangulation>
Computed uniformized(const Triangulation& t, const Points& points, const Options& options,
                     bool is_laid_out, Progress& progress) {
  IT::Uniformize_options asked = asked_options(options.uniformize, progress);
  asked.is_laid_out = is_laid_out;
  const IT::Uniformization found = IT::uniformize(t, asked);
  if (is_laid_out && !found.no_layout.empty())
    throw IT::Invalid_input(IT::Element_kind::none, 0, found.no_layout + ", in a file .txt");
  Computed computed{
      "conformal",
      json_of(found, options.uniformize),
      {{"u", Eigen::VectorXd::Map(found.u.data(), static_cast<Eigen::Index>(found.u.size()))}}};
  warn_of_status(found);
  if (!options.uniformize.cones.empty()) {
    computed.marks.name = "cones";
    for (const std::uint32_t v : found.cones())
      computed.marks.points.push_back({{points[v]}, false, 0});
  }
  if (found.sphere && is_laid_out) // vertices move to the sphere
    computed.displacements = displacements_to(found.sphere->layout, points);
  if (found.layout) computed.laid_out = shown_layout(*found.layout, points, computed.json);
  const Eigen::VectorXd& u = computed.functions.front().values;
  computed.json["least_u"] = u.minCoeff();
  computed.json["largest_u"] = u.maxCoeff();
  computed.json["max_scale_ratio"] = std::exp(u.maxCoeff() - u.minCoeff());
  computed.timed = "uniformize";
  return computed;
}

} // namespace

void run_uniformize(const Options& options) {
  run_application(options, [&](auto& t, const Sources&, const Points& points, Progress& progress) {
    Computed computed = uniformized(t, points, options, writes_shape(options), progress);
    computed.is_of_input = has_inserted(t);
    return computed;
  });
}

void run_conformal_map(const Options& given) {
  Options options = given;
  options.uniformize.target = "plane";
  run_application(options, [&](auto& t, const Sources&, const Points& points, Progress& progress) {
    if (has_inserted(t))
      throw IT::Invalid_input(IT::Element_kind::none, 0,
                              "--method conformal maps the vertices of the file, and others were "
                              "inserted; start from the mesh");
    IT::expect_disks(t.input());
    return map_of_disks(uniformized(t, points, options, true, progress), t.input(), points,
                        options.application.on == "input");
  });
}

} // namespace program
