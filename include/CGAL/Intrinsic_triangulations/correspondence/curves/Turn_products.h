// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_TURN_PRODUCTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_TURN_PRODUCTS_H

#include <CGAL/Intrinsic_triangulations/correspondence/curves/Vertex_fans.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Plane_vector.h>
#include <CGAL/Intrinsic_triangulations/formulas/concepts.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <unordered_map>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief computes turns about input vertices: quotients of vectors from a vertex to its neighbours.

In each triangle at the vertex, the quotient of the vectors along its last and its first side is a
corner, `apex()`. That over many triangles is their product; a tree of products per vertex gives it
in a logarithmic number of steps. The tree of a vertex is made once products without it have taken
as long. Factors are multiplied in the order of the tree before, too: results do not depend on
earlier calls.
\tparam FT `double`, `Interval_nt<false>` or a `Ball`: the number type of the plane
*/
template <FieldNumber FT>
class Turn_products {
public:
  /// A functor from an input halfedge to the values of its face from it.
  using Values = std::function<Face_values<FT>(std::uint32_t)>;

  /*!
  \brief returns the quotient for consecutive triangles, counterclockwise.
  \param input the input, always the same
  \param fans the halfedges around its vertices
  \param values gives the values of the face of an input halfedge, from it
  \param first slot of the halfedge with the first triangle
  \param count number of triangles
  \complexity logarithmic in the degree of the vertex, amortized over many calls
  */
  Plane_vector<FT> operator()(const Input& input, const Vertex_fans& fans, const Values& values,
                              std::uint32_t first, std::uint32_t count);

private:
  // nodes n and n + 1 for even n are the factors of node n / 2; the leaves come last
  struct Tree {
    std::size_t steps = 0; // without it
    std::vector<Plane_vector<FT>> nodes;
  };

  // of the triangle at a slot; the last one of a border has none
  static Plane_vector<FT> corner(const Input& input, const Vertex_fans& fans, const Values& values,
                                 std::uint32_t slot);

  std::unordered_map<std::uint32_t, Tree> trees_; // by the first slot of the fan
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_TURN_PRODUCTS_H
