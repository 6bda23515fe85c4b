// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_geodesics/distance/Distance_field.h>
#include <CGAL/Intrinsic_geodesics/distance/Window.h>
#include <CGAL/Intrinsic_geodesics/voronoi/Weighted_site.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

// The site of a window in the frame of its side. As for distances of points, the interval is wider
// by what rounding may have lost.
Weighted_site site_of(const Labelled_field& labelled, const Stored_windows::Record& w,
                      double length) {
  const double tolerance = window_angle_tolerance * length;
  const Plane_point begin{Stored_windows::place(w.begin, length) - tolerance, 0},
      end{Stored_windows::place(w.end, length) + tolerance, 0};
  return {w.image, labelled.field.offset(w.source), labelled.label(w.source), begin - w.image,
          end - w.image};
}

// A site as a function on a segment.
struct Site_on_segment {
  double x;      // of the foot of the site, from the begin of the segment on
  double y;      // distance of the site from the line of the segment
  double weight; // of the site
  std::uint32_t label;
  double from, to; // the part of the segment that the site sees

  double distance(double t) const { return weight + std::hypot(t - x, y); }
};

Site_on_segment on_segment(const Weighted_site& site, Plane_point from, Plane_point to,
                           double length) {
  const Plane_point along = in_frame((1 / length) * (to - from), site.place - from);
  Site_on_segment result{along.x, std::abs(along.y), site.weight, site.label, 0, length};
  const Plane_point at_from = site.inside(from), at_to = site.inside(to);
  for (const std::size_t k : {0U, 1U}) {
    const double a = at_from[k], b = at_to[k];
    if (a < 0 && b < 0) result.to = -1;
    if (a < 0 && b >= 0) result.from = std::max(result.from, length * (a / (a - b)));
    if (b < 0 && a >= 0) result.to = std::min(result.to, length * (a / (a - b)));
  }
  return result;
}

// Improves a place where two sites are equally near by Newton's method.
double polished(const Site_on_segment& i, const Site_on_segment& j, double t) {
  for (unsigned k = 0; k < 2; ++k) {
    const double slope =
        (t - j.x) / std::hypot(t - j.x, j.y) - (t - i.x) / std::hypot(t - i.x, i.y);
    const double difference = j.distance(t) - i.distance(t), next = t - difference / slope;
    if (!(std::abs(j.distance(next) - i.distance(next)) < std::abs(difference))) break;
    t = next;
  }
  return t;
}

// Places where two sites may be equally near, at most two: roots of a quadratic equation, seen from
// the middle of an interval so that little cancels.
std::vector<double> ties(const Site_on_segment& i, const Site_on_segment& j, double middle) {
  const double xi = i.x - middle, xj = j.x - middle, d = i.weight - j.weight;
  // r_j^2 - r_i^2 - d^2 = 2 d r_i is linear on the left: slope t + height
  const double slope = 2 * (xi - xj);
  const double height = (xj - xi) * (xj + xi) + (j.y - i.y) * (j.y + i.y) - d * d;
  std::vector<double> result;
  const auto add = [&](double t) {
    if (std::isfinite(t)) result.push_back(polished(i, j, middle + t));
  };
  if (d == 0) {
    add(-height / slope);
    return result;
  }
  const double a = (slope - 2 * d) * (slope + 2 * d), b = slope * height + 4 * d * d * xi;
  const double r = 2 * d * std::hypot(xi, i.y), c = (height - r) * (height + r);
  const double q = -(b + std::copysign(std::sqrt(std::max(0.0, b * b - a * c)), b));
  add(q / a);
  add(c / q);
  return result;
}

// The least of functions on a segment, to which sites are added one after the other.
class Lower_envelope {
public:
  explicit Lower_envelope(double length) : pieces_{{length, nullptr}} {}

  void add(const Site_on_segment& j) {
    if (!(j.from < j.to) || !std::isfinite(j.weight)) return;
    next_.clear();
    double begin = 0;
    for (const Piece& piece : pieces_) {
      const double from = std::max(begin, j.from), to = std::min(piece.end, j.to);
      if (from < to) {
        if (begin < from) push(from, piece.site);
        compete(piece.site, j, from, to);
      }
      if (from >= to || to < piece.end) push(piece.end, piece.site);
      begin = piece.end;
    }
    std::swap(pieces_, next_);
  }

  // The parts with one label each; neighbours share those that are too short.
  std::vector<Labelled_piece> labels(double shortest) const {
    std::vector<Labelled_piece> all;
    for (const Piece& piece : pieces_)
      append({piece.end, piece.site == nullptr ? Gluing::none : piece.site->label}, all);
    std::vector<Labelled_piece> result;
    double begin = 0;
    for (const Labelled_piece& piece : all) {
      const bool is_short = piece.end - begin < shortest && all.size() > 1;
      begin = piece.end;
      if (!is_short)
        append(piece, result);
      else if (!result.empty())
        result.back().end = piece.end;
    }
    return result;
  }

private:
  struct Piece {
    double end;
    const Site_on_segment* site;
  };

  static void append(const Labelled_piece& piece, std::vector<Labelled_piece>& pieces) {
    if (!pieces.empty() && pieces.back().label == piece.label)
      pieces.back().end = piece.end;
    else
      pieces.push_back(piece);
  }

  void push(double end, const Site_on_segment* site) {
    if (!next_.empty() && next_.back().site == site)
      next_.back().end = end;
    else
      next_.push_back({end, site});
  }

  // On an interval, the new site wins where it is nearer by more than rounding.
  void compete(const Site_on_segment* i, const Site_on_segment& j, double from, double to) {
    if (i == nullptr) return push(to, &j);
    std::array<double, 4> places{from, to, to, to};
    std::size_t n = 1;
    for (const double t : ties(*i, j, (from + to) / 2))
      if (t > from && t < to) places[n++] = t;
    std::sort(places.begin(), places.begin() + n);
    for (std::size_t k = 0; k < n; ++k) {
      constexpr double least = 1 - window_distance_tolerance;
      const double middle = (places[k] + places[k + 1]) / 2;
      push(places[k + 1], j.distance(middle) < least * i->distance(middle) ? &j : i);
    }
  }

  std::vector<Piece> pieces_, next_;
};

} // namespace

std::vector<Weighted_site> sites_of_face(const Labelled_field& labelled, std::uint32_t face) {
  const Distance_field& field = labelled.field;
  std::vector<Weighted_site> result;
  const std::uint32_t first = 3 * face;
  const auto turned = [&](Plane_point p, std::uint32_t from) {
    return field.turned_to(first, p, from);
  };
  for (std::uint32_t side = first; side < first + 3; ++side) {
    const std::uint32_t v = field.table.corners[side].origin;
    const Plane_point corner = turned({0, 0}, side);
    result.push_back({corner, field.offset(v), labelled.label(v)});
    field.windows.for_each(side, [&](const Stored_windows::Record& w) {
      Weighted_site site = site_of(labelled, w, field.table.corners[side].length);
      const Plane_point begin = site.place + site.to_begin, end = site.place + site.to_end;
      site.place = turned(site.place, side);
      site.to_begin = turned(begin, side) - site.place;
      site.to_end = turned(end, side) - site.place;
      result.push_back(site);
    });
  }
  for (const std::uint32_t s : field.sources_in_face(face)) {
    const Point_in_face& p = field.face_sources[s];
    result.push_back({turned(p.point, p.side), 0, labelled.cell_of_source[field.origins[s]]});
  }
  return result;
}

std::vector<Weighted_site> sites_of_edge(const Labelled_field& labelled, std::uint32_t side) {
  const Distance_field& field = labelled.field;
  const Corner_table& table = field.table;
  const double length = table.corners[side].length;
  const std::uint32_t v = table.corners[side].origin,
                      w = table.corners[Corner_table::next(side)].origin;
  std::vector<Weighted_site> result{{{0, 0}, field.offset(v), labelled.label(v)},
                                    {{length, 0}, field.offset(w), labelled.label(w)}};
  field.windows.for_each(side, [&](const Stored_windows::Record& record) {
    result.push_back(site_of(labelled, record, length));
  });
  field.windows.for_each(table.corners[side].opposite, [&](const Stored_windows::Record& record) {
    Weighted_site site = site_of(labelled, record, length);
    site.place = {length - site.place.x, -site.place.y};
    site.to_begin = {-site.to_begin.x, -site.to_begin.y};
    site.to_end = {-site.to_end.x, -site.to_end.y};
    result.push_back(site);
  });
  return result;
}

double least_distance(std::span<const Weighted_site> sites, Plane_point p) {
  double least = std::numeric_limits<double>::infinity();
  for (const Weighted_site& s : sites)
    if (s.sees(p)) least = std::min(least, s.distance(p));
  return least;
}

std::vector<Labelled_piece> nearest_on_segment(std::span<const Weighted_site> sites,
                                               Plane_point from, Plane_point to, double shortest) {
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  if (!(length > 0)) return {{length, Gluing::none}};
  std::vector<Site_on_segment> functions;
  for (const Weighted_site& s : sites) functions.push_back(on_segment(s, from, to, length));
  Lower_envelope envelope(length);
  for (const Site_on_segment& f : functions) envelope.add(f);
  return envelope.labels(shortest);
}

} // namespace CGAL::Intrinsic_triangulations::internal
