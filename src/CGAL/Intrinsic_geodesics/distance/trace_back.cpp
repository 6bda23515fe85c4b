// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_geodesics/distance/Distance_field.h>
#include <CGAL/Intrinsic_geodesics/distance/Window.h>
#include <CGAL/Intrinsic_geodesics/distance/trace_back.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

// Follows a shortest path backwards.
class Path_tracer {
public:
  explicit Path_tracer(const Distance_field& field) : field_(field), table_(field.table) {}

  Status trace(std::uint32_t v, std::size_t pieces) {
    const Arrival& a = field_.vertices[v].arrival;
    const std::uint32_t corner =
        a.kind == Arrival::Kind::straight ? a.corner() : table_.first_corner[v];
    if (corner == Gluing::none) return Status::done; // isolated
    return follow(move_to(corner), {0, 0}, pieces);
  }
  Status trace(const Point_in_face& p) {
    places_ = {{p.side, p.weights}};
    const Arrival a = field_.at(p).arrival;
    if (a.kind == Arrival::Kind::none) return Status::stalled;
    return follow(a, field_.turned_to(a.side, p.point, p.side),
                  std::numeric_limits<std::size_t>::max());
  }

  // What was found by a call of `trace()`.
  Traced_back result(Status status) && { return {status, std::move(places_), departure_}; }

private:
  // A place of a straight line to the image of a source: both in the frame of a side, as the far
  // end of the line.
  struct Ray {
    std::uint32_t side;
    Plane_vector<double> from;
    Plane_vector<double> end;
    Plane_vector<double> image;
    std::uint32_t source;
    double tolerance;
  };
  enum class Step { crossed, at_vertex, at_source, lost };

  // Goes on piece by piece; the first may come from a point in a face.
  Status follow(Arrival a, Plane_vector<double> from, std::size_t pieces) {
    bool is_at_vertex = places_.back().weights[0] == 1 && from.x == 0 && from.y == 0;
    for (; places_.size() < most_places; is_at_vertex = true) {
      if (a.kind == Arrival::Kind::at_source || pieces-- == 0) return Status::done;
      if (a.kind == Arrival::Kind::none) return Status::stalled;
      if (a.kind == Arrival::Kind::copied) {
        a = move_to(table_.first_corner[a.source]);
        continue;
      }
      if (is_at_vertex) from = Window_face(table_, a.side).apex;
      const double rounding = 0x1p-50 * table_.corners[a.side].length;
      // 1e-12: each triangle that a window was unfolded through errs by about 2^-52, here 4,000
      Ray ray{a.side,  from,     from,
              a.image, a.source, 1e-12 * planar_distance(from, a.image) + rounding};
      Step step = start(ray);
      while (step == Step::crossed && places_.size() < most_places) step = cross_side(ray);
      if (step == Step::at_source) return Status::done;
      if (step == Step::lost) return Status::inaccurate;
      a = field_.vertices[vertex()].arrival;
    }
    return Status::cap;
  }

  std::uint32_t vertex() const { return table_.corners[places_.back().side].origin; }

  // The path comes to the vertex at a corner. Returns how it goes on.
  Arrival move_to(std::uint32_t corner) {
    places_.push_back({corner, {1, 0, 0}});
    departure_ = {0, 0};
    return field_.vertices[vertex()].arrival;
  }

  // A straight piece, followed backwards, ends in the face of its ray: at a corner, or at a source.
  void end_at(const Ray& ray, const Path_place& place) {
    places_.push_back(place);
    const Plane_vector<double> end = field_.turned_to(place.side, ray.end, ray.side),
                               begin = field_.point(place.side, place.weights).point;
    departure_ = end - begin;
  }

  // Whether the source is in the face of the ray; the path ends there, or goes on from a vertex.
  bool arrive(const Ray& ray, Step& step) {
    const auto vertices = static_cast<std::uint32_t>(field_.vertices.size());
    // Wide, as only the source of this window can be here: a path that misses it is inaccurate.
    const double near = 1e3 * ray.tolerance + 0x1p-50 * table_.corners[ray.side].length;
    if (Crossing::is_one(ray.source)) return false;
    if (ray.source < vertices) {
      step = Step::at_vertex;
      return arrive_at_corner(ray, near);
    }
    const Point_in_face& source = field_.face_sources[ray.source - vertices];
    if (source.side / 3 != ray.side / 3) return false;
    const Plane_vector<double> place = field_.turned_to(ray.side, source.point, source.side);
    if (!(planar_distance(place, ray.image) <= near)) return false;
    step = Step::at_source;
    end_at(ray, {source.side, source.weights});
    return true;
  }

  bool arrive_at_corner(const Ray& ray, double nearest) {
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

  // Whether a ray passes a point before its end, within rounding.
  static bool passes(const Ray& ray, Plane_vector<double> p) {
    const Plane_vector<double> along = ray.image - ray.from;
    const double length = std::sqrt(dot(along, along)), most = ray.tolerance * length;
    const double part = dot(along, p - ray.from);
    return std::abs(cross(along, p - ray.from)) <= most && part >= -most &&
           part <= length * length + most;
  }

  // The first step, from a point in the face or from the apex.
  Step start(const Ray& ray) {
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

  // Where several faces meet: finds the side that the path crossed before, and its source there.
  bool cross_branch(Ray& ray, std::uint32_t& back, bool& is_along) const {
    const std::vector<Branched_side::Other>& others = table_.branch(ray.side).others;
    auto other = others.begin();
    if (others.size() > 1) {
      if (!Crossing::is_one(ray.source)) return false;
      const Crossing& crossing = field_.crossings[ray.source - Crossing::first];
      if (crossing.to != ray.side) return false;
      other = std::ranges::find(others, crossing.from, &Branched_side::Other::side);
      ray.source = crossing.source;
    }
    back = other->side;
    is_along = other->is_along;
    return true;
  }

  // Crosses the side of a ray, and finds the side where it leaves the next face.
  Step cross_side(Ray& ray) {
    const Face_corner& side = table_.corners[ray.side];
    const double up = std::max(ray.from.y, 0.0), down = up - ray.image.y;
    if (side.opposite == Gluing::none || !(down > 0)) return Step::lost;
    std::uint32_t back = side.opposite;
    bool is_along = false;
    if (!side.has_one_neighbor() && !cross_branch(ray, back, is_along)) return Step::lost;
    // a source on the side itself is met there, at whatever angle
    const double part = -ray.image.y <= ray.tolerance ? 1 : up / down;
    const double x = std::clamp(ray.from.x + (ray.image.x - ray.from.x) * part, 0.0, side.length);
    places_.push_back({ray.side, {1 - x / side.length, x / side.length, 0}});
    const auto beyond = [&](Plane_vector<double> p) {
      return Plane_vector<double>{is_along ? p.x : side.length - p.x, -p.y};
    };
    ray = {back, beyond({x, 0}), beyond(ray.end), beyond(ray.image), ray.source, ray.tolerance};
    Step step = Step::crossed;
    if (arrive(ray, step)) return step;
    const Plane_vector<double> apex = Window_face(table_, ray.side).apex;
    const std::uint32_t left = Corner_table::previous(ray.side);
    if (passes(ray, apex)) {
      end_at(ray, {left, {1, 0, 0}});
      return Step::at_vertex;
    }
    const bool is_left = cross(ray.image - ray.from, apex - ray.from) < 0; // of the apex
    const std::uint32_t out = is_left ? left : Corner_table::next(ray.side);
    for (Plane_vector<double>* p : {&ray.from, &ray.end, &ray.image})
      *p = field_.turned_to(out, *p, ray.side);
    ray.side = out;
    return Step::crossed;
  }

  static constexpr std::size_t most_places = std::size_t{1} << 22U; // as in `Trace_options`

  const Distance_field& field_;
  const Corner_table& table_;
  std::vector<Path_place> places_;
  Plane_vector<double> departure_{0, 0};
};

} // namespace

Traced_back trace_back(const Distance_field& field, std::uint32_t v, std::size_t pieces) {
  Path_tracer tracer(field);
  const Status status = tracer.trace(v, pieces);
  return std::move(tracer).result(status);
}

Traced_back trace_back(const Distance_field& field, const Point_in_face& p) {
  Path_tracer tracer(field);
  const Status status = tracer.trace(p);
  return std::move(tracer).result(status);
}

} // namespace CGAL::Intrinsic_triangulations::internal
