// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_OPERATORS_COTANGENT_LAPLACIAN_H
#define CGAL_INTRINSIC_OPERATORS_OPERATORS_COTANGENT_LAPLACIAN_H

#include <CGAL/Intrinsic_operators/operators/symmetric_assembly.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/triangulation/common_mistakes.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <Eigen/SparseCore>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

template <class Triangulation>
[[noreturn]] void throw_degenerate_face(const Triangulation& t,
                                        typename Triangulation::face_descriptor f) {
  const std::uint32_t i = t.index(f);
  const std::uint32_t input = t.input().names().faces.user(i);
  throw Invalid_input(
      Element_kind::face, input,
      "face " + std::to_string(input) +
          " has no area, or one too small for its cotangents; make the triangulation "
          "Delaunay, or build it with mollification");
}

// the smaller face at an edge: its cotangent overflows
template <class Triangulation>
typename Triangulation::face_descriptor smaller_face(const Triangulation& t,
                                                     typename Triangulation::edge_descriptor e) {
  const auto h = halfedge(e, t.mesh());
  const auto f = face(h, t.mesh()), g = face(opposite(h, t.mesh()), t.mesh());
  const auto null = boost::graph_traits<typename Triangulation::Mesh>::null_face();
  if (f == null || (g != null && t.area(g) < t.area(f))) return g;
  return f;
}

// Metrics that leave weights open, and find many at once faster than one by one.
template <class Triangulation>
concept Expects_weights = requires(const Triangulation& t, const std::vector<Diamond>& open) {
  t.decider().expect_weights(open);
};

// Finds the cotangent weights of all edges, in their order. What stored values leave open is found
// afterwards, at once if that takes less time. Signs that it takes make stored values narrower: as
// if edges were asked one by one, these give the weights of the edges behind.
template <Expects_weights Triangulation>
class All_weights {
  using Edge = typename Triangulation::edge_descriptor;
  using Session = typename Triangulation::Const_session;

public:
  // \param session is open
  All_weights(const Triangulation& t, const Session& session) : t_(t), session_(session) {
    weights_.reserve(num_edges(t.mesh()));
  }

  std::vector<double> operator()() {
    for (const Edge e : edges(t_.mesh())) weights_.push_back(stored_or_open(e));
    expect_open();
    const std::uint64_t& signs = t_.metric().statistics().filter_failures;
    for (std::size_t k = 0; k < open_.size(); ++k) {
      const std::uint64_t before = signs;
      const bool is_known = is_tie(open_[k]);
      weights_[places_[k]] = t_.cotangent_weight(open_[k]);
      if (is_known || signs == before) continue;
      find_behind(places_[k]);
      break;
    }
    return std::move(weights_);
  }

private:
  double stored_or_open(const Edge& e) {
    const auto h = halfedge(e, t_.mesh());
    const auto null = boost::graph_traits<typename Triangulation::Mesh>::null_face();
    if (face(h, t_.mesh()) == null || face(opposite(h, t_.mesh()), t_.mesh()) == null)
      return session_.cotangent_weight(e); // of one face
    const Diamond d = t_.diamond(h);
    if (const auto weight = t_.metric().usual_weight(d)) return *weight;
    if (const auto weight = t_.metric().stored_weight(d)) return *weight;
    open_.push_back(d);
    places_.push_back(weights_.size());
    return 0;
  }

  // whether it is known that the weight is zero
  bool is_tie(const Diamond& d) const { return t_.metric().remembered_signs().is_zero(d.ij); }

  void expect_open() const {
    std::vector<Diamond> unknown;
    unknown.reserve(open_.size());
    for (const Diamond& d : open_)
      if (!is_tie(d)) unknown.push_back(d);
    t_.decider().expect_weights(unknown);
  }

  void find_behind(std::size_t place) {
    std::size_t n = 0;
    for (const Edge e : edges(t_.mesh())) {
      if (n > place) weights_[n] = session_.cotangent_weight(e);
      ++n;
    }
  }

  const Triangulation& t_;
  const Session& session_;
  std::vector<double> weights_;
  std::vector<Diamond> open_;
  std::vector<std::size_t> places_; // of their weights
};

// Calls `visit(e, w)` for each edge and its cotangent weight, which is finite.
// \throws Invalid_input if a face has no area
template <class Triangulation, class Visit>
void for_each_cotangent_weight(const Triangulation& t, const Visit& visit) {
  const auto& mesh = t.mesh();
  const typename Triangulation::Const_session session(t);
  for (const typename Triangulation::face_descriptor f : faces(mesh))
    if (t.metric().is_degenerate(t.index(f))) throw_degenerate_face(t, f);
  std::vector<double> weights;
  if constexpr (Expects_weights<Triangulation>) weights = All_weights<Triangulation>(t, session)();
  auto next = weights.begin();
  for (const typename Triangulation::edge_descriptor e : edges(mesh)) {
    const double weight = next != weights.end() ? *next++ : session.cotangent_weight(e);
    // where rounding is upwards, what overflows below is the least of doubles
    if (!(std::abs(weight) < std::numeric_limits<double>::max()))
      throw_degenerate_face(t, smaller_face(t, e));
    visit(e, weight);
  }
}

// Calls a function with the rows of the ends of an edge, unless they are the same.
template <class Triangulation, class Visit>
void for_rows_of_ends(const Triangulation& t, typename Triangulation::edge_descriptor e,
                      const Visit& visit) {
  const typename Triangulation::halfedge_descriptor h = halfedge(e, t.mesh());
  const auto i = static_cast<int>(t.input_vertex(source(h, t.mesh()))),
             j = static_cast<int>(t.input_vertex(target(h, t.mesh())));
  if (i != j) visit(i, j);
}

// Adds the negative weights of edges, unless they are zero.
template <class Triangulation>
void add_cotangent_entries(const Triangulation& t, Symmetric_columns<>& columns) {
  using Edge = typename Triangulation::edge_descriptor;
  for_each_cotangent_weight(t, [&](Edge e, double weight) {
    if (weight == 0) return;
    for_rows_of_ends(t, e,
                     [&](int i, int j) { columns.add(i, j, -weight / t.input().names().sheets); });
  });
}

// Refuses zero rows of vertices with edges to others: the diagonal entry is the Dirichlet energy of
// a hat function, which is not constant.
template <class Triangulation>
void expect_no_lost_row(const Triangulation& t, const std::vector<char>& is_zero) {
  const auto& mesh = t.mesh();
  for (const typename Triangulation::edge_descriptor e : edges(mesh)) {
    const std::uint32_t i = t.input_vertex(source(halfedge(e, mesh), mesh)),
                        j = t.input_vertex(target(halfedge(e, mesh), mesh));
    if (i == j || (is_zero[i] == 0 && is_zero[j] == 0)) continue;
    const std::uint32_t row = is_zero[i] != 0 ? i : j;
    throw Invalid_input(
        Element_kind::vertex, row,
        "the row of vertex " + std::to_string(row) +
            " in the Laplacian is zero: rounding hides the angles of the faces about "
            "it; exact arithmetic keeps them");
  }
}

} // namespace internal

/*!
\brief assembles the cotangent Laplacian of an intrinsic triangulation (§2.5 of the course, Eq. 4):

L_ij = -w_ij,    L_ii = sum_j w_ij,    w_ij = sum over the faces at ij of 1/2 cot(angle opposite ij)

The matrix is symmetric bit by bit and positive semidefinite, with constants in its kernel: x^T L x
= integral of |grad x|^2 for the piecewise linear function x. (Many papers use the opposite sign.)
It is the weak form: the smooth equation Laplacian u = f becomes `L u = M f`, with a mass matrix `M`
of `mass_matrix.h`. Border edges have one cotangent, which is the natural (Neumann) boundary
condition. Several edges between the same vertices add up; edges from a vertex to itself do not
contribute. On a cover (`make_domain()`), copies of a vertex share a row, and sums are divided by
the number of sheets: the matrix is that of the user's surface (§6.1). In a Delaunay triangulation
no inner edge has a negative weight (a border edge has one if it faces an obtuse angle), and all
Delaunay triangulations of a surface have the same matrix (Bobenko and Springborn 2007).

All diagonal entries are stored, also zeros of isolated vertices. Other entries are stored if their
weight is not zero. Exact traits certify zero weights (cocircular faces), so the pattern too depends
only on the Delaunay tessellation. Weights have an error of at most 1e-12 times themselves or min(1,
E), where E is the least Dirichlet energy in the two faces of functions that change by one along the
edge (`Predicate_session::cotangent_weight()`). So x^T L x of a Delaunay triangulation without
border has a relative error of at most 4e-12 for all x, also on slivers. Each diagonal entry is
minus the sum of the others in its column, in their order.

\tparam Triangulation a model of `MeasuredTriangulation`
\param t the triangulation, whose predicates may sharpen stored values
\return a compressed matrix with a row and column per vertex, in the numbering of the input, without
  dimension
\throws Invalid_input if a face has no area (flips to Delaunay remove caps, mollification the rest),
or if rounding makes the row of a vertex with faces zero, which exact traits exclude
\complexity linear
*/
template <MeasuredTriangulation Triangulation>
Eigen::SparseMatrix<double> cotangent_laplacian(const Triangulation& t) {
  const int size = checked_matrix_size(t);
  std::vector<char> is_zero(static_cast<std::size_t>(size), 0);
  bool has_zero = false;
  internal::Symmetric_columns<> columns(size, [&t](const auto& count) {
    for (const typename Triangulation::edge_descriptor e : edges(t.mesh()))
      internal::for_rows_of_ends(t, e, count);
  });
  internal::add_cotangent_entries(t, columns);
  auto result = columns.matrix([&](int column, const auto& entries) {
    double sum = 0;
    for (const double x : entries) sum -= x;
    if (sum == 0) is_zero[static_cast<std::size_t>(column)] = has_zero = true;
    return sum;
  });
  if (has_zero) internal::expect_no_lost_row(t, is_zero);
  return result;
}

/// \cond
CGAL_INTRINSIC_TRIANGULATIONS_REFUSE_MESH(cotangent_laplacian)
/// \endcond

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_OPERATORS_COTANGENT_LAPLACIAN_H
