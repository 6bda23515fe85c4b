// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/simplification/Star_removal.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

constexpr Exact_point middle_of_star{0, 0};

double cross(const Exact_point& p, const Exact_point& q) { return p.x * q.y - p.y * q.x; }
double squared_norm(const Exact_point& p) { return p.x * p.x + p.y * p.y; }
Exact_point minus(const Exact_point& p, const Exact_point& q) { return {p.x - q.x, p.y - q.y}; }
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

void Star_removal::start_polygon(const Coarse_mesh& mesh, const Vertex_star& star) {
  for (auto* list : {&polygon_, &corners_, &outside_}) list->clear();
  polygon_sides_.clear();
  triangles_.clear();
  new_faces_.clear();
  for (std::uint32_t k = 0; k < points_.size(); ++k) {
    polygon_.push_back(k);
    if (k == star.size()) { // along the border
      polygon_sides_.push_back(
          {k, Gluing::none, Gluing::none, squared_norm(minus(points_[k], points_[0])), false});
      corners_.push_back(mesh.origin(Coarse_mesh::previous(star.side(k - 1))));
      outside_.push_back(Gluing::none);
    } else {
      const std::uint32_t h = Coarse_mesh::next(star.side(k));
      polygon_sides_.push_back({k, Gluing::none, mesh.glued(h), star.rim(k), mesh.is_kept_side(h)});
      corners_.push_back(mesh.origin(h));
      outside_.push_back(mesh.glued(h));
    }
  }
  side_of_rim_.assign(points_.size(), Gluing::none);
}

bool Star_removal::is_ear(std::size_t at) const {
  const std::size_t n = polygon_.size();
  const std::uint32_t a = polygon_[(at + n - 1) % n], b = polygon_[at], c = polygon_[(at + 1) % n];
  const auto turn = [&](std::uint32_t p, std::uint32_t q, std::uint32_t r) {
    return cross(minus(points_[q], points_[p]), minus(points_[r], points_[p]));
  };
  if (!is_proven_left_turn(points_[a], points_[b], points_[c])) return false;
  // about the centre, points are in order: only the tip is between the others
  if (is_proven_left_turn(points_[a], points_[c], middle_of_star)) return true;
  return std::ranges::none_of(polygon_, [&](std::uint32_t p) {
    return p != a && p != b && p != c && turn(a, b, p) >= 0 && turn(b, c, p) >= 0 &&
           turn(c, a, p) >= 0;
  });
}

// The power of the centre by the circle of an ear, times -1: the least one is a Delaunay triangle
// of the polygon of a Delaunay star (Devillers, On deletion in Delaunay triangulations, 1999).
double Star_removal::ear_rank(std::size_t at) const {
  const std::size_t n = polygon_.size();
  const Exact_point &a = points_[polygon_[(at + n - 1) % n]], &b = points_[polygon_[at]],
                    &c = points_[polygon_[(at + 1) % n]];
  const double area = cross(minus(b, a), minus(c, a));
  if (!(area > 0)) return std::numeric_limits<double>::infinity();
  return (squared_norm(a) * cross(b, c) - squared_norm(b) * cross(a, c) +
          squared_norm(c) * cross(a, b)) /
         area;
}

void Star_removal::cut_ear(std::size_t at, std::uint32_t face) {
  const std::size_t n = polygon_.size(), before = (at + n - 1) % n, after = (at + 1) % n;
  new_faces_.push_back(face);
  const Exact_point &a = points_[polygon_[before]], &c = points_[polygon_[after]];
  New_triangle t{{polygon_[before], polygon_[at], polygon_[after]},
                 {polygon_sides_[before], polygon_sides_[at], {}}};
  if (n == 3)
    t.sides[2] = polygon_sides_[after];
  else
    t.sides[2] = {Gluing::none, Gluing::none, Gluing::none, squared_norm(minus(a, c)), false};
  for (std::uint32_t k = 0; k < 3; ++k) {
    const Rim_side& s = t.sides[k];
    if (s.rim != Gluing::none)
      side_of_rim_[s.rim] = 3 * face + k;
    else if (s.triangle != Gluing::none) // comes before this one
      triangles_[s.triangle].sides[2].glued = 3 * face + k;
  }
  polygon_sides_[before] = {Gluing::none, static_cast<std::uint32_t>(triangles_.size()),
                            3 * face + 2, t.sides[2].length, false};
  triangles_.push_back(t);
  polygon_.erase(polygon_.begin() + static_cast<std::ptrdiff_t>(at));
  polygon_sides_.erase(polygon_sides_.begin() + static_cast<std::ptrdiff_t>(at));
}

bool Star_removal::cut_ears(const Vertex_star& star) {
  ranks_.clear();
  for (std::size_t at = 0; at < polygon_.size(); ++at) ranks_.push_back(ear_rank(at));
  while (polygon_.size() >= 3) {
    std::size_t best = polygon_.size();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t at = 0; at < polygon_.size(); ++at)
      if (ranks_[at] < least && is_ear(at)) {
        least = ranks_[at];
        best = at;
      }
    if (best == polygon_.size()) return false;
    cut_ear(best, star.side(triangles_.size()) / 3);
    ranks_.erase(ranks_.begin() + static_cast<std::ptrdiff_t>(best));
    if (polygon_.size() < 3) break;
    for (const std::size_t at :
         {best % polygon_.size(), (best + polygon_.size() - 1) % polygon_.size()})
      ranks_[at] = ear_rank(at);
  }
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
template <class Join>
Form Star_removal::join_all(std::vector<const Enclosed_form*>& forms, const Join& join) {
  if (forms.size() > 2)
    std::ranges::sort(forms, {}, [](const Enclosed_form* f) { return determinant(middle_of(*f)); });
  Form result = middle_of(*forms.front());
  for (std::size_t i = 1; i < forms.size(); ++i) result = join(result, middle_of(*forms[i]));
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
    const Form_of_sides<Interval> matrix(old_triangle(k));
    const Face_forms& f = mesh.forms(star.side(k) / 3);
    old_above_.push_back(matrix(begun_at(f.above, star.side(k))));
    old_below_.push_back(matrix(begun_at(f.below, star.side(k))));
  }
  for (std::size_t n = 0; n < triangles_.size(); ++n) {
    find_overlapped(n, star);
    const Measured_triangle triangle(new_triangle(triangles_[n]));
    const Form upper = join_all(overlapped_above_, join), lower = join_all(overlapped_below_, meet);
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

// Finds the places of the points in the star, and takes its faces away.
void Star_removal::take_faces(Coarse_mesh& mesh, const Vertex_star& star, std::uint32_t v) {
  moving_.clear();
  places_.clear();
  for (std::size_t k = 0; k < star.size(); ++k) {
    const std::uint32_t f = star.side(k) / 3;
    mesh.change(f).is_removed = true;
    mesh.take_points(f, moving_);
    for (std::size_t n = places_.size(); n < moving_.size(); ++n)
      places_.push_back(place_in(old_triangle(k), mesh.point(moving_[n]).weights, star.side(k)));
  }
  moving_.push_back(v);
  places_.push_back(middle_of_star);
  // rim edges that are glued to each other
  for (std::uint32_t& outside : outside_)
    for (std::size_t k = 0; k < star.size(); ++k)
      if (outside == Coarse_mesh::next(star.side(k))) {
        outside = side_of_rim_[k];
        break;
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
    std::array<double, 3> best{};
    double inside = -std::numeric_limits<double>::infinity();
    std::size_t to = 0;
    for (std::size_t i = 0; i < triangles_.size() && inside < 0; ++i) {
      const std::array<double, 3> w = weights_in(new_triangle(triangles_[i]), places_[n]);
      const double least = std::min({w[0], w[1], w[2]});
      if (least <= inside) continue;
      inside = least;
      best = w;
      to = i;
    }
    mesh.put_point(moving_[n], new_faces_[to], best);
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
