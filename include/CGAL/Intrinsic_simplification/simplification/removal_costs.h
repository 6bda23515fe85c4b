// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_REMOVAL_COSTS_H
#define CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_REMOVAL_COSTS_H

#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/triangulation/common_mistakes.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>
#include <CGAL/Intrinsic_triangulations/triangulation/measures.h>

#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <complex>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

/*!
\file
Which vertices `simplify()` removes first: those whose removal costs least.
*/

/// \cond
// It refuses what is no cost, and a cost whose result is no number.
#define CGAL_INTRINSIC_TRIANGULATIONS_REFUSE_COST(function)                                        \
  CGAL_INTRINSIC_TRIANGULATIONS_MISTAKE(                                                           \
      "the cost of " #function "() is a functor that takes a Removal_candidate and returns a "     \
      "number, such as [](const Removal_candidate& c) { return c.area; }")
/// \endcond

namespace CGAL::Intrinsic_triangulations {

/// A vertex that could be removed next, as costs see it.
struct Removal_candidate {
  std::uint32_t vertex = 0; ///< the user's vertex
  /// The number of the vertex in the order of `vertices(t.mesh())`. On a cover each copy of a
  /// vertex has one.
  std::uint32_t number = 0;
  double curvature = 0;   ///< 2 pi, on the border pi, minus the angles at it now, in radians
  double area = 0;        ///< a third of the faces at it, now, in the units of the input
  double mean_length = 0; ///< of the edges at it, now
  /// The mean of the squared lengths of the edges at it, with the shares of `Removal_neighbor` as
  /// weights.
  double squared_length = 0;
  double stretch = 0; ///< how far the stretch is expected to spread there: a logarithm
};

/// The other end of an edge at a vertex that could be removed. Vectors are in polar coordinates of
/// vertices, which stay the same while other vertices are removed.
struct Removal_neighbor {
  std::uint32_t number = 0; ///< see `Removal_candidate`
  /// The part of the curvature of the candidate that it gets, to first order; their sum is 1.
  double share = 0;
  double length = 0;         ///< of the edge
  std::complex<double> turn; ///< takes vectors from the candidate to the neighbour: of modulus 1
  std::complex<double>
      back; ///< the vector from the neighbour to the candidate, as long as the edge
};

namespace internal {

// Whether a cost reads vectors between vertices.
template <class Cost>
constexpr bool needs_vectors() {
  if constexpr (requires { Cost::needs_vectors; })
    return Cost::needs_vectors;
  else
    return true;
}

// A cost that knows what was removed before.
template <class Cost>
concept Remembers_removals = requires(Cost& cost, const Removal_candidate& c,
                                      std::span<const Removal_neighbor> neighbors) {
  { CGAL::to_double(std::as_const(cost)(c, neighbors)) } -> std::convertible_to<double>;
  cost.remove(c, neighbors);
};

} // namespace internal

/*!
\brief requires what the removal of a vertex costs.

Syntax of \ref ::RemovalCost, where its meaning is described.
*/
template <class Cost>
concept RemovalCost = internal::Remembers_removals<Cost> ||
    requires(Cost& cost, const Removal_candidate& c) {
  { CGAL::to_double(cost(c)) } -> std::convertible_to<double>;
};

namespace internal {

// a functor in place of a cost, or with another result
template <class Cost>
concept Not_a_cost = !RemovalCost<Cost>;

} // namespace internal

/// removes vertices first that stretch the surface least, with what earlier removals did there.
/// \cgalModels{RemovalCost}
struct Stretch_cost {
  /// returns the stretch.
  double operator()(const Removal_candidate& c) const { return c.stretch; }
};

/*!
\brief removes vertices first from which mass moves least, with how far it has moved before: after
Liu, Gillespie, Chislett, Sharp, Jacobson and Crane (2023).

There are channels of mass. In each one, the mass of a vertex that is removed goes to its
neighbours, in the shares of its curvature. At each vertex, a tangent vector is the mean of the ways
back to where its mass was at first. The cost of a vertex is the sum over its neighbours and
channels of the mass that a neighbour would have then, times the length of its vector.
\cgalModels{RemovalCost}
*/
class Transported_mass {
public:
  /*!
  \brief adds two channels, with the positive and the negative values of a function.
  \param values a number for each vertex, in the order of `vertices(t.mesh())`
  \param weight the factor of the values
  \return this object
  */
  Transported_mass& add(const std::vector<double>& values, double weight = 1);

  /// returns the cost of a vertex.
  double operator()(const Removal_candidate& c, std::span<const Removal_neighbor> neighbors) const;
  /// moves the mass of a vertex to its neighbours.
  void remove(const Removal_candidate& c, std::span<const Removal_neighbor> neighbors);

private:
  // A mass, and the sum of the ways back of its parts, times them.
  struct Mass {
    double amount = 0;
    std::complex<double> moment;
  };
  static Mass sum(const Mass& here, const Mass& comes, const Removal_neighbor& to);

  std::vector<std::vector<Mass>> channels_; // by channels and vertices
};

/*!
\brief removes vertices first with which functions on the surface lose least, so that operators on
the coarse surface are accurate.

A function that is linear in triangles misses others by about their second derivatives times squared
lengths. So a vertex costs the mean of the squared lengths of its edges, times what it stands for:
its part of the area, which functions are weighted with, and its curvature as a part of a half turn,
which neighbours get. Both are those of the surface as it is now. Two factors keep the surface as
large as it was: the cube root of the stretch, and exp(-K / 4) where the curvature K is negative, as
a vertex with a large sum of angles becomes flat only by longer edges. With these exponents no error
is greater than by the program of Liu et al. on their six meshes, see the manual.
\cgalModels{RemovalCost}
*/
class Balanced_cost {
public:
  /// starts. \param area of the fine surface
  explicit Balanced_cost(double area) : area_(area) {}

  /// returns the cost of a vertex.
  double operator()(const Removal_candidate& c) const;

private:
  double area_;
};

namespace internal {

// The curvature at each vertex, and a third of the area of its faces; zero if it is isolated.
struct Vertex_values {
  std::vector<double> curvature, area;
};

template <class Triangulation>
Vertex_values vertex_values(const Triangulation& t) {
  std::vector<double> area(t.numbers().vertex_capacity(t.mesh()), 0);
  for (const auto f : faces(t.mesh())) {
    auto h = halfedge(f, t.mesh());
    for (int k = 0; k < 3; ++k, h = next(h, t.mesh()))
      area[t.index(target(h, t.mesh()))] += t.area(f) / 3;
  }
  Vertex_values result;
  const auto null = boost::graph_traits<typename Triangulation::Mesh>::null_halfedge();
  for (const auto v : vertices(t.mesh())) {
    result.curvature.push_back(halfedge(v, t.mesh()) == null ? 0 : gaussian_curvature(t, v));
    result.area.push_back(area[t.index(v)]);
  }
  return result;
}

} // namespace internal

/// returns the cost that moves curvature least. \param t the triangulation that is simplified
template <NumberedTriangulation Triangulation>
Transported_mass curvature_cost(const Triangulation& t) {
  return Transported_mass().add(internal::vertex_values(t).curvature);
}

/// returns the cost that moves area least. Areas are in units of the greatest power of two that is
/// not above the area of the surface, so that costs are about as large as lengths.
/// \param t the triangulation that is simplified
template <NumberedTriangulation Triangulation>
Transported_mass area_cost(const Triangulation& t) {
  Transported_mass result;
  if (const double area = total_area(t); area > 0) { // areas times lengths could overflow
    std::vector<double> areas = internal::vertex_values(t).area;
    const int exponent = std::ilogb(area);
    for (double& x : areas) x = std::ldexp(x, -exponent); // the power itself may overflow
    result.add(areas);
  }
  return result;
}

/// returns the cost with which operators on the coarse surface are most accurate.
/// \param t the triangulation that is simplified
template <NumberedTriangulation Triangulation>
Balanced_cost balanced_cost(const Triangulation& t) {
  // `total_area()` differs in the last bit, by which nearly equal costs change places: on
  // spot_subdiv 12 of 1,237 vertices that stay, so that measured figures would be others
  double area = 0;
  for (const auto f : faces(t.mesh())) area += t.area(f);
  return Balanced_cost(area);
}

/*!
\brief calls a function with the cost that a word names, for programs that take words.
\tparam Triangulation see `simplify()`
\tparam Function a functor that takes any of these costs, and returns the same type for each
\param name "curvature", "area" or "balanced"; any other word is "stretch"
\param t the triangulation that is simplified
\param f the function
\return what the function returns
*/
template <NumberedTriangulation Triangulation, std::invocable<Stretch_cost> Function>
auto with_named_cost(std::string_view name, const Triangulation& t, const Function& f) {
  if (name == "curvature") return f(curvature_cost(t));
  if (name == "area") return f(area_cost(t));
  if (name == "balanced") return f(balanced_cost(t));
  return f(Stretch_cost());
}

namespace internal {

// A cost of any type.
class Asked_cost {
public:
  // \param remembering it is given neighbours, and what is removed
  // \param on_vectors neighbours need vectors
  // \param of_stretch costs are expected spreads of the stretch
  Asked_cost(bool remembering, bool on_vectors, bool of_stretch)
      : remembers_(remembering), needs_vectors_(on_vectors), is_stretch_(of_stretch) {}
  virtual ~Asked_cost() = default;
  Asked_cost(const Asked_cost&) = delete;
  Asked_cost& operator=(const Asked_cost&) = delete;

  virtual double cost(const Removal_candidate& c, std::span<const Removal_neighbor> neighbors) = 0;
  virtual void remove(const Removal_candidate& c, std::span<const Removal_neighbor> neighbors) = 0;

  bool remembers() const { return remembers_; }
  bool needs_vectors() const { return needs_vectors_; }
  bool is_stretch() const { return is_stretch_; }

private:
  bool remembers_, needs_vectors_, is_stretch_;
};

template <RemovalCost Cost>
class Asked_cost_of final : public Asked_cost {
public:
  explicit Asked_cost_of(Cost cost)
      : Asked_cost(Remembers_removals<Cost>,
                   Remembers_removals<Cost> && internal::needs_vectors<Cost>(),
                   std::is_same_v<Cost, Stretch_cost>),
        cost_(std::move(cost)) {}

  double cost(const Removal_candidate& c, std::span<const Removal_neighbor> neighbors) override {
    if constexpr (Remembers_removals<Cost>)
      return CGAL::to_double(std::as_const(cost_)(c, neighbors));
    else
      return CGAL::to_double(cost_(c));
  }
  void remove(const Removal_candidate& c, std::span<const Removal_neighbor> neighbors) override {
    if constexpr (Remembers_removals<Cost>) cost_.remove(c, neighbors);
  }

private:
  Cost cost_;
};

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_REMOVAL_COSTS_H
