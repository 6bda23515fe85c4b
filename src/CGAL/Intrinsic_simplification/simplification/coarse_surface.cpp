// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/simplification/Simplifier.h>
#include <CGAL/Intrinsic_simplification/simplification/hierarchy.h>
#include <CGAL/Intrinsic_simplification/simplification/remove_flat_vertices.h>
#include <CGAL/Intrinsic_simplification/simplification/simplify.h>
#include <CGAL/Intrinsic_triangulations/input/metric_scaling/triangle_inequality.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <limits>
#include <string>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

// Numbers that elements have when others are left out.
std::vector<std::uint32_t> compacted(const std::vector<std::uint32_t>& in_order,
                                     const auto& stays) {
  std::vector<std::uint32_t> result(in_order.size(), Gluing::none);
  std::uint32_t n = 0;
  for (const std::uint32_t i : in_order)
    if (stays(i)) result[i] = n++;
  return result;
}

std::array<Interval, 3> multiples(double factor, const Side_values& form) {
  return {factor * Interval(form[0]), factor * Interval(form[1]), factor * Interval(form[2])};
}

// The factor, proven not to be greater than `form` by `by` anywhere.
double proven_lower(const Side_values& form, const Side_values& above) {
  if (!std::ranges::all_of(above, [](double x) { return std::isfinite(x); })) return 0;
  const double near = factors(form, above)[0];
  if (!(near > 0 && std::isfinite(near) && std::isfinite(4 / near))) return 0;
  for (double margin = 0x1p-51; margin < 1; margin *= 2) {
    // form - near / (1 + margin) above >= 0
    const double inverse = 1 / near * (1 + margin);
    if (is_proven_below(above, multiples(inverse, form)))
      return (Interval(1) / sqrt(Interval(inverse))).inf();
  }
  return 0;
}

double proven_upper(const Side_values& form, const Side_values& below) {
  const double near = factors(form, below)[1]; // infinite if `below` is 0 somewhere
  if (!std::isfinite(4 * near)) return std::numeric_limits<double>::infinity();
  for (double margin = 0x1p-51; margin < 1; margin *= 2) {
    const double factor = near * (1 + margin);
    if (is_proven_below(form, multiples(factor, below))) return sqrt(Interval(factor)).sup();
  }
  return std::numeric_limits<double>::infinity();
}

// The lengths of a face as they are in the units of the user, where small ones may be rounded.
Side_values written_lengths(const Coarse_face& face, int scale_exponent) {
  Side_values result;
  for (std::size_t k = 0; k < 3; ++k)
    result[k] = std::ldexp(std::ldexp(face.length[k], -2 * scale_exponent), 2 * scale_exponent);
  return result;
}

void find_stretch(Simplification& s, const Coarse_mesh& mesh, int scale_exponent) {
  const Protect_FPU_rounding<true> up;
  s.stretch = {std::numeric_limits<double>::infinity(), 0, 0, 0};
  double area = 0;
  for (const std::uint32_t f : mesh.faces()) {
    const Coarse_face& face = mesh.face(f);
    if (face.is_removed) continue;
    const Side_values length = written_lengths(face, scale_exponent);
    const Face_stretch r{proven_lower(length, mesh.forms(f).above),
                         proven_upper(length, mesh.forms(f).below)};
    s.face_stretch.push_back(r);
    s.stretch.lower = std::min(s.stretch.lower, r.lower);
    s.stretch.upper = std::max(s.stretch.upper, r.upper);
    const double a = mesh.quadruple_area(f);
    area += a;
    s.stretch.mean_lower += a * r.lower;
    s.stretch.mean_upper += a * r.upper;
  }
  s.stretch.mean_lower /= area;
  s.stretch.mean_upper /= area;
}

void expect_range(const Simplify_options& options) {
  if (!(options.stretch >= 1))
    throw Invalid_input(Element_kind::none, 0,
                        "the stretch is at least 1, not " + shortest_text(options.stretch));
  if (std::isnan(options.cost))
    throw Invalid_input(Element_kind::none, 0, "the bound of the cost is not a number");
  if (options.part && !(*options.part > 0 && *options.part <= 1))
    throw Invalid_input(Element_kind::none, 0,
                        "the part of the vertices that is wanted is above 0 and at most 1, not " +
                            shortest_text(*options.part));
}

// A part of a number of vertices: one at least.
std::size_t part_of(double part, std::size_t vertices) {
  return std::max<std::size_t>(1, static_cast<std::size_t>(part * static_cast<double>(vertices)));
}

// How many vertices are wanted, if none of the bounds is reached before.
std::size_t wanted_vertices(const Simplify_options& options, std::size_t vertices) {
  const bool is_bounded = std::isfinite(options.stretch) || std::isfinite(options.cost);
  const double part = options.part.value_or(options.vertices || is_bounded ? 0 : 0.1);
  return std::max(options.vertices.value_or(0), part > 0 ? part_of(part, vertices) : 0);
}

// Thin faces keep exact lengths while they are flipped, but not as part of the surface.
// \param row returns the user's vertex of a vertex
void expect_triangle(const Coarse_face& face, const auto& row) {
  if (squares_satisfy_triangle_inequality(face.length[0], face.length[1], face.length[2])) return;
  const auto name = [&](std::size_t k) { return std::to_string(row(face.origin[k % 3])); };
  std::string kept;
  for (std::size_t k = 0; k < 3; ++k)
    if ((face.kept_sides >> k & 1U) != 0)
      kept += (kept.empty() ? "; kept edges of it: " : ", ") + name(k) + " to " + name(k + 1);
  throw Invalid_input(Element_kind::none, 0,
                      "the face of the coarse surface between the vertices " + name(0) + ", " +
                          name(1) + " and " + name(2) +
                          " is too thin for doubles, and cannot be written" + kept +
                          "; keep fewer of its vertices and edges, or remove such faces before");
}

} // namespace

// The triangles that are left, numbered without gaps, in the units of the user.
void Simplifier::write_surface(Simplification& s, const std::vector<std::uint32_t>& vertex,
                               const std::vector<std::uint32_t>& face) const {
  Gluing g;
  g.number_of_vertices = static_cast<std::uint32_t>(number_left_);
  std::vector<double> length; // by sides
  for (const std::uint32_t place : mesh_.faces()) {
    const Coarse_face& f = mesh_.face(place);
    if (f.is_removed) continue;
    expect_triangle(f, [this](std::uint32_t v) { return fine_.row[mesh_.number(v)]; });
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t o = f.glue[k];
      g.origin.push_back(vertex[f.origin[k]]);
      g.glue.push_back(o == Gluing::none ? o : 3 * face[o / 3] + o % 3);
      length.push_back(std::ldexp(f.length[k], -2 * fine_.scale_exponent));
    }
  }
  s.surface.mesh = Gluing_map(g);
  s.surface.may_renumber = false;
  s.surface.squared_lengths.resize(s.surface.mesh.number_of_edges());
  for (std::uint32_t f = 0; f < g.number_of_faces(); ++f) {
    const auto sides = s.surface.mesh.sides({f});
    for (std::uint32_t k = 0; k < 3; ++k)
      s.surface.squared_lengths[sides[k].index / 2] = length[3 * f + k];
  }
}

void Simplifier::write_places(Simplification& s, const std::vector<std::uint32_t>& vertex,
                              const std::vector<std::uint32_t>& face) const {
  s.places.resize(fine_.number_of_rows);
  std::vector<char> is_placed(fine_.number_of_rows, 0);
  for (const std::uint32_t v : mesh_.vertices()) {
    const std::uint32_t row = fine_.row[mesh_.number(v)];
    if (vertex[v] != Gluing::none) s.kept.push_back(row);
    if (is_placed[row] != 0) continue;
    is_placed[row] = 1;
    const Point_on_coarse& p = mesh_.point(v);
    if (vertex[v] != Gluing::none)
      s.places[row] = Place::at_vertex(vertex[v]);
    else if (p.face != Gluing::none)
      s.places[row] = Place::in_face(face[p.face], p.weights);
  }
}

Simplification Simplifier::take_result() const {
  Simplification s;
  s.status = status_;
  const auto vertex = compacted(mesh_.vertices(),
                                [&](std::uint32_t v) { return mesh_.outgoing(v) != Gluing::none; });
  const auto face =
      compacted(mesh_.faces(), [&](std::uint32_t f) { return !mesh_.face(f).is_removed; });
  write_surface(s, vertex, face);
  write_places(s, vertex, face);
  const auto count = [&](Fate f) {
    return static_cast<std::size_t>(std::ranges::count(vertices_, f, &Vertex::fate));
  };
  s.removed = number_removed_;
  s.blocked_by_border = count(Fate::blocked);
  s.not_flattened = count(Fate::failed);
  s.kept_by_bound = count(Fate::bound);
  s.newton_steps = counts_.newton_steps;
  s.most_newton_steps = most_newton_steps_;
  s.ptolemy_flips = counts_.ptolemy_flips;
  s.flips = counts_.flips;
  find_stretch(s, mesh_, fine_.scale_exponent);
  return s;
}

Simplification simplify(const Fine_surface& fine, const Simplify_options& options,
                        Asked_cost& cost) {
  expect_range(options);
  Simplifier simplifier(fine, {}, options, cost);
  simplifier.run(wanted_vertices(options, simplifier.number_left()));
  return simplifier.take_result();
}

std::vector<Simplification> hierarchy(const Fine_surface& fine, std::size_t levels, double ratio,
                                      const Simplify_options& options, Asked_cost& cost) {
  expect_range(options);
  if (!(ratio > 0 && ratio < 1))
    throw Invalid_input(Element_kind::none, 0,
                        "the ratio of the vertices of two levels is above 0 and below 1, not " +
                            std::to_string(ratio));
  std::vector<Simplification> result;
  Simplifier simplifier(fine, {}, options, cost);
  while (result.size() < levels) {
    const std::size_t before = simplifier.number_left();
    simplifier.run(part_of(ratio, before));
    if (simplifier.number_left() == before) break;
    result.push_back(simplifier.take_result());
    if (result.back().status != Status::done) break;
  }
  return result;
}

Simplification remove_vertices(const Fine_surface& fine, const std::vector<char>& may_go,
                               const Simplify_options& options) {
  expect_range(options);
  Asked_cost_of<Stretch_cost> cost({});
  Simplifier simplifier(fine, may_go, options, cost);
  const bool is_bounded = options.vertices || options.part;
  simplifier.run(is_bounded ? wanted_vertices(options, simplifier.number_left()) : 0);
  Simplification s = simplifier.take_result();
  if (s.status == Status::stalled && !is_bounded &&
      s.blocked_by_border + s.not_flattened + s.kept_by_bound == 0)
    s.status = Status::done; // all are gone that may go
  return s;
}

} // namespace CGAL::Intrinsic_triangulations::internal
