// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "asked_curves.h"
#include "support/text_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string_view>

namespace program {

namespace {

namespace internal = CGAL::Intrinsic_triangulations::internal;

std::vector<std::string_view> parts(std::string_view text, char separator) {
  std::vector<std::string_view> result;
  while (true) {
    const std::size_t n = std::min(text.find(separator), text.size());
    result.push_back(text.substr(0, n));
    if (n == text.size()) return result;
    text.remove_prefix(n + 1);
  }
}

std::optional<IT::Place> point_of(std::string_view text) {
  const std::vector<std::string_view> words = parts(text, ':');
  std::uint32_t element = 0;
  if (!internal::parse_number(words[0], element)) return std::nullopt;
  if (words.size() == 1) return IT::Place::at_vertex(element);
  if (words.size() != 4) return std::nullopt;
  std::array<double, 3> weights{};
  for (std::size_t k = 0; k < 3; ++k)
    if (!internal::parse_number(words[k + 1], weights[k]) || !(weights[k] >= 0))
      return std::nullopt;
  if (!(std::abs(weights[0] + weights[1] + weights[2] - 1) <= 1e-6)) return std::nullopt;
  return IT::Place::in_face(element, weights);
}

std::vector<IT::Place> points_of(std::string_view text) {
  std::vector<IT::Place> points;
  for (const std::string_view word : parts(text, ',')) points.push_back(point_of(word).value());
  return points;
}

void expect_elements(const Asked_curve& curve, const std::string& file, std::size_t vertices,
                     std::size_t faces) {
  for (const IT::Place& p : curve.points) {
    const std::size_t count = p.has_face() ? faces : vertices;
    const char* const kind = p.has_face() ? "face" : "vertex";
    const std::uint32_t element = p.has_face() ? p.face : p.vertex;
    if (count == 0)
      throw std::runtime_error(curve.source + ": " + file + " has no faces; give numbers of " +
                               "vertices");
    if (element >= count)
      throw std::runtime_error(curve.source + ": " + kind + " " + std::to_string(element) +
                               " does not exist in " + file + "; give numbers from 0 to " +
                               std::to_string(count - 1));
  }
}

void append_network(const std::string& path, std::size_t vertices,
                    std::vector<Asked_curve>& curves) {
  Text_lines lines(path);
  const std::size_t before = curves.size();
  while (lines.next()) {
    Asked_curve curve{{}, lines.words().front() == "loop", {}, Curve_kind::joined};
    for (std::size_t i = curve.is_loop ? 1 : 0; i < lines.words().size(); ++i)
      curve.points.push_back(IT::Place::at_vertex(lines.element(i, "vertex", vertices)));
    if (curve.points.size() < (curve.is_loop ? 3 : 2))
      lines.refuse(curve.is_loop ? "a loop needs three vertices at least; add some"
                                 : "a path needs two vertices at least; add some");
    curve.source = path + ":" + std::to_string(lines.line());
    curves.push_back(std::move(curve));
  }
  if (curves.size() == before)
    throw std::runtime_error(path + ": the file has no curves; give one on each line");
}

} // namespace

std::string curve_points_misuse(const std::string& text, std::size_t least) {
  const std::vector<std::string_view> words = parts(text, ',');
  for (const std::string_view word : words)
    if (!point_of(word))
      return std::string("\"") + internal::shown(word) +
             "\" is not a point; give the number of a vertex, from 0, or face:b0:b1:b2 with "
             "weights "
             "that sum to 1";
  if (words.size() < least)
    return std::string("\"") + text + "\" has too few points; give " + std::to_string(least) +
           " at least, separated by commas";
  return {};
}

std::vector<Asked_curve> asked_points(const Options& options, std::size_t vertices,
                                      std::size_t faces) {
  std::vector<Asked_curve> lists;
  const auto append = [&](const std::vector<std::string>& texts, const std::string& option,
                          Curve_kind kind) {
    for (const std::string& text : texts) {
      lists.push_back({points_of(text), false, option + ' ' + text, kind});
      expect_elements(lists.back(), options.input, vertices, faces);
    }
  };
  append(options.application.sources, "--source", Curve_kind::source);
  append(options.application.curves, "--curve", Curve_kind::joined);
  append(options.application.targets, "--targets", Curve_kind::source);
  return lists;
}

std::vector<Asked_curve> asked_curves(const Options& options, std::size_t vertices,
                                      std::size_t faces) {
  std::vector<Asked_curve> curves;
  const Geodesic_options& g = options.geodesic;
  for (const std::string& text : g.paths)
    curves.push_back({points_of(text), false, "--path " + text});
  for (const std::string& text : g.loops)
    curves.push_back({points_of(text), true, "--loop " + text});
  if (!g.bezier.empty())
    curves.push_back(
        {points_of(g.bezier), false, "--bezier " + g.bezier, Curve_kind::control_points});
  if (!g.source.empty())
    curves.push_back({points_of(g.source), false, "--source " + g.source, Curve_kind::source});
  for (const Asked_curve& curve : curves) expect_elements(curve, options.input, vertices, faces);
  if (!g.network.empty()) append_network(g.network, vertices, curves);
  return curves;
}

} // namespace program
