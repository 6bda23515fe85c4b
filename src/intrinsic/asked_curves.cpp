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

namespace text = CGAL::Intrinsic_triangulations::text;

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
  if (!text::parse_number(words[0], element)) return std::nullopt;
  if (words.size() == 1) return IT::Place::at_vertex(element);
  if (words.size() != 4) return std::nullopt;
  std::array<double, 3> weights{};
  for (std::size_t k = 0; k < 3; ++k)
    if (!text::parse_number(words[k + 1], weights[k]) || !(weights[k] >= 0)) return std::nullopt;
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
  for (const IT::Place& p : curve.places) {
    const std::size_t count = p.has_face() ? faces : vertices;
    const char* const kind = p.has_face() ? "face" : "vertex";
    const std::uint32_t element = p.has_face() ? p.face : p.vertex;
    if (count == 0)
      throw std::runtime_error(curve.name + ": " + file + " has no faces; give numbers of " +
                               "vertices");
    if (element >= count)
      throw std::runtime_error(curve.name + ": " + kind + " " + std::to_string(element) +
                               " does not exist in " + file + "; give numbers from 0 to " +
                               std::to_string(count - 1));
  }
}

void append_network(const std::string& path, std::size_t vertices, bool stays,
                    std::vector<Asked_curve>& curves) {
  Text_lines lines(path);
  const std::size_t before = curves.size();
  while (lines.next()) {
    Asked_curve curve{{}, lines.words().front() == "loop"};
    for (std::size_t i = curve.is_loop ? 1 : 0; i < lines.words().size(); ++i)
      curve.places.push_back(IT::Place::at_vertex(lines.element(i, "vertex", vertices)));
    if (curve.places.size() < (curve.is_loop ? 3 : 2))
      lines.refuse(curve.is_loop ? "a loop needs three vertices at least; add some"
                                 : "a path needs two vertices at least; add some");
    curve.stays_at_places = stays;
    curve.name = path + ":" + std::to_string(lines.line());
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
      return std::string("\"") + text::shown(word) +
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
                          IT::Curve_kind kind) {
    for (const std::string& text : texts) {
      lists.push_back({points_of(text), false, false, kind, option + ' ' + text});
      expect_elements(lists.back(), options.input, vertices, faces);
    }
  };
  append(options.application.sources, "--source", IT::Curve_kind::tree);
  append(options.application.curves, "--curve", IT::Curve_kind::geodesic);
  append(options.application.targets, "--targets", IT::Curve_kind::tree);
  return lists;
}

std::vector<Asked_curve> asked_curves(const Options& options, std::size_t vertices,
                                      std::size_t faces) {
  std::vector<Asked_curve> curves;
  const Geodesic_options& g = options.geodesic;
  const auto append = [&](const std::string& text, const char* option, IT::Curve_kind kind,
                          bool is_loop = false) {
    if (!text.empty())
      curves.push_back({points_of(text), is_loop, g.has_waypoints, kind, option + text});
  };
  for (const std::string& text : g.paths) append(text, "--path ", IT::Curve_kind::geodesic);
  for (const std::string& text : g.loops) append(text, "--loop ", IT::Curve_kind::geodesic, true);
  append(g.bezier, "--bezier ", IT::Curve_kind::bezier);
  append(g.source, "--source ", IT::Curve_kind::tree);
  for (const Asked_curve& curve : curves) expect_elements(curve, options.input, vertices, faces);
  if (!g.network.empty()) append_network(g.network, vertices, g.has_waypoints, curves);
  return curves;
}

} // namespace program
