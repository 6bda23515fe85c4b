// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_VECTORS_VECTORS_H
#define CGAL_INTRINSIC_OPERATORS_VECTORS_VECTORS_H

#include <CGAL/Intrinsic_operators/operators/Connection_graph.h>
#include <CGAL/Intrinsic_operators/vectors/Point_cloud_vectors.h>
#include <CGAL/Intrinsic_operators/vectors/Vector_heat_method.h>
#include <CGAL/Intrinsic_operators/vectors/Vector_options.h>
#include <CGAL/Intrinsic_operators/vectors/Vectors_on_sheets.h>
#include <CGAL/Intrinsic_operators/vectors/direction_field.h>
#include <CGAL/Intrinsic_operators/vectors/field_singularities.h>
#include <CGAL/Intrinsic_operators/vectors/logarithmic_map.h>
#include <CGAL/Intrinsic_operators/vectors/logarithms_from_place.h>
#include <CGAL/Intrinsic_operators/vectors/principal_directions.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Tangents_at_places.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/points_of_rows.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/CorrespondingTriangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/locate.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/support/defaults.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Vertex_copies.h>

#include <Eigen/Core>

#include <array>
#include <complex>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// The number of a point of a cloud.
std::size_t point_of_cloud(const Place& p);
// Given vectors in the tangent planes of points.
std::vector<std::pair<std::size_t, std::complex<double>>>
in_planes_of_points(const Point_cloud_vectors& cloud, const Given_vectors& given);

} // namespace internal

/*!
\brief finds vectors from places that a user names: transported ones, logarithmic maps, fields of
directions; on the surface of a cloud of points by its tangent planes, `Point_cloud_vectors`.

On a cover, a place stands for its points on all sheets, and each row gets the vector of one copy of
its vertex. Factored matrices of the flow of heat are kept from call to call, as long as its time
and, on clouds, the number of neighbours stay the same; fields of directions factor their own.
\tparam Triangulation a model of `CorrespondingTriangulation` and `MeasuredTriangulation`, Delaunay
*/
template <QueriedTriangulation Triangulation>
class Vectors {
public:
  /// Coordinates of a point.
  using Point = std::array<double, 3>;

  /// prepares calls.
  /// \param t the triangulation
  /// \param points where the user's vertices are, see `points_of()`, none of an abstract metric;
  ///   both must outlive this object unchanged
  Vectors(const Triangulation& t, const std::vector<Point>& points) : t_(t), points_(points) {}
  Vectors(const Triangulation&, std::vector<Point>&&) = delete; // they would end before
  Vectors(const Triangulation&&, const std::vector<Point>&) = delete;
  Vectors(const Vectors&) = delete;
  Vectors& operator=(const Vectors&) = delete;

  /// tells whether the surface is that of a cloud of points, each of which has one tangent plane.
  bool is_cloud() const { return t_.input().names().is_cloud(); }
  /// returns how logarithmic maps are found unless a user asks for another method: exactly, those
  /// of clouds by affine heat.
  Logarithm_method usual_method() const {
    return is_cloud() ? Logarithm_method::affine : Logarithm_method::exact;
  }

  /*!
  \brief transports vectors to all vertices, each from the nearest of the places.
  \pre one vector per place
  \throws Invalid_input if a place does not exist, or a vector has no direction there
  \throws std::invalid_argument see `Vector_heat_method`
  */
  Found_vectors transport(const Given_vectors& given, const Vector_options& options = {}) {
    if (is_cloud()) {
      const Point_cloud_vectors& c = cloud(options);
      return of_points(c.transport(internal::in_planes_of_points(c, given)));
    }
    const Heat* const method = heat(options, given.places.size() > 1, true); // else of one length
    if (method == nullptr) return cancelled();
    Finder find(t_, points_);
    Found_vectors found{find.sheets.averaged(given.are_at_vertices()
                                                 ? method->transport(find.at_vertices(given))
                                                 : method->transport(find.in_faces(given)))};
    if (rows_.empty() || !t_.input().names().row_of_vertex.empty())
      rows_ = Vertex_copies(t_).known_of_rows(found.vectors); // else of the only copies
    found.of_row = rows_;
    return found;
  }

  /*!
  \brief extends values at places to all vertices.
  \param places the places
  \param values a number for each
  \param options how
  \return a value per row; not a number where no path leads to a place; empty if cancelled
  \throws Invalid_input, std::invalid_argument as `transport()`
  */
  std::vector<double> extend(const std::vector<Place>& places, const std::vector<double>& values,
                             const Vector_options& options = {}) {
    std::vector<double> result(t_.number_of_vertices(), internal::unknown_vector.real());
    if (is_cloud()) {
      std::vector<std::pair<std::size_t, double>> sources;
      for (std::size_t i = 0; i < places.size(); ++i)
        sources.push_back({internal::point_of_cloud(places[i]), values.at(i)});
      const auto extended = cloud(options).extend_scalars(sources);
      for (std::size_t i = 0; i < extended.size(); ++i) result[i] = extended[i];
      return result;
    }
    const Heat* const method = heat(options, true, false);
    if (method == nullptr) return {};
    Place_finder<Triangulation> find(t_);
    std::vector<std::pair<Surface_point, double>> sources;
    for (std::size_t i = 0; i < places.size(); ++i)
      for (const Surface_point& p : find.points(places[i])) sources.push_back({p, values.at(i)});
    const Eigen::VectorXd extended = method->extend_scalars(sources);
    const auto first = Vertex_copies(t_).first_of_rows(); // all copies have one value
    for (std::size_t r = 0; r < first.size(); ++r)
      if (first[r] != Gluing::none) result[r] = extended[first[r]];
    return result;
  }

  /*!
  \brief finds the logarithmic map of a place: for each vertex the vector along the shortest path to
  it, as long as the path, in the frame that `logarithms_from_place()` describes.
  \param place the place
  \param method how; clouds of points have only `affine`
  \param options how
  \throws Invalid_input, std::invalid_argument as `transport()`, or if a cloud lacks the method, or
    the method has no use for the time or the distance of the options
  */
  Found_vectors logarithms(const Place& place, Logarithm_method method,
                           const Vector_options& options = {}) {
    if (method == Logarithm_method::exact && options.time_factor != defaults::time_factor)
      refuse("exact logarithmic maps follow shortest paths and need no time; leave out "
             "--time-factor, or take --method affine");
    if (method != Logarithm_method::exact && std::isfinite(options.maximum_distance))
      refuse("heat reaches all vertices at once; leave out --max-distance, or take --method exact");
    if (is_cloud()) {
      if (method != usual_method())
        refuse("logarithmic maps of points are found by affine heat; leave out --method, or give "
               "affine");
      return of_points(cloud(options).logarithmic_map(internal::point_of_cloud(place)));
    }
    using enum Logarithm_method;
    const Heat* const by_heat = method == exact ? nullptr : heat(options, method != polar, true);
    if (by_heat == nullptr && method != exact) return cancelled();
    Visitor visitor{&options, Vector_step::windows};
    Found_vectors found{logarithms_from_place(t_, place, method, [&](const auto& from) {
      if (by_heat != nullptr) return by_heat->logarithmic_map(from, method);
      return logarithmic_map(
          t_, from,
          parameters::maximum_distance(options.maximum_distance).visitor(std::ref(visitor)));
    })};
    if (!visitor.goes_on) return cancelled();
    found.of_row = Vertex_copies(t_).nearest_of_rows(found.vectors);
    return found;
  }

  /*!
  \brief finds the smoothest field of directions, or one that follows the directions of curvature.
  \param degree the number of equivalent directions at a vertex
  \param alignment how strongly the field follows curvature, see `aligned_direction_field()`; none:
    it does not. Only surfaces in space with faces have curvature, and the degree must be even
  \param fixed directions that are kept, at vertices
  \param options how
  \throws Invalid_input, std::invalid_argument as `transport()`, or if a direction is inside a
    face, or nothing can be aligned
  */
  Found_directions directions(int degree, const std::optional<double>& alignment = {},
                              const Given_vectors& fixed = {}, const Vector_options& options = {}) {
    if (alignment) expect_alignment(degree);
    Visitor visitor{&options, Vector_step::field};
    const auto np = parameters::visitor(std::ref(visitor));
    if (is_cloud()) {
      internal::expect_factor_for_cloud(options);
      const Point_cloud_vectors& c = cloud(options.neighbors);
      if (!visitor.progress(0U)) return {cancelled()};
      const Direction_field f =
          c.smoothest_direction_field(degree, internal::in_planes_of_points(c, fixed), np);
      if (f.status == Status::cancelled) return {cancelled()};
      return {of_points(f.directions())};
    }
    if (!fixed.are_at_vertices()) refuse("directions can be fixed at vertices only");
    Finder find(t_, points_);
    const auto kept = find.at_vertices(fixed);
    const Direction_field f =
        alignment ? aligned_direction_field(t_, degree, principal_directions(t_, points_),
                                            *alignment, kept, options.solver, np)
                  : smoothest_direction_field(t_, degree, kept, options.solver, np);
    if (f.status == Status::cancelled) return {cancelled()};
    const Field_singularities<Triangulation> singular = singularities(t_, f);
    Found_directions found{
        {find.sheets.averaged(f.directions(), degree, kept), Vertex_copies(t_).first_of_rows()},
        singular.index,
        centres(singular.index),
        singular.sum()};
    for (const auto& [h, turns] : singular.turns) found.border_turns += turns;
    return found;
  }

  /// returns the tangent planes of a cloud of points, inserted ones included; valid until a call
  /// with another number of neighbours or another time. \pre `is_cloud()`
  const Point_cloud_vectors& cloud(std::size_t neighbors) {
    Vector_options options;
    options.neighbors = neighbors;
    if (cloud_ && neighbors_ == neighbors) options.time_factor = time_factor_;
    return cloud(options);
  }

private:
  using Heat = Vector_heat_method<Triangulation>;
  using Vertex = typename Triangulation::vertex_descriptor;

  // Asks the caller whether to go on, with a number if the step counts.
  struct Visitor {
    const Vector_options* options;
    Vector_step step;
    bool goes_on = true;

    template <class Step, class... More>
    bool progress(const Step& s, const More&...) {
      std::uint64_t count = 0;
      if constexpr (std::integral<Step>) count = s;
      return goes_on = goes_on && (!options->progress || options->progress(step, count));
    }
  };

  // Finds given vectors on the triangulation, on a cover also those on the other sheet.
  struct Finder {
    Tangents_at_places<Triangulation> find;
    Vectors_on_sheets<Triangulation> sheets;

    Finder(const Triangulation& t, const std::vector<Point>& points) : find(t, points), sheets(t) {}

    Tangent_vector tangent(const Given_vectors& given, std::size_t i) {
      return given.in_planes.empty() ? find(given.places[i], given.in_space.at(i))
                                     : find(given.places[i], given.in_planes.at(i));
    }
    std::vector<std::pair<Vertex, std::complex<double>>> at_vertices(const Given_vectors& given) {
      std::vector<std::pair<Vertex, std::complex<double>>> result;
      for (std::size_t i = 0; i < given.places.size(); ++i) {
        const auto [v, z] =
            given.in_planes.empty()
                ? sheets.at_vertex(tangent(given, i))
                : std::pair(find.places().vertex(given.places[i].vertex), given.in_planes.at(i));
        const auto copies = sheets(v, z);
        result.insert(result.end(), copies.begin(), copies.end());
      }
      return result;
    }
    std::vector<Tangent_vector> in_faces(const Given_vectors& given) {
      std::vector<Tangent_vector> result;
      for (std::size_t i = 0; i < given.places.size(); ++i) {
        const auto copies = sheets(tangent(given, i));
        result.insert(result.end(), copies.begin(), copies.end());
      }
      return result;
    }
  };

  [[noreturn]] static void refuse(const char* message) {
    throw Invalid_input(Element_kind::none, 0, message);
  }
  void expect_alignment(int degree) const {
    if (is_cloud())
      refuse("--align needs curvature, which a cloud of points does not have; leave it out");
    if (points_.empty())
      refuse("a surface with lengths alone has no directions of curvature; leave --align out");
    if (degree % 2 != 0)
      refuse("--align needs an even --degree, such as 2 for lines: directions of curvature have no "
             "sign; give one");
  }

  static Found_vectors cancelled() { return {{}, {}, Status::cancelled}; }

  // The method with the matrices that are needed; null if the caller has ended the work.
  const Heat* heat(const Vector_options& options, bool of_functions, bool of_vectors) {
    if (heat_ && time_factor_ != options.time_factor) heat_.reset();
    if (!heat_) heat_.emplace(t_, parameters::time_factor(options.time_factor));
    time_factor_ = options.time_factor;
    Visitor visitor{&options, Vector_step::factorization};
    if (of_functions) heat_->factor(Transport_step::functions_factored);
    if (!visitor.progress(0U)) return nullptr;
    if (of_vectors) heat_->factor(Transport_step::vectors_factored);
    visitor.step = Vector_step::solution;
    return visitor.progress(0U) ? &*heat_ : nullptr;
  }
  const Point_cloud_vectors& cloud(const Vector_options& options) {
    if (neighbors_ != options.neighbors || time_factor_ != options.time_factor) cloud_.reset();
    if (!cloud_)
      cloud_.emplace(points_of_rows(t_, points_), options.neighbors, options.time_factor);
    neighbors_ = options.neighbors;
    time_factor_ = options.time_factor;
    return *cloud_;
  }

  // The vectors of a cloud, each of its own row.
  Found_vectors of_points(Tangent_field vectors) const {
    Found_vectors found{std::move(vectors)};
    found.vectors.resize(t_.number_of_vertices(), internal::unknown_vector);
    for (std::uint32_t r = 0; r < found.vectors.size(); ++r) found.of_row.push_back(r);
    return found;
  }

  // The centres of the faces with an index other than 0, with that.
  std::vector<std::pair<Surface_point, int>> centres(const std::vector<int>& index) const {
    std::vector<std::pair<Surface_point, int>> result;
    for (const auto f : faces(t_.mesh())) {
      const int i = index[t_.index(f)];
      if (i == 0) continue;
      const Surface_point centre{t_.numbers().halfedge(halfedge(f, t_.mesh())),
                                 {1. / 3, 1. / 3, 1. / 3}};
      if (const auto p = locate_on_input(t_, centre)) result.push_back({*p, i});
    }
    return result;
  }

  const Triangulation& t_;
  const std::vector<Point>& points_;
  std::optional<Heat> heat_;
  std::optional<Point_cloud_vectors> cloud_;
  std::vector<std::uint32_t> rows_; // the copy of the vertex of each that has a vector
  std::size_t neighbors_ = 0;       // of the cloud
  double time_factor_ = 0;          // of the method that is kept
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_VECTORS_VECTORS_H
