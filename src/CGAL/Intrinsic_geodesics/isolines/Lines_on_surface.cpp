// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_geodesics/isolines/Lines_on_surface.h>
#include <CGAL/Intrinsic_geodesics/queries/trace_curve.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/points_on_input.h>
#include <CGAL/Intrinsic_triangulations/formulas/Plane_vector.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

Lines_on_surface::Lines_on_surface(const Input& input) : input_(input), sheets_(input) {
  if (sheets_.is_cover()) chosen_ = sheets_.one_sheet();
}

bool Lines_on_surface::is_chosen(const Traced_isoline& line, std::size_t piece) const {
  return chosen_[line.curve.faces[piece]] != 0;
}

bool Lines_on_surface::is_on_seam(const Surface_point& p) const {
  const auto sides = sides_of_face(input_, p.halfedge);
  for (unsigned k = 0; k < 3; ++k) {
    if (p.weights[(k + 2) % 3] != 0) continue; // not on side k
    if (p.weights[(k + 1) % 3] != 0) {
      if (p.weights[k] != 0) return sheets_.is_seam(sides[k] / 2);
      continue;
    }
    bool has_seam = false;
    measure_fan(input_, sides[k],
                [&](std::uint32_t h, double) { has_seam = has_seam || sheets_.is_seam(h / 2); });
    return has_seam;
  }
  return false;
}

double Lines_on_surface::length(const Traced_isoline& line, std::size_t piece) const {
  const auto in_face = [&](std::size_t i) {
    return seen_in_face(input_, line.curve.points[i], line.curve.faces[piece]);
  };
  const Unscaled_vector v = vector_between(input_, in_face(piece), in_face(piece + 1));
  return std::hypot(v[0], v[1]);
}

// Some pieces of a line, those of closed ones in a circle.
Traced_isoline Lines_on_surface::part(const Traced_isoline& line, std::size_t begin,
                                      std::size_t pieces) const {
  Traced_isoline result{line.level, line.number_of_level, false, {}};
  const std::size_t all = line.curve.faces.size();
  Traced_curve& curve = result.curve;
  curve.status = line.curve.status;
  curve.length_enclosure = {0, std::numeric_limits<double>::infinity()};
  for (std::size_t i = begin; i < begin + pieces; ++i) {
    curve.points.push_back(line.curve.points[i % all]);
    curve.faces.push_back(line.curve.faces[i % all]);
    curve.length += length(line, i % all);
  }
  curve.points.push_back(line.curve.points[(begin + pieces - 1) % all + 1]);
  return result;
}

// Cuts a line between pieces. `is_end` is called with the number of the second one of two.
template <class Is_end>
std::vector<Traced_isoline> Lines_on_surface::split(const Traced_isoline& line,
                                                    const Is_end& is_end) const {
  const std::size_t pieces = line.curve.faces.size();
  std::vector<std::size_t> ends;
  for (std::size_t i = line.is_closed ? 0 : 1; i < pieces; ++i)
    if (is_end(i)) ends.push_back(i);
  if (ends.empty()) return {line};
  if (line.is_closed)
    ends.push_back(ends.front() + pieces);
  else {
    ends.insert(ends.begin(), 0);
    ends.push_back(pieces);
  }
  std::vector<Traced_isoline> parts;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i)
    parts.push_back(part(line, ends[i], ends[i + 1] - ends[i]));
  return parts;
}

void Lines_on_surface::add_section(const Traced_isoline& section,
                                   std::vector<Traced_isoline>& lines) const {
  constexpr double same = 0x1p-30; // of lengths that differ by rounding
  const std::size_t pieces = section.curve.faces.size();
  double here = 0, there = 0;
  for (std::size_t i = 0; i < pieces; ++i)
    (is_chosen(section, i) ? here : there) += length(section, i);
  const double rounding = same * std::max(here, there);
  if (here > there + rounding) lines.push_back(section);
  if (std::abs(here - there) > rounding) return;
  const auto leaves = [&](std::size_t i) {
    return is_chosen(section, i) != is_chosen(section, i == 0 ? pieces - 1 : i - 1);
  };
  for (Traced_isoline& run : split(section, leaves))
    if (is_chosen(run, 0)) lines.push_back(std::move(run));
}

void Lines_on_surface::add(const Traced_isoline& line, std::vector<Traced_isoline>& lines) const {
  if (chosen_.empty() || line.curve.faces.empty()) return lines.push_back(line);
  const auto crosses = [&](std::size_t i) { return is_on_seam(line.curve.points[i]); };
  for (const Traced_isoline& section : split(line, crosses)) add_section(section, lines);
}

} // namespace CGAL::Intrinsic_triangulations::internal
