// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/simplification/Star_removal.h>

#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <limits>
#include <numbers>
#include <optional>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

double direction_of(const Exact_point& p) { return std::atan2(p.y, p.x); }

// Values that begin at a side of a face, from those that begin at its first side.
Side_values begun_at(const Side_values& q, std::uint32_t h) {
  return {q[h % 3], q[(h + 1) % 3], q[(h + 2) % 3]};
}

} // namespace

// Points one after another around the centre. Each triangle turns to the left by proof, and all
// turn about the centre once, so that the polygon has no crossings.
bool Star_removal::lay_out(const Vertex_star& star) {
  points_.assign(1, {std::sqrt(star.spoke(0)), 0});
  for (std::size_t k = 0; k + 1 < star.number_of_spokes(); ++k) {
    const double a = star.spoke(k), b = star.spoke(k + 1), e = star.rim(k);
    const double c = (a + b - e) / (2 * a), s = quadruple_area_of(a, b, e) / (2 * a);
    const Exact_point p = points_.back();
    points_.push_back({c * p.x - s * p.y, s * p.x + c * p.y});
  }
  if (star.is_on_border()) points_.back() = {-std::sqrt(star.spoke(star.size())), 0};
  for (std::size_t k = 0; k < star.size(); ++k)
    if (!is_proven_left_turn(middle_of_star, points_[k], points_[(k + 1) % points_.size()]))
      return false;
  return true;
}

bool Star_removal::has_proven_lengths() const {
  return std::ranges::all_of(triangles_, [](const New_triangle& t) {
    return is_proven_triangle({t.sides[0].length, t.sides[1].length, t.sides[2].length});
  });
}

Plane_triangle Star_removal::old_triangle(std::size_t k) const {
  return {middle_of_star, points_[k], points_[(k + 1) % points_.size()]};
}

Plane_triangle Star_removal::new_triangle(const New_triangle& t) const {
  return {points_[t.corners[0]], points_[t.corners[1]], points_[t.corners[2]]};
}

// The side that certainly has the centre on its right; 3: none has.
std::uint32_t Star_removal::far_side(const New_triangle& t) const {
  for (std::uint32_t s = 0; s < 3; ++s)
    if (is_proven_left_turn(points_[t.corners[(s + 1) % 3]], points_[t.corners[s]], middle_of_star))
      return s;
  return 3;
}

void Star_removal::overlap(const Enclosed_form& above, const Enclosed_form& below) {
  overlapped_above_.push_back(&above);
  overlapped_below_.push_back(&below);
}

// A form about what bounds all of several. Pairs are joined in an order that does not depend on
// where a star begins: the result does, so that the surface would depend on its numbering.
template <Form (*Join)(const Form&, const Form&)>
Form Star_removal::join_all(std::vector<const Enclosed_form*>& forms) {
  if (forms.size() > 2)
    std::ranges::sort(forms, {}, [](const Enclosed_form* f) { return determinant(middle_of(*f)); });
  Form result = middle_of(*forms.front());
  for (std::size_t i = 1; i < forms.size(); ++i) result = Join(result, middle_of(*forms[i]));
  return result;
}

// Finds forms that bound those of all faces of the star that a new triangle overlaps. About the
// centre, the points of the rim are in the order of their numbers. So a triangle with the centre on
// the right of its side from p to q overlaps the faces from q to p, which are those under its other
// sides. Where those are new, too, the triangle behind has forms for all: so time is linear.
void Star_removal::find_overlapped(std::size_t number, const Vertex_star& star) {
  overlapped_above_.clear();
  overlapped_below_.clear();
  const New_triangle& t = triangles_[number];
  const std::uint32_t far = far_side(t);
  covers_.push_back(far >= 2 ? 1 : 0);
  const bool is_last = number + 1 == triangles_.size();
  const auto is_known = [&](std::uint32_t s) {
    const Rim_side& side = t.sides[s];
    return s == far || side.rim != Gluing::none ||
           (s < 2 || is_last ? covers_[side.triangle] != 0 : false);
  };
  if (is_known(0) && is_known(1) && is_known(2)) {
    for (std::uint32_t s = 0; s < 3; ++s) {
      const Rim_side& side = t.sides[s];
      if (s == far) continue;
      if (side.rim == Gluing::none)
        overlap(above_[side.triangle].matrix, below_[side.triangle].matrix);
      else if (side.rim < star.size())
        overlap(old_above_[side.rim], old_below_[side.rim]);
    }
    return;
  }
  const std::uint32_t to = far == 3 ? 0 : t.corners[far];
  std::uint32_t k = far == 3 ? 0 : t.corners[(far + 1) % 3];
  do {
    if (k < star.size()) overlap(old_above_[k], old_below_[k]);
    k = k + 1 == points_.size() ? 0 : k + 1;
  } while (k != to);
}

bool Star_removal::find_forms(const Coarse_mesh& mesh, const Vertex_star& star) {
  const Protect_FPU_rounding<true> up;
  old_above_.clear();
  old_below_.clear();
  above_.clear();
  below_.clear();
  covers_.clear();
  for (std::size_t k = 0; k < star.size(); ++k) {
    const Form_of_sides matrix(old_triangle(k));
    const Face_forms& f = mesh.forms(star.side(k) / 3);
    old_above_.push_back(matrix(begun_at(f.above, star.side(k))));
    old_below_.push_back(matrix(begun_at(f.below, star.side(k))));
  }
  for (std::size_t n = 0; n < triangles_.size(); ++n) {
    find_overlapped(n, star);
    const Measured_triangle triangle(new_triangle(triangles_[n]));
    const Form upper = join_all<join>(overlapped_above_), lower = join_all<meet>(overlapped_below_);
    const std::optional<Proven_form> above = proven_above(upper, triangle, overlapped_above_);
    if (!above) return false;
    above_.push_back(*above);
    below_.push_back(proven_below(lower, triangle, overlapped_below_));
  }
  return true;
}

void Star_removal::glue_sides(Coarse_mesh& mesh) {
  for (std::size_t i = 0; i < triangles_.size(); ++i)
    for (std::uint32_t k = 0; k < 3; ++k)
      if (triangles_[i].sides[k].rim == Gluing::none)
        mesh.glue(3 * new_faces_[i] + k, triangles_[i].sides[k].glued);
  for (std::size_t k = 0; k < outside_.size(); ++k)
    if (outside_[k] != Gluing::none) mesh.change_neighbour(outside_[k] / 3);
  for (std::size_t k = 0; k < outside_.size(); ++k) mesh.glue(side_of_rim_[k], outside_[k]);
}

void Star_removal::list_edges(std::vector<std::uint32_t>& sides) const {
  sides.clear();
  for (std::uint32_t i = 0; i < triangles_.size(); ++i)
    for (std::uint32_t k = 0; k < 3; ++k)
      if (const Rim_side& s = triangles_[i].sides[k]; s.rim != Gluing::none || s.triangle < i)
        sides.push_back(3 * new_faces_[i] + k);
}

// Finds the places of the points in the star, and takes its faces away.
void Star_removal::take_faces(Coarse_mesh& mesh, const Vertex_star& star, std::uint32_t v) {
  moving_.clear();
  places_.clear();
  near_.clear();
  for (std::size_t k = 0; k < star.size(); ++k) {
    const std::uint32_t f = star.side(k) / 3;
    mesh.change(f).is_removed = true;
    mesh.take_points(f, moving_);
    for (std::size_t n = places_.size(); n < moving_.size(); ++n) {
      places_.push_back(place_in(old_triangle(k), mesh.point(moving_[n]).weights, star.side(k)));
      near_.push_back(triangle_of_rim_[k]);
    }
  }
  moving_.push_back(v);
  places_.push_back(middle_of_star);
  near_.push_back(static_cast<std::uint32_t>(triangles_.size() - 1)); // the ears end about it
  replace_rim_in_outside(mesh, star);
}

// Rim edges that are glued to each other are sides of new triangles on both sides.
void Star_removal::replace_rim_in_outside(const Coarse_mesh& mesh, const Vertex_star& star) {
  rim_.clear();
  for (std::uint32_t& outside : outside_) {
    if (outside == Gluing::none || !mesh.face(outside / 3).is_removed) continue;
    if (rim_.empty()) {
      for (std::uint32_t k = 0; k < star.size(); ++k)
        rim_.emplace_back(Coarse_mesh::next(star.side(k)), k);
      std::ranges::sort(rim_);
    }
    const auto at = std::ranges::lower_bound(rim_, std::pair(outside, 0U));
    if (at != rim_.end() && at->first == outside) outside = side_of_rim_[at->second];
  }
}

// Where outgoing sides at the rim point in the plane, if they are in the star.
void Star_removal::find_directions(const Coarse_mesh& mesh, const Vertex_star& star) {
  const std::size_t n = points_.size();
  directions_.assign(n, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t k = 0; k < n; ++k) {
    const std::uint32_t old = mesh.outgoing(corners_[k]);
    const std::size_t before = (k + n - 1) % n;
    if (k < star.size() && old == Coarse_mesh::next(star.side(k)))
      directions_[k] = direction_of(minus(points_[(k + 1) % n], points_[k]));
    else if (before < star.size() && old == Coarse_mesh::previous(star.side(before)))
      directions_[k] = direction_of(minus(middle_of_star, points_[k]));
  }
}

// By what angles they have turned. A vertex that is several times on the rim may keep its angle.
void Star_removal::add_turns(Coarse_mesh& mesh) const {
  for (std::size_t i = 0; i < triangles_.size(); ++i)
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t p = triangles_[i].corners[k], q = triangles_[i].corners[(k + 1) % 3];
      if (std::isnan(directions_[p]) || mesh.outgoing(corners_[p]) != 3 * new_faces_[i] + k)
        continue;
      const double now = direction_of(minus(points_[q], points_[p]));
      mesh.add_turn(corners_[p], std::remainder(now - directions_[p], 2 * std::numbers::pi));
    }
}

void Star_removal::put_triangles(Coarse_mesh& mesh, std::uint32_t v) {
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    Coarse_face& f = mesh.change(new_faces_[i]);
    f.is_removed = false;
    f.kept_sides = 0;
    for (std::uint32_t k = 0; k < 3; ++k) {
      f.origin[k] = corners_[triangles_[i].corners[k]];
      f.length[k] = triangles_[i].sides[k].length;
      if (triangles_[i].sides[k].is_kept) mesh.keep_side(3 * new_faces_[i] + k);
    }
    mesh.change_forms(new_faces_[i]) = {above_[i].values, below_[i].values};
  }
  glue_sides(mesh);
  mesh.set_outgoing(v, Gluing::none);
  for (const std::uint32_t f : new_faces_)
    for (std::uint32_t h = 3 * f; h < 3 * f + 3; ++h) {
      const std::uint32_t p = mesh.origin(h), old = mesh.outgoing(p);
      if (mesh.glued(h) == Gluing::none || mesh.face(old / 3).is_removed || mesh.origin(old) != p)
        mesh.set_outgoing(p, h);
    }
}

void Star_removal::move_points(Coarse_mesh& mesh) {
  for (std::size_t n = 0; n < moving_.size(); ++n) {
    const Located found = locate(places_[n], near_[n]);
    mesh.put_point(moving_[n], new_faces_[found.triangle], found.weights);
  }
}

bool Star_removal::remove(Coarse_mesh& mesh, const Vertex_star& star, std::uint32_t v) {
  if (!lay_out(star)) return false;
  start_polygon(mesh, star);
  if (!cut_ears(star) || !has_proven_lengths() || !find_forms(mesh, star)) return false;
  if (mesh.tracks_turns()) find_directions(mesh, star);
  take_faces(mesh, star, v);
  put_triangles(mesh, v);
  if (mesh.tracks_turns()) add_turns(mesh);
  move_points(mesh);
  return true;
}

} // namespace CGAL::Intrinsic_triangulations::internal
