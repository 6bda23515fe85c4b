// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_CONFORMAL_MAPS_UNIFORMIZE_H
#define CGAL_INTRINSIC_CONFORMAL_MAPS_UNIFORMIZE_H

#include <CGAL/Intrinsic_conformal/angles/Prescribed_angles.h>
#include <CGAL/Intrinsic_conformal/angles/flat_angles.h>
#include <CGAL/Intrinsic_conformal/angles/ideal_start.h>
#include <CGAL/Intrinsic_conformal/layout/conformal_sphere.h>
#include <CGAL/Intrinsic_conformal/layout/flat_torus.h>
#include <CGAL/Intrinsic_conformal/layout/lay_out_scaled.h>
#include <CGAL/Intrinsic_conformal/metric/conformal_metric.h>
#include <CGAL/Intrinsic_conformal/metric/flat_surface.h>
#include <CGAL/Intrinsic_conformal/metric/hyperbolic_metric.h>
#include <CGAL/Intrinsic_geodesics/cuts/cut_to_disk.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/topology.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_ideal_hyperbolic_traits.h>
#include <CGAL/Intrinsic_triangulations/metric/Ideal_hyperbolic_traits.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/delaunay_triangulation.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/triangulation/common_mistakes.h>

#include <complex>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

/*!
\file
The whole way from a surface to a discrete conformal map: closes it, chooses what it becomes, finds
the scale factors, and lays it out.
*/

namespace CGAL::Intrinsic_triangulations {

/// What a surface becomes.
enum class Uniform_target : std::uint8_t {
  automatic, ///< what the surface allows without cones; `plane` with cones or other angles
  plane,     ///< a flat surface, with cones
  sphere,    ///< the unit sphere
  torus,     ///< a flat torus: the plane modulo two translations
  disk       ///< a part of Poincaré's disk: a hyperbolic surface
};

/// Which triangles are scaled.
enum class Uniform_start : std::uint8_t {
  automatic, ///< `input` if vertices were inserted, else `delaunay`
  delaunay,  ///< those of the triangulation as it is: the Delaunay one
  input      ///< those of the mesh
};

/// What `uniformize()` is asked for.
struct Uniformize_options {
  Uniform_target target = Uniform_target::automatic; ///< what the surface becomes
  Uniform_start start = Uniform_start::automatic;    ///< which triangles are scaled
  std::optional<std::size_t> cones;                  ///< see `place_cones()`
  std::optional<double> scale_ratio;                 ///< see `place_cones_within()`
  /// Changes the angles: full turns, and at the border free ones, or straight ones in the disk.
  std::function<void(Prescribed_angles&)> prescribe;
  bool is_laid_out = true; ///< whether a layout is wanted
  /// Is called after each step, and returns whether to go on.
  std::function<bool(const Conformal_progress&)> progress;
  /// Is called before the layout with the number of places where edges cross; pieces are as many.
  std::function<void(std::uint64_t)> before_layout;
};

/// What `uniformize()` has found.
struct Uniformization {
  Uniform_target target = Uniform_target::plane; ///< what the surface has become
  Uniform_start start = Uniform_start::delaunay; ///< which triangles were scaled
  /// That of the metric; `inaccurate` if it was found, but rounding has turned over pieces of the
  /// layout or faces on the sphere. A sphere that is not convex has `stalled`.
  Status status = Status::done;
  Conformal_metric metric;           ///< of a sphere, that of the plane which is projected to it
  std::vector<double> u;             ///< by row; on a sphere for the chords there
  std::vector<double> scale_factors; ///< exp(u/2), see `Conformal_metric`
  Prescribed_angles angles;          ///< by row; of a sphere none
  std::optional<Conformal_sphere> sphere{};     ///< of a sphere
  std::optional<std::complex<double>> period{}; ///< of a torus
  std::optional<Scaled_layout> layout{};        ///< none of a sphere
  std::string no_layout;                        ///< why there is no layout, if it was asked for

  /// returns the rows of vertices with prescribed angles that are no full turns.
  std::vector<std::uint32_t> cones() const;
};

/*!
\brief returns the double of a surface with border: two copies, glued along it, with the user's
vertices; of a cover the tufted cover of the triangles below it.
\param surface the surface
\throws Invalid_input if it is the cover of a cloud of points
\complexity linear
*/
Intrinsic_input closed_double(const Input& surface);

/// checks that a surface, or the front of a double, consists of disks. \throws Invalid_input naming
/// what it has in place of that
void expect_disks(const Input& surface);

/// returns the triangles of a surface, with the user's vertices at their corners; of a double those
/// of the front. \throws Invalid_input if the surface is a cover but not a double
Gluing front_of(const Input& surface);

namespace internal {

/// What is known of a triangulation.
struct Choice_facts {
  std::size_t components = 0;
  std::ptrdiff_t euler_characteristic = 0; ///< without isolated vertices
  std::uint32_t sheets = 1;
  bool has_inserted = false;
  bool has_border = false;
};
template <IndexedTriangulation Triangulation>
Choice_facts choice_facts(const Triangulation& t) {
  Choice_facts facts;
  facts.components = connected_components(t.mesh()).count;
  facts.euler_characteristic = euler_characteristic(t.mesh());
  for (const std::uint32_t n : umbrellas(t.mesh()))
    if (n == 0) --facts.euler_characteristic;
  facts.sheets = t.input().names().sheets;
  facts.has_inserted = t.number_of_vertices() > t.input().number_of_rows();
  facts.has_border = !boundary_loops(t.mesh()).empty();
  return facts;
}

// Replaces automatic choices. \throws Invalid_input if choices contradict each other or the surface
void choose(Uniformize_options& options, const Choice_facts& facts);

// \throws Invalid_input if vertices fall together
void take_sphere(Uniformization& result, Conformal_sphere sphere, std::vector<double> u);

// Calls `lay_out`, and keeps the reason if there is no layout: triangles that degenerate after a
// solver has stopped, or a surface without front.
void try_to_lay_out(Uniformization& result, const std::function<void()>& lay_out);

// Nonzero for each face that is as high as the rounding of its points.
std::vector<char> faces_without_area(const Input& surface);

// Why a surface has no front that could be laid out; empty: it has.
std::string why_no_front(const Input& surface);

template <class Ideal>
Prescribed_angles angles_for(Ideal& ideal, const Uniformize_options& options) {
  Prescribed_angles angles = options.cones         ? place_cones(ideal, *options.cones)
                             : options.scale_ratio ? place_cones_within(ideal, *options.scale_ratio)
                                                   : flat_angles(ideal);
  if (options.target == Uniform_target::disk) // the border becomes geodesic
    for (std::size_t v = 0; v < angles.size(); ++v)
      if (angles.is_free(v)) angles.set(v, Multiple_of_pi{1, 1});
  if (options.prescribe) options.prescribe(angles);
  return angles;
}

// The number of places where edges of a triangulation cross those of its input.
template <class Triangulation>
std::uint64_t number_of_crossings(const Triangulation& t) {
  std::uint64_t number = 0;
  for (const auto e : edges(t.mesh()))
    number +=
        static_cast<std::uint64_t>(crossings(t.correspondence().normal_coordinate(t.index(e))));
  return number;
}

struct Uniformize_visitor {
  const Uniformize_options& options;
  bool progress(const Conformal_progress& p) const {
    return !options.progress || options.progress(p);
  }
};

// \param start the ideal triangulation before
template <class Triangulation, class Ideal>
void lay_out(Uniformization& result, const Triangulation& t, const Ideal& ideal,
             Surface_to_cut start, const Uniformize_options& options) {
  const bool is_hyperbolic = result.target == Uniform_target::disk;
  std::optional<Flat_torus> torus;
  if (result.target == Uniform_target::torus) {
    torus = lay_out_torus(flat_surface(ideal), 8, result.metric.status == Status::done);
    result.period = torus->period;
  }
  if (!options.is_laid_out) return;
  result.no_layout = why_no_front(t.input());
  if (!result.no_layout.empty()) return;
  const bool starts_from_input = result.start == Uniform_start::input;
  if (options.before_layout)
    options.before_layout(number_of_crossings(ideal) +
                          (starts_from_input ? 0 : number_of_crossings(t)));
  Scaled_surface scaled = scaled_surface(ideal, std::move(start), result.scale_factors,
                                         result.angles, t.input().names(), is_hyperbolic);
  if (!starts_from_input) add_mesh(scaled, t, ideal);
  scaled.has_no_area = faces_without_area(t.input());
  result.layout = lay_out_scaled(scaled, torus ? &*torus : nullptr);
  result.status = result.layout->status(result.metric.status);
}

template <class Triangulation>
Uniformization uniformize_closed(const Triangulation& t, Uniformize_options options) {
  using Traits = std::conditional_t<Triangulation::Metric::is_exact, Exact_ideal_hyperbolic_traits,
                                    Ideal_hyperbolic_traits<double>>;
  using Ideal = Intrinsic_triangulation<Gluing_map, Traits, Integer_coordinates>;
  choose(options, choice_facts(t));
  Uniformization result;
  result.target = options.target;
  result.start = options.start;
  Ideal ideal(options.start == Uniform_start::input ? ideal_start(t.input()) : ideal_start(t));
  if (options.target == Uniform_target::sphere) {
    Conformal_sphere sphere = conformal_sphere(ideal);
    std::vector<double> u = logarithmic_scale(ideal, sphere.layout);
    take_sphere(result, std::move(sphere), std::move(u));
    return result;
  }
  Surface_to_cut start = flat_surface(ideal);
  result.angles = angles_for(ideal, options);
  Uniformize_visitor visitor{options};
  const auto np = parameters::visitor(std::ref(visitor));
  result.metric = options.target == Uniform_target::disk
                      ? hyperbolic_metric(ideal, result.angles, np)
                      : conformal_metric(ideal, result.angles, np);
  result.status = result.metric.status;
  result.u = result.metric.u;
  result.scale_factors = result.metric.scale_factors;
  if (result.status != Status::cancelled)
    try_to_lay_out(result, [&] { lay_out(result, t, ideal, std::move(start), options); });
  return result;
}

} // namespace internal

/*!
\brief maps a surface of any topology conformally to a flat or hyperbolic surface or to the sphere,
with scale factors at its vertices, and lays it out.

Surfaces with border are doubled first, see `closed_double()`. Then `conformal_metric()`,
`hyperbolic_metric()` or `conformal_sphere()` finds the scale factors, and `lay_out_scaled()` the
layout.
\tparam Triangulation an `Intrinsic_triangulation` of Euclid's metric with integer coordinates
\param t the triangulation, Delaunay unless you start from the triangles of the mesh
\param options what is asked for
\return the map, also if the solver has stalled: see its status
\throws Invalid_input as the functions above do, and if choices contradict each other
\complexity see those functions
*/
template <class Triangulation>
  requires QueriedTriangulation<Triangulation> && requires(const Triangulation& t) {
    t.correspondence().normal_coordinate(0U);
  }
Uniformization uniformize(const Triangulation& t, const Uniformize_options& options = {}) {
  if (boundary_loops(t.mesh()).empty()) return internal::uniformize_closed(t, options);
  Triangulation closed(closed_double(t.input()));
  flip_to_delaunay(closed);
  return internal::uniformize_closed(closed, options);
}

/// maps the Delaunay triangulation of a mesh, see there.
/// \tparam FaceGraph a model of `FaceListGraph` with a point map of its own, or `Triangle_soup`
template <class FaceGraph>
  requires internal::Surface_in_space<FaceGraph> Uniformization
  uniformize(const FaceGraph& mesh, const Uniformize_options& options = {}) {
    return uniformize(delaunay_triangulation(mesh), options);
  }

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_CONFORMAL_MAPS_UNIFORMIZE_H
