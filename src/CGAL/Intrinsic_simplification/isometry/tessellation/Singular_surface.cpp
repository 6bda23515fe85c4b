// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/isometry/Isometry_run.h>
#include <CGAL/Intrinsic_simplification/isometry/Square_root_field.h>
#include <CGAL/Intrinsic_simplification/isometry/lengths/Joined_numbers.h>
#include <CGAL/Intrinsic_simplification/isometry/tessellation/Doubled_surface.h>
#include <CGAL/Intrinsic_simplification/isometry/tessellation/Repartition.h>
#include <CGAL/Intrinsic_simplification/isometry/tessellation/Singular_surface.h>
#include <CGAL/Intrinsic_simplification/isometry/tessellation/remove_vertices.h>
#include <CGAL/Intrinsic_simplification/simplification/flat_vertices.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/locate.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_euclidean_traits.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

void flip_while_asked(Corresponding_triangulation& t, Isometry_run& run) {
  struct Visitor {
    Isometry_run* run;
    bool progress(const Flip_to_delaunay_result&) { return run->ask(); }
  };
  flip_to_delaunay(t, parameters::visitor(Visitor{&run}));
}

// Takes points through moves.
template <class Moves, class Before, class After>
void carry(std::vector<Surface_point>& points, const Gluing_map& mesh, std::size_t faces,
           const Moved_triangulation& t, const Moves& moves, const Before& before,
           const After& after) {
  if (moves.empty()) return;
  std::vector<std::vector<std::size_t>> in_face(faces);
  for (std::size_t i = 0; i < points.size(); ++i)
    in_face[mesh.face(Gluing_map::Halfedge{points[i].halfedge}).index].push_back(i);
  for (const Repartition& move : moves) {
    const auto is_empty = [&](const Moved_face& f) { return in_face[f.face].empty(); };
    if (std::all_of(before(move).begin(), before(move).end(), is_empty)) continue;
    const std::vector<Plane_face> to = t.lay_out(move, after(move));
    std::vector<std::pair<std::uint32_t, std::size_t>> moved;
    for (const Plane_face& f : t.lay_out(move, before(move))) {
      for (const std::size_t i : in_face[f.face]) {
        std::uint32_t face = 0;
        points[i] = point_at(to, f.place(points[i]), &face);
        moved.emplace_back(face, i);
      }
      in_face[f.face].clear();
    }
    for (const auto& [face, i] : moved) in_face[face].push_back(i);
  }
}

} // namespace

Corresponding_triangulation triangulation_of(std::shared_ptr<const Input> surface) {
  Exact_euclidean_metric metric(surface->mesh(), surface->metric());
  Gluing_map mesh = surface->mesh();
  return {std::move(mesh), std::move(metric), std::move(surface)};
}

Singular_surface::Singular_surface(Corresponding_triangulation t, Tessellation_vertices vertices,
                                   Isometry_run& run)
    : input_(t.shared_input()),
      start_(std::make_unique<Corresponding_triangulation>(std::move(t))) {
  try {
    run.begin(Isometry_stage::flips);
    std::vector<char> are_removed(start_->mesh().number_of_vertices(), 0);
    if (vertices == Tessellation_vertices::not_flat) {
      are_removed = removable_vertices();
      expect_to_go_on();
      choose_vertices(are_removed);
    }
    make(are_removed, run);
  } catch (const Undecidable& e) {
    is_ended_ = run.is_ended();
    open_ = e.what();
    if (!moved_) moved_ = std::make_unique<Moved_triangulation>(*start_);
    ties_.assign(moved_->mesh().number_of_edges(), 0);
  }
  darts_.emplace(moved_->mesh(), ties_);
  if (is_ended_ || start_->metric().statistics().probable_zero == 0) return;
  open_ = "exact arithmetic took some values for zero without a proof";
}

std::shared_ptr<const Singular_surface>
Singular_surface::with_all_vertices(Isometry_run& run) const {
  const std::shared_ptr<const Input> copy = doubled_ ? doubled_->shared_surface() : nullptr;
  return std::make_shared<const Singular_surface>(copy ? triangulation_of(copy) : *start_,
                                                  Tessellation_vertices::all, run);
}

// Where vertices were inserted, these are in faces or on edges of the input.
std::vector<char> Singular_surface::removable_vertices() {
  const std::vector<char> is_flat = flat_vertices(*input_);
  if (Doubled_surface doubled(input_, is_flat); doubled.has_copies()) {
    input_ = doubled.input();
    start_ = std::make_unique<Corresponding_triangulation>(triangulation_of(input_));
    doubled_ = std::move(doubled);
  }
  std::vector<char> result(start_->mesh().number_of_vertices(), 1);
  for (std::uint32_t v = 0; v < result.size(); ++v) {
    const std::uint32_t own = doubled_ ? doubled_->on_surface(v) : v;
    if (own < is_flat.size() &&
        start_->mesh().halfedge(Gluing_map::Vertex{v}).index != Gluing::none)
      result[v] = is_flat[own];
  }
  return result;
}

void Singular_surface::make(const std::vector<char>& are_removed, Isometry_run& run) {
  constexpr std::uint32_t factor = 8; // how much longer flips may take than removals
  // Removals from the input take about a second for these.
  constexpr std::uint32_t most_vertices = 1U << 14U;
  const std::uint32_t vertices = surface().number_of_vertices();
  if (number_of_flat_vertices_ == 0) return make_from(Start::delaunay, are_removed, run);
  const bool has_many = number_of_flat_vertices_ >= vertices / factor;
  try {
    make_from(has_many ? Start::input : Start::delaunay, are_removed, run);
  } catch (const Undecidable&) {
    if (run.is_ended()) throw;
    return make_from(has_many ? Start::delaunay : Start::input, are_removed, run);
  }
  if (!has_many && vertices <= most_vertices && !have_chains()) try_input(are_removed, run);
}

void Singular_surface::try_input(const std::vector<char>& are_removed, Isometry_run& run) {
  // A move takes 40 to 90 microseconds. Meshes of CGAL's data set with a divided face took at most
  // 1.2 for each vertex, but a strip with 121 vertices took 1,712.
  const std::size_t most_moves =
      std::max<std::size_t>(4096, 2 * start_->mesh().number_of_vertices());
  std::unique_ptr<Corresponding_triangulation> start = std::move(start_);
  std::unique_ptr<Moved_triangulation> moved = std::move(moved_); // refers to the start
  std::vector<char> ties = ties_;
  try {
    make_from(Start::input, are_removed, run, most_moves);
  } catch (const Undecidable&) {
    moved_ = std::move(moved);
    start_ = std::move(start);
    ties_ = std::move(ties);
    if (run.is_ended()) throw;
  }
}

bool Singular_surface::have_chains() const {
  const Gluing_map& mesh = moved_->mesh();
  for (std::uint32_t e = 0; e < mesh.number_of_edges(); ++e) {
    expect_to_go_on();
    const Value_recipes::Id length = moved_->length(e);
    if (mesh.is_removed(Gluing_map::Halfedge{2 * e}) || ties_[e] != 0 || crosses_cylinder(e))
      continue;
    if (!moved_->recipes().is_length_of_edge(length) && !moved_->developed().chain(length))
      return false;
  }
  return true;
}

void Singular_surface::make_from(Start start, const std::vector<char>& are_removed,
                                 Isometry_run& run, std::size_t most_moves) {
  run.begin(Isometry_stage::flips);
  moved_.reset(); // it refers to the start
  if (start == Start::input)
    start_ = std::make_unique<Corresponding_triangulation>(triangulation_of(input_));
  else
    flip_while_asked(*start_, run);
  moved_ = std::make_unique<Moved_triangulation>(*start_);
  run.begin(Isometry_stage::flat_vertices);
  if (number_of_flat_vertices_ > 0) remove_vertices(*moved_, are_removed, start == Start::delaunay);
  if (start == Start::input) make_delaunay(*moved_, most_moves);
  run.begin(Isometry_stage::ties);
  find_ties();
}

// A component needs a vertex, and so does a loop of its border, which has one unless the component
// is a flat cylinder.
void Singular_surface::choose_vertices(std::vector<char>& are_removed) {
  const Gluing_map& mesh = start_->mesh();
  const std::vector<std::uint32_t> component = components_of_vertices(mesh);
  std::vector<char> has_vertex(are_removed.size(), 0), is_cylinder = has_vertex;
  for (std::uint32_t v = 0; v < are_removed.size(); ++v)
    if (are_removed[v] == 0) has_vertex[component[v]] = 1;
  for (const Gluing_map::Halfedge h : loops_without_corner(mesh, are_removed)) {
    are_removed[mesh.target(h).index] = 0;
    is_cylinder[component[mesh.target(h).index]] = 1;
  }
  for (std::uint32_t v = 0; v < are_removed.size(); ++v) {
    is_on_cylinder_.push_back(is_cylinder[component[v]]);
    if (mesh.halfedge(Gluing_map::Vertex{v}).index == Gluing::none) continue;
    if (std::exchange(has_vertex[component[v]], 1) == 0 && is_on_cylinder_[v] == 0) {
      are_removed[v] = 0;
      continuous_part_ = "translations of a flat torus";
    }
    if (v < surface().number_of_vertices() && are_removed[v] != 0) ++number_of_flat_vertices_;
  }
  if (!has_cylinder()) return;
  if (!continuous_part_.empty()) continuous_part_ += ", ";
  continuous_part_ += "rotations of a flat cylinder";
}

void Singular_surface::find_ties() {
  const Gluing_map& mesh = moved_->mesh();
  ties_.assign(mesh.number_of_edges(), 0);
  std::vector<std::uint32_t> moved;
  {
    const Corresponding_triangulation::Const_session session(*start_);
    for (std::uint32_t e = 0; e < ties_.size(); ++e) {
      const Gluing_map::Halfedge h{2 * e};
      if (mesh.is_removed(h) || !moved_->has_diamond(h) || is_on_cylinder(h)) continue;
      expect_to_go_on();
      if (moved_->is_original(mesh.face(h).index) &&
          moved_->is_original(mesh.face(Gluing_map::opposite(h)).index))
        ties_[e] = session.delaunay_sign(h) == ZERO ? 1 : 0;
      else
        moved.push_back(e);
    }
  }
  for (const std::uint32_t e : moved) {
    expect_to_go_on();
    const Sign s =
        moved_->sign(moved_->diamond(Gluing_map::Halfedge{2 * e}), Delaunay_expression());
    ties_[e] = s == ZERO ? 1 : 0;
  }
}

std::vector<char> Singular_surface::ties_within(double error) const {
  const Gluing_map& mesh = moved_->mesh();
  std::vector<char> result = ties_;
  // polygons stay disks: an edge is left out only between two of them
  Joined_numbers polygon(mesh.number_of_faces());
  const auto join = [&](Gluing_map::Halfedge h) {
    return polygon.join(mesh.face(h).index, mesh.face(Gluing_map::opposite(h)).index);
  };
  for (std::uint32_t e = 0; e < result.size(); ++e)
    if (result[e] != 0) join(Gluing_map::Halfedge{2 * e});
  for (std::uint32_t e = 0; e < result.size(); ++e) {
    const Gluing_map::Halfedge h{2 * e};
    if (result[e] != 0 || mesh.is_removed(h) || !moved_->has_diamond(h) || is_on_cylinder(h))
      continue;
    const Diamond_values<double> d = moved_->approximate(h);
    const double size = std::abs(left_cotangent_numerator(d)) * d.area_g +
                        std::abs(right_cotangent_numerator(d)) * d.area_f + d.area_f * d.area_g;
    if (std::abs(Delaunay_expression()(d)) <= error * size && join(h)) result[e] = 1;
  }
  return result;
}

std::uint32_t Singular_surface::border_of_cylinder(std::uint32_t halfedge) const {
  using Halfedge = Gluing_map::Halfedge;
  const Gluing_map& mesh = moved_->mesh();
  const auto on_border = [&](Halfedge h) {
    while (crosses_cylinder(h.index / 2)) h = mesh.next(h);
    return h;
  };
  const Halfedge own = on_border(Halfedge{halfedge});
  return std::min(own.index, on_border(Gluing_map::opposite(mesh.next(own))).index);
}

std::vector<Surface_point>
Singular_surface::from_surface(std::span<const Surface_point> points) const {
  std::vector<Surface_point> result;
  for (const Surface_point& p : points)
    result.push_back(
        locate_on_intrinsic(*start_, doubled_ ? doubled_->from_surface(p) : p).value());
  carry(
      result, start_->mesh(), start_->mesh().number_of_faces(), *moved_, moved_->moves(),
      [](const Repartition& m) -> const auto& { return m.before; },
      [](const Repartition& m) -> const auto& { return m.after; });
  return result;
}

std::vector<Surface_point>
Singular_surface::to_surface(std::span<const Surface_point> points) const {
  std::vector<Surface_point> result(points.begin(), points.end());
  struct Backwards { // clang 14 cannot reverse a span
    std::span<const Repartition> moves;
    bool empty() const { return moves.empty(); }
    auto begin() const { return moves.rbegin(); }
    auto end() const { return moves.rend(); }
  };
  const Backwards back{moved_->moves()};
  carry(
      result, moved_->mesh(), start_->mesh().number_of_faces(), *moved_, back,
      [](const Repartition& m) -> const auto& { return m.after; },
      [](const Repartition& m) -> const auto& { return m.before; });
  for (Surface_point& p : result) {
    p = locate_on_input(*start_, p).value();
    if (doubled_) p = doubled_->on_surface(p);
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal
