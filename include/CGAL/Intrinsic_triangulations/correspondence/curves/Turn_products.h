// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_TURN_PRODUCTS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_TURN_PRODUCTS_H

#include <CGAL/Intrinsic_triangulations/correspondence/curves/Vertex_fans.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Plane_vector.h>
#include <CGAL/Intrinsic_triangulations/formulas/apex.h>
#include <CGAL/Intrinsic_triangulations/formulas/concepts.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>

#include <cstddef>
#include <cstdint>
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
\tparam FT number type of the plane
*/
template <FieldNumber FT>
class Turn_products {
public:
  /*!
  \brief returns the quotient for consecutive triangles, counterclockwise.
  \param input the input, always the same
  \param fans the halfedges around its vertices
  \param values a functor from an input halfedge to the `Face_values<FT>` of its face from it
  \param first slot of the halfedge with the first triangle
  \param count number of triangles
  \complexity logarithmic in the degree of the vertex, amortized over many calls
  */
  template <class Values>
  Plane_vector<FT> operator()(const Input& input, const Vertex_fans& fans, const Values& values,
                              std::uint32_t first, std::uint32_t count) {
    const std::uint32_t begin = fans.first_slot(first), degree = fans.degree(first);
    Tree& tree = trees_[begin];
    const auto leaf = [&](std::size_t n) {
      return corner(input, fans, values, begin + static_cast<std::uint32_t>(n));
    };
    if (tree.nodes.empty()) {
      tree.steps += count;
      if (tree.steps <= degree)
        return turn([&](std::size_t n) { return product_below(n, degree, leaf); }, degree,
                    first - begin, count);
      build(tree, degree, leaf);
    }
    return turn([&](std::size_t n) -> const Plane_vector<FT>& { return tree.nodes[n]; }, degree,
                first - begin, count);
  }

private:
  // nodes n and n + 1 for even n are the factors of node n / 2; the leaves come last
  struct Tree {
    std::size_t steps = 0; // without it
    std::vector<Plane_vector<FT>> nodes;
  };

  // of the triangle at a slot; the last one of a border has none
  template <class Values>
  static Plane_vector<FT> corner(const Input& input, const Vertex_fans& fans, const Values& values,
                                 std::uint32_t slot) {
    const std::uint32_t h = fans.halfedge(slot);
    if (input.is_border(h)) return {FT(1), FT(0)};
    const Face_values<FT> v = values(h);
    const auto& l = v.squared_lengths;
    return apex(l[0], l[1], l[2], v.quadruple_area);
  }

  template <class Leaf>
  static void build(Tree& tree, std::size_t degree, const Leaf& leaf) {
    tree.nodes.resize(2 * degree);
    for (std::size_t n = 0; n < degree; ++n) tree.nodes[degree + n] = leaf(n);
    for (std::size_t n = degree; --n > 0;)
      tree.nodes[n] = tree.nodes[2 * n] * tree.nodes[2 * n + 1];
  }
  // the node of a tree that is not there
  template <class Leaf>
  static Plane_vector<FT> product_below(std::size_t n, std::size_t degree, const Leaf& leaf) {
    if (n >= degree) return leaf(n - degree);
    return product_below(2 * n, degree, leaf) * product_below(2 * n + 1, degree, leaf);
  }

  // \param node a functor from the number of a node to it
  template <class Node>
  static Plane_vector<FT> turn(const Node& node, std::size_t degree, std::size_t from,
                               std::uint32_t count) {
    // a straight line goes round the tip of a thin spike many times
    const std::size_t to = from + count % degree;
    const Plane_vector<FT> part =
        to <= degree ? product(node, degree, from, to)
                     : product(node, degree, from, degree) * product(node, degree, 0, to - degree);
    if (count < degree) return part;
    return part *
           power(product(node, degree, 0, degree), count / static_cast<std::uint32_t>(degree));
  }

  // of leaves from one to another; products commute
  template <class Node>
  static Plane_vector<FT> product(const Node& node, std::size_t degree, std::size_t from,
                                  std::size_t to) {
    Plane_vector<FT> result{FT(1), FT(0)};
    for (from += degree, to += degree; from < to; from /= 2, to /= 2) {
      if (from % 2 != 0) result = result * node(from++);
      if (to % 2 != 0) result = result * node(--to);
    }
    return result;
  }

  static Plane_vector<FT> power(Plane_vector<FT> z, std::uint32_t exponent) {
    Plane_vector<FT> result{FT(1), FT(0)};
    for (; exponent > 0; exponent /= 2, z = z * z)
      if (exponent % 2 != 0) result = result * z;
    return result;
  }

  std::unordered_map<std::uint32_t, Tree> trees_; // by the first slot of the fan
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_CURVES_TURN_PRODUCTS_H
