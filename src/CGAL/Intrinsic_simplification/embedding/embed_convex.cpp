// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/embedding/Embedding_run.h>
#include <CGAL/Intrinsic_simplification/embedding/Metric_triangles.h>
#include <CGAL/Intrinsic_simplification/embedding/Polyhedron_points.h>
#include <CGAL/Intrinsic_simplification/embedding/Precise_points.h>
#include <CGAL/Intrinsic_simplification/embedding/Pyramids.h>
#include <CGAL/Intrinsic_simplification/embedding/Whole_faces.h>
#include <CGAL/Intrinsic_simplification/embedding/decrease_curvatures.h>
#include <CGAL/Intrinsic_simplification/embedding/doubly_covered_polygon.h>
#include <CGAL/Intrinsic_simplification/embedding/embed_convex.h>
#include <CGAL/Intrinsic_simplification/embedding/remove_flat.h>
#include <CGAL/Intrinsic_simplification/simplification/flat_vertices.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/as_gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/topology.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Double_double.h>
#include <CGAL/Intrinsic_triangulations/input/Element_names.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/input/initial_values.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/support/ranges.h>

#include <CGAL/double.h>
#include <CGAL/number_utils.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

namespace {

void expect_sphere(const Input& surface) {
  const auto refuse = [](const std::string& what) {
    throw Invalid_input(Element_kind::none, 0,
                        "only spheres are surfaces of convex polyhedra, and the surface " + what);
  };
  const Gluing_map& mesh = surface.mesh();
  if (!boundary_loops(mesh).empty())
    refuse("has a border; glue two copies along it: --domain closed");
  if (!is_orientable(mesh)) refuse("is not orientable");
  if (connected_components(mesh).count != 1) refuse("has several components; split it");
  const std::vector<std::uint32_t> number = umbrellas(mesh);
  for (std::uint32_t v = 0; v < number.size(); ++v)
    if (number[v] != 1)
      throw Invalid_input::about(Element_kind::vertex, surface.names().row(v),
                                 number[v] == 0 ? " has no face; remove it"
                                                : " joins parts of the surface; split it");
  if (genus(mesh) != 0) refuse("has handles");
  // two copies that are glued along a border share its vertices
  const Input_names& names = surface.names();
  const std::uint32_t n = surface.number_of_vertices();
  if (names.is_cover() && n == names.sheets * names.number_of_rows(n))
    refuse("covers a mesh that is one-sided");
}

// The triangles of the surface, with lengths between 1/2 and 1 at most.
// \param scale the coordinates are multiplied by two to this power
Metric_triangles triangles_of(const Input& surface, int& scale) {
  const Gluing_map& mesh = surface.mesh();
  std::vector<Double_double> squared = squared_lengths<Double_double>(surface.metric(), mesh);
  double most = 0;
  for (const Double_double& l : squared) most = std::max(most, l.to_double());
  scale = -std::ilogb(std::sqrt(most)) - 1;
  std::vector<Double_double> lengths;
  for (std::uint32_t f = 0; f < mesh.number_of_faces(); ++f)
    for (const Gluing_map::Halfedge h : mesh.sides({f}))
      lengths.push_back(squared[h.index / 2].scaled(std::ldexp(1., 2 * scale)));
  scale += surface.scale_exponent();
  return {gluing_from_map(mesh), std::move(lengths)};
}

// Up to which curvature each vertex is flat: as asked for, and as much as changes if lengths are
// rounded to doubles.
std::vector<double> flat_curvatures(const Metric_triangles& t, double asked) {
  std::vector<double> result(t.number_of_vertices(), asked);
  for (std::uint32_t h = 0; h < t.number_of_halfedges(); ++h) {
    const std::uint32_t n = Metric_triangles::next(h), p = Metric_triangles::next(n);
    const double area = 2 * t.length(h) * t.length(p) * t.sine(h); // four times
    const double sum =
        CGAL::square(t.length(h)) + CGAL::square(t.length(n)) + CGAL::square(t.length(p));
    if (area > 0) result[t.source(h)] += std::min(0x1p-52 * sum / area, 1e-6);
  }
  return result;
}

void expect_convex(const Input& surface, const Metric_triangles& t,
                   const std::vector<double>& flat) {
  const std::vector<double> curvature = t.curvatures();
  std::uint32_t v = 0;
  for (std::uint32_t w = 1; w < curvature.size(); ++w)
    if (curvature[w] + flat[w] < curvature[v] + flat[v]) v = w;
  if (curvature[v] >= -flat[v]) return;
  std::ostringstream excess;
  excess << -curvature[v] * 180 / std::numbers::pi;
  throw Invalid_input::about(
      Element_kind::vertex, surface.names().row(v),
      " has angles that sum to " + excess.str() +
          " degrees more than 360, the most on a convex polyhedron; change lengths there");
}

// Looks for the polyhedron while the curvatures of pyramids decrease.
class Polyhedron_search {
public:
  Polyhedron_search(const Metric_triangles& t, Convex_polyhedron& result, Embedding_run& run)
      : triangles(t), result_(result), run_(run) {}

  // Whether it is found. It is tried seldom: that takes longer than a step.
  bool try_at(const Glued_pyramids& p) {
    if (std::optional<Covered_polygon> polygon = doubly_covered_polygon(p)) {
      nearly_.emplace(p.triangles, std::move(*polygon));
      if (nearly_->second.difference <= 1e-14 * extent_of(nearly_->second.corners)) {
        take_polygon();
        return true;
      }
    }
    if (p.curvature_left > next_) return false;
    next_ = 1e-3 * p.curvature_left;
    return fit(p) == Fit::convex;
  }
  Fit fit(Glued_pyramids p) {
    constexpr double concave = 0x1p-80; // ties are within 2^-95, or so
    run_.begin(Embedding_stage::fit);
    close_pyramids(p, independent_directions(rounded(lay_out_pyramids(p))), run_);
    triangles = p.triangles;
    points = lay_out_pyramids(p);
    stretch_exponent = triangles.stretch_exponent();
    return fit_lengths(triangles, points, concave * extent_of(points), run_);
  }

  // Takes the polygon that the surface nearly is: a polyhedron whose height is in the rounding of
  // its lengths may not be found.
  // \return whether there is one
  bool take_polygon() {
    if (!nearly_) return false;
    triangles = nearly_->first;
    points = nearly_->second.corners;
    result_.shape = Convex_shape::doubly_covered_polygon;
    Convexity_certificate& c = result_.certificate;
    c.within = 0x1p-51 * extent_of(points);
    c.is_proven = change_to_polygon(nearly_->second.difference);
    c.convex_edges = points.size(); // the border
    c.flat_edges = 2 * points.size() - 6;
    return true;
  }

  Metric_triangles triangles;
  Precise_points points;       // none: nothing is found
  double stretch_exponent = 0; // from the surface to the polyhedron

private:
  // The back takes the lengths of the front. If they differ by d, the surface may be that of a
  // polyhedron with a height near the square root of d: so this counts as stretch, not as distance.
  // \return whether the faces still lie side by side
  bool change_to_polygon(double difference) {
    stretch_exponent = triangles.stretch_exponent();
    if (difference <= 0x1p-90 * extent_of(points)) return true; // rounding of 106 bits
    double least_height = extent_of(points);
    std::vector<Double_double> squared;
    for (std::uint32_t h = 0; h < triangles.number_of_halfedges(); ++h) {
      least_height = std::min(least_height, triangles.length(h) * triangles.sine(h));
      const auto &p = points[triangles.source(h)], &q = points[triangles.target(h)];
      const Double_double x = q[0] - p[0], y = q[1] - p[1];
      squared.push_back(x * x + y * y);
    }
    Metric_triangles flat = triangles;
    flat.change_lengths(squared);
    stretch_exponent = flat.stretch_exponent();
    return least_height > 2 * difference;
  }

  std::optional<std::pair<Metric_triangles, Covered_polygon>> nearly_;

  Convex_polyhedron& result_;
  Embedding_run& run_;
  double next_ = 1e-5; // of the curvature that is left
};

Polyhedron_search cancelled(Polyhedron_search search, Convex_polyhedron& result) {
  result.status = Status::cancelled;
  search.points.clear();
  return search;
}

Polyhedron_search find_points(const Metric_triangles& t, Embedding_run& run,
                              Convex_polyhedron& result) {
  Polyhedron_search search(t, result, run);
  Glued_pyramids p{t, {1, Vertex_weights(t.number_of_vertices())}, 1};
  result.status =
      decrease_curvatures(p, run, [&](const Glued_pyramids& now) { return search.try_at(now); });
  if (result.status == Status::stopped)
    result.status = Status::done;
  else if (result.status == Status::done)
    result.status = search.fit(p) == Fit::none ? Status::stalled : Status::done;
  if (run.is_cancelled()) return cancelled(std::move(search), result);
  if (result.status == Status::stalled && search.take_polygon()) result.status = Status::done;
  if (result.status != Status::done) search.points.clear();
  if (search.points.empty() || result.shape == Convex_shape::doubly_covered_polygon) return search;
  run.begin(Embedding_stage::certificate);
  result.certificate = certify_polyhedron(search.triangles, search.points, run);
  if (run.is_cancelled()) return cancelled(std::move(search), result);
  const Convexity_certificate& c = result.certificate;
  if (c.concave_edges != 0 || !c.encloses_its_centre) result.status = Status::inaccurate;
  return search;
}

void name_points(const Input& surface, const Whole_faces& whole, int scale,
                 Convex_polyhedron& result) {
  const Element_names& names = surface.names().vertices;
  result.points.resize(whole.points.size());
  for (std::uint32_t v = 0; v < whole.points.size(); ++v)
    for (std::size_t k = 0; k < 3; ++k)
      result.points[names.user(v)][k] =
          std::ldexp(whole.points[v][static_cast<Eigen::Index>(k)], -scale);
  for (const auto& [i, j, k] : whole.faces)
    result.faces.push_back({names.user(i), names.user(j), names.user(k)});
}

} // namespace

// Curvatures near 0, and edges that are far shorter than others, are what hinders the stages.
std::string remedy_of(Embedding_stage stage) {
  switch (stage) {
  case Embedding_stage::flat_vertices:
    return "lengths there are not those of a flat surface; lower flat_within, so that fewer "
           "vertices count as flat";
  case Embedding_stage::start:
    return "angles may sum to nearly 360 degrees; raise flat_within above the curvature of such "
           "vertices, or remove them; or edges may be too short for doubles beside others";
  case Embedding_stage::curvatures:
    return "some vertices may have hardly any curvature; raise flat_within, or remove them; or the "
           "surface may be a needle, or have edges too short beside others; join their ends";
  case Embedding_stage::fit:
  case Embedding_stage::certificate:
    break;
  }
  return "edges may be too short for doubles beside others; make them longer";
}

} // namespace internal

const char* name_of(Embedding_stage stage) {
  switch (stage) {
  case Embedding_stage::flat_vertices:
    return "removing flat vertices";
  case Embedding_stage::start:
    return "starting far away";
  case Embedding_stage::curvatures:
    return "decreasing curvatures";
  case Embedding_stage::fit:
    return "fitting lengths";
  case Embedding_stage::certificate:
    break;
  }
  return "proving convexity";
}

std::string reason_without_points(const Convex_polyhedron& found) {
  if (!found.points.empty()) return {};
  const std::string where = std::string("while ") + name_of(found.stage);
  if (found.status == Status::cancelled) return "the search for the polyhedron was ended " + where;
  if (found.status == Status::cap)
    return "the polyhedron is not found after " + std::to_string(found.steps) + " steps, " + where +
           "; raise flat_within, so that fewer vertices have hardly any curvature";
  return "the polyhedron is not found: the solver has stalled " + where + "; " +
         internal::remedy_of(found.stage);
}

Convex_polyhedron embed_convex(const Input& surface, const Embed_options& options) {
  using namespace internal;
  if (!ranges::flat_within.contains(options.flat_within))
    throw Invalid_input(Element_kind::none, 0,
                        "flat_within is " + shortest_text(options.flat_within) + "; give " +
                            ranges::flat_within.description() + ", in radians");
  expect_sphere(surface);
  int scale = 0;
  Metric_triangles t = triangles_of(surface, scale);
  const std::vector<char> is_flat = flat_vertices(surface);
  const std::vector<double> curvature = t.curvatures();
  std::vector<double> flat = flat_curvatures(t, options.flat_within);
  for (std::uint32_t v = 0; v < flat.size(); ++v)
    if (is_flat[v] != 0) flat[v] = std::max(flat[v], std::abs(curvature[v]));
  flip_to_convex(t, Vertex_weights(t.number_of_vertices())); // Delaunay: fewer loops
  expect_convex(surface, t, flat);
  Convex_polyhedron result;
  Embedding_run run(options, result);
  run.begin(Embedding_stage::flat_vertices);
  if (!remove_flat(t, flat, run)) {
    result.status = run.status();
    return result;
  }
  const std::vector<std::uint32_t> left = t.compress();
  const Polyhedron_search found = find_points(t, run, result);
  if (found.points.empty()) return result;
  const Space_points points = rounded(found.points);
  result.largest_error = greatest_error(found.triangles, points) / extent_of(points);
  Convexity_certificate& c = result.certificate;
  c.stretch = std::expm1(found.stretch_exponent) * (1 + 1e-7);
  c.is_proven = c.is_proven && std::isfinite(c.stretch);
  if (!std::isfinite(c.stretch)) result.status = Status::inaccurate;
  c.within = std::ldexp(c.within, -scale);
  for (const Removed_vertex& r : t.removed())
    result.flat_vertices.push_back(surface.names().vertices.user(r.vertex));
  std::sort(result.flat_vertices.begin(), result.flat_vertices.end());
  name_points(surface, put_back(found.triangles, points, left), scale, result);
  return result;
}

} // namespace CGAL::Intrinsic_triangulations
