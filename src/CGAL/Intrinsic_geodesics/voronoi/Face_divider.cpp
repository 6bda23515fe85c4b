// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_geodesics/distance/Distance_field.h>
#include <CGAL/Intrinsic_geodesics/distance/Window.h>
#include <CGAL/Intrinsic_geodesics/voronoi/Face_divider.h>
#include <CGAL/Intrinsic_geodesics/voronoi/Weighted_site.h>
#include <CGAL/Intrinsic_geodesics/voronoi/cell_boundaries.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

// Parts are halved at least at every fourth step; below this depth rounding has hidden something.
constexpr unsigned most_cuts = 400;
// Faces with thousands of cells have fewer parts.
constexpr std::size_t most_parts = 1000000;

double length(Plane_point p) { return std::hypot(p.x, p.y); }
Plane_point left_of(Plane_point p) { return {-p.y, p.x}; }
Plane_point lerp(Plane_point p, Plane_point q, double t) { return (1 - t) * p + t * q; }

// The smallest box around a part with sides along an axis, and what follows from it.
struct Face_box {
  Plane_point axis;
  Plane_point least{std::numeric_limits<double>::infinity(),
                    std::numeric_limits<double>::infinity()}; // along the axis, and left of it
  Plane_point greatest{-least.x, -least.y};

  Face_box(const Face_part& part, Plane_point along) : axis(along) {
    for (const Part_corner& c : part) {
      const Plane_point p{dot(c.point, axis), dot(c.point, left_of(axis))};
      least = {std::min(least.x, p.x), std::min(least.y, p.y)};
      greatest = {std::max(greatest.x, p.x), std::max(greatest.y, p.y)};
    }
  }
  double diameter() const { return length(greatest - least); }
  Plane_point middle(double t = 0.5) const {
    const Plane_point p = lerp(least, greatest, t);
    return p.x * axis + p.y * left_of(axis);
  }
  // the direction in which it is longest
  Plane_point direction() const {
    const Plane_point d = greatest - least;
    return d.x >= d.y ? axis : left_of(axis);
  }
};

// The direction of the longest side, which does not depend on the side that is the first.
Plane_point longest_side(const Window_face& shape) {
  const Plane_point end{shape.base.length, 0};
  Plane_point longest = end;
  for (const Plane_point side : {shape.apex - end, -1 * shape.apex})
    if (length(side) > length(longest)) longest = side;
  const double size = length(longest);
  return size > 0 ? (1 / size) * longest : Plane_point{1, 0};
}

std::vector<std::size_t> changes_of(const Face_part& part) {
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < part.size(); ++i)
    if (part[i].node != Gluing::none) result.push_back(i);
  return result;
}

// Twice the area to the left of a polygon from corner p to corner q of a part, and on to a point.
double swept_area(const Face_part& part, std::size_t p, std::size_t q, Plane_point apex) {
  double sum = 0;
  for (std::size_t i = p, j; i != q; i = j) {
    j = i + 1 == part.size() ? 0 : i + 1;
    sum += cross(part[i].point - apex, part[j].point - apex);
  }
  return sum;
}

// The sites that may be the nearest of a point of a part: distances change by no more than points
// move. Those that see none of its corners on one side of a ray see nothing of it.
std::vector<Weighted_site> sites_near(const std::vector<Weighted_site>& sites,
                                      const Face_part& part) {
  const double share = 1 / static_cast<double>(part.size());
  Plane_point middle{0, 0}; // in the part: elsewhere sites see what is not the surface
  for (const Part_corner& c : part) middle = middle + share * c.point;
  double radius = 0;
  for (const Part_corner& c : part) radius = std::max(radius, length(c.point - middle));
  // by the triangle inequality, and a little for rounding
  const double most = least_distance(sites, middle) + 2.001 * radius;
  std::vector<Weighted_site> result;
  for (const Weighted_site& s : sites) {
    if (s.distance(middle) > most) continue;
    bool is_seen_from_begin = false, is_seen_from_end = false;
    for (const Part_corner& c : part) {
      const Plane_point in = s.inside(c.point);
      is_seen_from_begin = is_seen_from_begin || in.x >= 0;
      is_seen_from_end = is_seen_from_end || in.y >= 0;
    }
    if (is_seen_from_begin && is_seen_from_end) result.push_back(s);
  }
  return result;
}

// Where a line leaves a convex part, and comes in again: the corners before both.
struct Crossings {
  std::size_t number = 0;
  std::size_t out = 0, in = 0;
  std::vector<double> height; // of each corner to the left of the line

  Crossings(const Face_part& part, Plane_point point, Plane_point left) {
    for (const Part_corner& c : part) height.push_back(dot(c.point - point, left));
    for (std::size_t i = 0; i < part.size(); ++i) {
      const bool is_left = height[i] >= 0;
      if (is_left == (height[next(i)] >= 0)) continue;
      ++number;
      (is_left ? out : in) = i;
    }
  }
  std::size_t next(std::size_t i) const { return i + 1 == height.size() ? 0 : i + 1; }
  Plane_point at(const Face_part& part, std::size_t i) const {
    const double a = height[i], b = height[next(i)];
    return lerp(part[i].point, part[next(i)].point, a / (a - b));
  }
};

} // namespace

void Face_divider::divide(std::uint32_t face, const Face_part& whole) {
  face_ = face;
  const Window_face shape(table_, 3 * face);
  const double size = std::max({shape.base.length, shape.right.length, shape.left.length});
  constexpr double rounding = 1e-9; // no line is more certain, relative to the face
  tolerance_ = std::max(given_tolerance_, rounding * size);
  shortest_ = 1e-3 * tolerance_; // of pieces of lines: far below what is asked for
  parts_ = 0;
  axis_ = longest_side(shape);
  is_flat_ = !(shape.apex.y > rounding * size);
  std::vector<Plane_point> sources;
  const Distance_field& field = labelled_.field;
  for (const std::uint32_t s : field.sources_in_face(face)) {
    const Point_in_face& p = field.face_sources[s];
    sources.push_back(field.turned_to(3 * face, p.point, p.side));
  }
  divide(whole, sites_of_face(labelled_, face), std::move(sources), 0);
}

void Face_divider::divide(const Face_part& part, const Sites& all, std::vector<Plane_point> sources,
                          unsigned depth) {
  const std::vector<std::size_t> changes = changes_of(part);
  const Face_box box(part, axis_);
  const double diameter = box.diameter();
  const bool is_cap = depth >= most_cuts || ++parts_ > most_parts;
  const bool is_last = is_flat_ || is_cap || diameter <= tolerance_;
  if (is_cap && !changes.empty()) out_.is_complete = false;
  if (is_last) sources.clear();
  if (sources.empty() && changes.empty())
    return add_area(part.front().label, swept_area(part, 0, part.size() - 1, part[0].point) / 2);
  if (is_last && changes.size() != 2) return meet(part, changes);
  const Sites sites = sites_near(all, part);
  std::vector<Line> lines;
  // the middle; other lines if that one passes through a corner, or along a side
  for (const double t : {0.5, 0.45, 0.6, 0.3}) lines.push_back({box.middle(t), box.direction()});
  if (!sources.empty()) {
    lines.insert(lines.begin(), {sources.back(), box.direction()});
    sources.pop_back(); // it will be on the boundary
  } else if (changes.size() == 2) {
    const Part_corner &p = part[changes[0]], &q = part[changes[1]];
    const Plane_point along = q.point - p.point;
    if (is_last || length(along) <= 2 * tolerance_ || is_straight(part, sites, p, q))
      return join(part, changes[0], changes[1]);
    if (depth % 4 != 3) lines.insert(lines.begin(), {lerp(p.point, q.point, 0.5), along});
  }
  cut_and_divide(part, sites, sources, lines, depth);
}

// Divides both sides of the first line that cuts the part in two.
void Face_divider::cut_and_divide(const Face_part& part, const Sites& sites,
                                  const std::vector<Plane_point>& sources,
                                  const std::vector<Line>& lines, unsigned depth) {
  for (const Line& line : lines) {
    const Halves halves = cut(part, sites, line);
    if (!halves.is_cut) continue;
    std::vector<Plane_point> on_left, on_right;
    for (const Plane_point& p : sources)
      (dot(p - line.point, line.left) >= 0 ? on_left : on_right).push_back(p);
    divide(halves.left, sites, std::move(on_left), depth + 1);
    divide(halves.right, sites, std::move(on_right), depth + 1);
    return;
  }
  divide(part, sites, {}, most_cuts);
}

// Cuts a part in two. Along the cut, labels begin and end with those of the boundary there: so each
// change is on the boundaries of both halves, whatever rounding does.
Face_divider::Halves Face_divider::cut(const Face_part& part, const Sites& sites,
                                       const Line& line) {
  const Crossings c(part, line.point, line.left);
  if (c.number != 2) return {};
  const Plane_point from = c.at(part, c.out), to = c.at(part, c.in);
  std::uint32_t label = part[c.out].label;
  Face_part seam{{from, label}};
  const auto change_to = [&](std::uint32_t next, Plane_point p) {
    if (next != label) seam.push_back({p, next, out_.nodes++});
    label = next;
  };
  const double whole = length(to - from);
  double begin = 0;
  for (const Labelled_piece& piece : nearest_on_segment(sites, from, to, shortest_)) {
    if (piece.label != Gluing::none) change_to(piece.label, lerp(from, to, begin / whole));
    begin = piece.end;
  }
  change_to(part[c.in].label, to);
  Halves halves{true, {}, {}};
  // on the left: the seam, and the boundary from its end to its begin
  halves.left = seam;
  halves.left.push_back({to, part[c.in].label});
  for (std::size_t i = c.next(c.in); i != c.next(c.out); i = c.next(i))
    halves.left.push_back(part[i]);
  // on the right: the seam backwards, and the rest
  halves.right.push_back({to, label});
  for (std::size_t i = seam.size(); i-- > 1;) {
    halves.right.push_back(seam[i]);
    halves.right.back().label = seam[i - 1].label;
  }
  halves.right.push_back({from, part[c.out].label});
  for (std::size_t i = c.next(c.out); i != c.next(c.in); i = c.next(i))
    halves.right.push_back(part[i]);
  return halves;
}

// Whether the exact line between two changes is as near to the straight one as the tolerance.
bool Face_divider::is_straight(const Face_part& part, const Sites& sites, const Part_corner& p,
                               const Part_corner& q) const {
  const Plane_point left = (1 / length(q.point - p.point)) * left_of(q.point - p.point);
  for (const bool is_left : {true, false}) {
    const Plane_point out = is_left ? left : -1 * left;
    const Plane_point beside = p.point + tolerance_ * out;
    // the boundary of the part goes from p to q on the right
    const std::uint32_t label = is_left ? q.label : p.label;
    const Crossings c(part, beside, out);
    if (c.number == 0) continue;
    if (c.number != 2) return false;
    for (const Labelled_piece& piece :
         nearest_on_segment(sites, c.at(part, c.out), c.at(part, c.in), shortest_))
      if (piece.label != label) return false;
  }
  return true;
}

void Face_divider::join(const Face_part& part, std::size_t p, std::size_t q) {
  add_segment(part[p], part[q], part[q].label, part[p].label);
  add_area(part[p].label, swept_area(part, p, q, part[p].point) / 2);
  add_area(part[q].label, swept_area(part, q, p, part[p].point) / 2);
}

// Lines from all changes meet.
void Face_divider::meet(const Face_part& part, const std::vector<std::size_t>& changes) {
  Part_corner middle{{0, 0}, Gluing::none, out_.nodes++};
  const double share = 1 / static_cast<double>(changes.size());
  for (const std::size_t i : changes) middle.point = middle.point + share * part[i].point;
  Boundary_junction junction{middle.node, place(middle), {}};
  for (std::size_t k = 0; k < changes.size(); ++k) {
    const std::size_t i = changes[k], next = changes[k + 1 == changes.size() ? 0 : k + 1];
    const Part_corner& before = part[changes[(k == 0 ? changes.size() : k) - 1]];
    add_segment(part[i], middle, before.label, part[i].label);
    add_area(part[i].label, swept_area(part, i, next, middle.point) / 2);
    junction.sources.push_back(part[i].label);
  }
  out_.junctions.push_back(std::move(junction));
}

void Face_divider::add_segment(const Part_corner& from, const Part_corner& to, std::uint32_t left,
                               std::uint32_t right) {
  out_.segments.push_back({{from.node, to.node}, {place(from), place(to)}, left, right});
}

void Face_divider::add_area(std::uint32_t label, double area) {
  if (label != Gluing::none) out_.areas[label] += area;
}

Path_place Face_divider::place(const Part_corner& c) const {
  if (c.side != Gluing::none) return {c.side, {1 - c.parameter, c.parameter, 0}};
  const Window_face shape(table_, 3 * face_);
  std::array<double, 3> weights{0, 0, 0};
  if (shape.apex.y > 0) weights[2] = std::clamp(c.point.y / shape.apex.y, 0.0, 1.0);
  const double x = (c.point.x - weights[2] * shape.apex.x) / shape.base.length;
  weights[1] = std::clamp(x, 0.0, 1 - weights[2]);
  weights[0] = std::max(0.0, 1 - weights[1] - weights[2]);
  return {3 * face_, weights};
}

} // namespace CGAL::Intrinsic_triangulations::internal
