// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/correspondence/curves/Turn_products.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Vertex_fans.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Ball.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Plane_vector.h>
#include <CGAL/Intrinsic_triangulations/formulas/apex.h>
#include <CGAL/Intrinsic_triangulations/formulas/concepts.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>

#include <CGAL/Interval_nt.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace {

template <FieldNumber FT, class Leaf>
std::vector<Plane_vector<FT>> products(std::size_t degree, const Leaf& leaf) {
  std::vector<Plane_vector<FT>> nodes(2 * degree);
  for (std::size_t n = 0; n < degree; ++n) nodes[degree + n] = leaf(n);
  for (std::size_t n = degree; --n > 0;) nodes[n] = nodes[2 * n] * nodes[2 * n + 1];
  return nodes;
}

// the node of a tree that is not there
template <FieldNumber FT, class Leaf>
Plane_vector<FT> product_below(std::size_t n, std::size_t degree, const Leaf& leaf) {
  if (n >= degree) return leaf(n - degree);
  return product_below<FT>(2 * n, degree, leaf) * product_below<FT>(2 * n + 1, degree, leaf);
}

template <FieldNumber FT>
Plane_vector<FT> power(Plane_vector<FT> z, std::size_t exponent) {
  Plane_vector<FT> result{FT(1), FT(0)};
  for (; exponent > 0; exponent /= 2, z = z * z)
    if (exponent % 2 != 0) result = result * z;
  return result;
}

// of leaves from one to another; products commute
template <FieldNumber FT, class Node>
Plane_vector<FT> product_of_leaves(const Node& node, std::size_t degree, std::size_t from,
                                   std::size_t to) {
  Plane_vector<FT> result{FT(1), FT(0)};
  for (from += degree, to += degree; from < to; from /= 2, to /= 2) {
    if (from % 2 != 0) result = result * node(from++);
    if (to % 2 != 0) result = result * node(--to);
  }
  return result;
}

// \param node a functor from the number of a node to it
template <FieldNumber FT, class Node>
Plane_vector<FT> turn_over(const Node& node, std::size_t degree, std::size_t from,
                           std::size_t count) {
  // a straight line goes round the tip of a thin spike many times
  const std::size_t to = from + count % degree;
  const Plane_vector<FT> part = to <= degree
                                    ? product_of_leaves<FT>(node, degree, from, to)
                                    : product_of_leaves<FT>(node, degree, from, degree) *
                                          product_of_leaves<FT>(node, degree, 0, to - degree);
  if (count < degree) return part;
  return part * power(product_of_leaves<FT>(node, degree, 0, degree), count / degree);
}

} // namespace

template <FieldNumber FT>
Plane_vector<FT> Turn_products<FT>::operator()(const Input& input, const Vertex_fans& fans,
                                               const Values& values, std::uint32_t first,
                                               std::uint32_t count) {
  const std::uint32_t begin = fans.first_slot(first), degree = fans.degree(first);
  Tree& tree = trees_[begin];
  const auto leaf = [&](std::size_t n) {
    return corner(input, fans, values, begin + static_cast<std::uint32_t>(n));
  };
  if (tree.nodes.empty()) {
    tree.steps += count;
    if (tree.steps <= degree)
      return turn_over<FT>([&](std::size_t n) { return product_below<FT>(n, degree, leaf); },
                           degree, first - begin, count);
    tree.nodes = products<FT>(degree, leaf); // all of it, or nothing if memory ends
  }
  return turn_over<FT>([&](std::size_t n) -> const Plane_vector<FT>& { return tree.nodes[n]; },
                       degree, first - begin, count);
}

template <FieldNumber FT>
Plane_vector<FT> Turn_products<FT>::corner(const Input& input, const Vertex_fans& fans,
                                           const Values& values, std::uint32_t slot) {
  const std::uint32_t h = fans.halfedge(slot);
  if (input.is_border(h)) return {FT(1), FT(0)};
  const Face_values<FT> v = values(h);
  const auto& l = v.squared_lengths;
  return apex(l[0], l[1], l[2], v.quadruple_area);
}

template class Turn_products<double>;
template class Turn_products<Interval_nt<false>>;
template class Turn_products<Short_ball>;
template class Turn_products<Long_ball>;

} // namespace CGAL::Intrinsic_triangulations
