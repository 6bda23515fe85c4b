// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_GEODESICS_DISTANCE_PATH_TRACER_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_GEODESICS_DISTANCE_PATH_TRACER_IMPL_H

#include <CGAL/Intrinsic_triangulations/compilation.h>
#include <CGAL/Intrinsic_triangulations/geodesics/distance/Path_tracer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace CGAL::Intrinsic_triangulations::internal {

// The path comes to the vertex at a corner. Returns how it goes on.
CGAL_INTRINSIC_TRIANGULATIONS_INLINE Arrival Path_tracer::move_to(std::uint32_t corner,
                                                                  Plane_vector<double> departure) {
  places_.push_back({corner, {1, 0, 0}});
  departure_ = departure;
  return field_.vertices[vertex()].arrival;
}

// A straight piece, followed backwards, ends in the face of its ray: at a corner, or at a source.
CGAL_INTRINSIC_TRIANGULATIONS_INLINE void Path_tracer::end_at(const Ray& ray,
                                                              const Path_place& place) {
  places_.push_back(place);
  const Plane_vector<double> end = field_.turned_to(place.side, ray.end, ray.side),
                             begin = field_.point(place.side, place.weights).point;
  departure_ = {end.x - begin.x, end.y - begin.y};
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Status Path_tracer::trace(std::uint32_t v) {
  places_.clear();
  departure_ = {0, 0};
  const Arrival a = field_.vertices[v].arrival;
  std::uint32_t corner = table_.first_corner[v];
  if (a.kind == Arrival::Kind::straight) corner = Corner_table::previous(a.side);
  if (a.kind == Arrival::Kind::following) corner = Corner_table::next(a.side);
  if (a.kind == Arrival::Kind::leaving) corner = a.side;
  if (corner == Gluing::none) return Status::done; // isolated
  return follow(move_to(corner), {0, 0});
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE Status Path_tracer::trace(const Point_in_face& p) {
  places_ = {{p.side, p.weights}};
  departure_ = {0, 0};
  const Arrival a = field_.at(p).arrival;
  if (a.kind == Arrival::Kind::none) return Status::stalled;
  return follow(a, field_.turned_to(a.side, p.point, p.side));
}

// Goes on piece by piece; the first may come from a point in a face.
CGAL_INTRINSIC_TRIANGULATIONS_INLINE Status Path_tracer::follow(Arrival a,
                                                                Plane_vector<double> from) {
  bool is_at_vertex = places_.back().weights[0] == 1 && from.x == 0 && from.y == 0;
  while (places_.size() < most_places) {
    if (a.kind == Arrival::Kind::at_source) return Status::done;
    if (a.kind == Arrival::Kind::none) return Status::stalled;
    if (a.kind == Arrival::Kind::copied) {
      a = move_to(table_.first_corner[a.source]);
      is_at_vertex = true;
      continue;
    }
    if (a.kind == Arrival::Kind::following || a.kind == Arrival::Kind::leaving) {
      const Face_corner& back = table_.corners[Corner_table::next(a.side)];
      a = a.kind == Arrival::Kind::following
              ? move_to(a.side, {1, 0})
              : move_to(Corner_table::next(a.side), {back.cosine, back.sine});
      is_at_vertex = true;
      continue;
    }
    if (is_at_vertex) from = Window_face(table_, a.side).apex;
    Ray ray{a.side, from, from, a.image, a.source, 1e-12 * planar_distance(from, a.image)};
    Step step = start(ray);
    while (step == Step::crossed && places_.size() < most_places) step = cross(ray);
    if (step == Step::at_source) return Status::done;
    if (step == Step::lost) return Status::inaccurate;
    a = field_.vertices[vertex()].arrival;
    is_at_vertex = true;
  }
  return Status::cap;
}

// Whether the source is in the face of the ray; the path ends there, or goes on from a vertex.
CGAL_INTRINSIC_TRIANGULATIONS_INLINE bool Path_tracer::arrive(const Ray& ray, Step& step) {
  const auto vertices = static_cast<std::uint32_t>(field_.vertices.size());
  const double near = 1e3 * ray.tolerance + std::numeric_limits<double>::min();
  if (ray.source < vertices) {
    step = Step::at_vertex;
    return arrive_at_corner(ray);
  }
  const Point_in_face& source = field_.face_sources[ray.source - vertices];
  if (source.side / 3 != ray.side / 3) return false;
  const Plane_vector<double> place = field_.turned_to(ray.side, source.point, source.side);
  if (!(planar_distance(place, ray.image) <= near)) return false;
  step = Step::at_source;
  end_at(ray, {source.side, source.weights});
  return true;
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE bool Path_tracer::arrive_at_corner(const Ray& ray) {
  double nearest = 1e3 * ray.tolerance + std::numeric_limits<double>::min();
  std::uint32_t corner = Gluing::none;
  for (std::uint32_t c = ray.side - ray.side % 3, end = c + 3; c < end; ++c) {
    if (table_.corners[c].origin != ray.source) continue;
    const double distance = planar_distance(field_.turned_to(ray.side, {0, 0}, c), ray.image);
    if (distance <= nearest) {
      nearest = distance;
      corner = c;
    }
  }
  if (corner == Gluing::none) return false;
  end_at(ray, {corner, {1, 0, 0}});
  return true;
}

// Whether a ray passes a point as far as can be told.
CGAL_INTRINSIC_TRIANGULATIONS_INLINE bool Path_tracer::passes(const Ray& ray,
                                                              Plane_vector<double> p) const {
  const double x = ray.image.x - ray.from.x, y = ray.image.y - ray.from.y;
  const double off = x * (p.y - ray.from.y) - y * (p.x - ray.from.x);
  return std::abs(off) <= ray.tolerance * std::sqrt(x * x + y * y);
}

CGAL_INTRINSIC_TRIANGULATIONS_INLINE void Path_tracer::turn_to(Ray& ray, std::uint32_t side) const {
  ray.from = field_.turned_to(side, ray.from, ray.side);
  ray.end = field_.turned_to(side, ray.end, ray.side);
  ray.image = field_.turned_to(side, ray.image, ray.side);
  ray.side = side;
}

// The first step, from a point in the face or from the apex.
CGAL_INTRINSIC_TRIANGULATIONS_INLINE Path_tracer::Step Path_tracer::start(const Ray& ray) {
  Step step = Step::crossed;
  if (arrive(ray, step)) return step;
  const double length = table_.corners[ray.side].length;
  for (const bool at_target : {false, true}) {
    const Plane_vector<double> end{at_target ? length : 0, 0};
    if (!passes(ray, end) || planar_distance(end, ray.from) == 0) continue;
    end_at(ray, {at_target ? Corner_table::next(ray.side) : ray.side, {1, 0, 0}});
    return Step::at_vertex;
  }
  return Step::crossed;
}

// Crosses the side of a ray, and finds the side where it leaves the next face.
CGAL_INTRINSIC_TRIANGULATIONS_INLINE Path_tracer::Step Path_tracer::cross(Ray& ray) {
  const Face_corner& side = table_.corners[ray.side];
  const double down = ray.from.y - ray.image.y;
  if (side.opposite == Gluing::none || !(down > 0)) return Step::lost;
  // a source on the side itself is met there, at whatever angle
  const double part = -ray.image.y <= ray.tolerance ? 1 : ray.from.y / down;
  const double x = std::clamp(ray.from.x + (ray.image.x - ray.from.x) * part, 0.0, side.length);
  places_.push_back({ray.side, {1 - x / side.length, x / side.length, 0}});
  ray = {side.opposite,
         {side.length - x, 0},
         {side.length - ray.end.x, -ray.end.y},
         {side.length - ray.image.x, -ray.image.y},
         ray.source,
         ray.tolerance};
  Step step = Step::crossed;
  if (arrive(ray, step)) return step;
  const Plane_vector<double> apex = Window_face(table_, ray.side).apex;
  const std::uint32_t left = Corner_table::previous(ray.side);
  if (passes(ray, apex)) {
    end_at(ray, {left, {1, 0, 0}});
    return Step::at_vertex;
  }
  const double turn = (ray.image.x - ray.from.x) * apex.y - ray.image.y * (apex.x - ray.from.x);
  turn_to(ray, turn < 0 ? left
                        : Corner_table::next(ray.side)); // to the left of the apex or to its right
  return Step::crossed;
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_GEODESICS_DISTANCE_PATH_TRACER_IMPL_H
