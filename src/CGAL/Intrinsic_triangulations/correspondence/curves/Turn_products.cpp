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

namespace CGAL::Intrinsic_triangulations::internal {

template <FieldNumber FT>
Plane_vector<FT> Turn_products<FT>::operator()(const Input& input, const Vertex_fans& fans,
                                               const Values& values, std::uint32_t first,
                                               std::uint32_t count) {
  const std::uint32_t begin = fans.first_slot(first), degree = fans.degree(first);
  Tree& tree = trees_[begin];
  if (tree.nodes.empty()) {
    tree.steps += count;
    if (tree.steps <= degree) return multiplied(fans, values, first, count);
    build(tree, input, fans, values, begin, degree);
  }
  // a straight line goes round the tip of a thin spike many times
  const std::size_t from = first - begin, to = from + count % degree;
  const Plane_vector<FT> part = to <= degree
                                    ? product(tree, from, to)
                                    : product(tree, from, degree) * product(tree, 0, to - degree);
  return part * power(product(tree, 0, degree), count / degree);
}

template <FieldNumber FT>
Plane_vector<FT> Turn_products<FT>::corner(const Vertex_fans& fans, const Values& values,
                                           std::uint32_t slot) {
  const Face_values<FT> v = values(fans.halfedge(slot));
  const auto& l = v.squared_lengths;
  return apex(l[0], l[1], l[2], v.quadruple_area);
}

template <FieldNumber FT>
Plane_vector<FT> Turn_products<FT>::multiplied(const Vertex_fans& fans, const Values& values,
                                               std::uint32_t first, std::uint32_t count) {
  Plane_vector<FT> result = corner(fans, values, first);
  for (std::uint32_t n = 1; n < count; ++n)
    result = result * corner(fans, values, fans.advance(first, n));
  return result;
}

template <FieldNumber FT>
void Turn_products<FT>::build(Tree& tree, const Input& input, const Vertex_fans& fans,
                              const Values& values, std::uint32_t begin, std::uint32_t degree) {
  tree.nodes.resize(2 * std::size_t{degree});
  for (std::uint32_t n = 0; n < degree; ++n) // the last one of a border has no triangle
    tree.nodes[degree + n] = input.is_border(fans.halfedge(begin + n))
                                 ? Plane_vector<FT>{FT(1), FT(0)}
                                 : corner(fans, values, begin + n);
  for (std::size_t n = degree; --n > 0;) tree.nodes[n] = tree.nodes[2 * n] * tree.nodes[2 * n + 1];
}

template <FieldNumber FT>
Plane_vector<FT> Turn_products<FT>::product(const Tree& tree, std::size_t from, std::size_t to) {
  const std::size_t degree = tree.nodes.size() / 2;
  Plane_vector<FT> result{FT(1), FT(0)};
  for (from += degree, to += degree; from < to; from /= 2, to /= 2) {
    if (from % 2 != 0) result = result * tree.nodes[from++];
    if (to % 2 != 0) result = result * tree.nodes[--to];
  }
  return result;
}

template <FieldNumber FT>
Plane_vector<FT> Turn_products<FT>::power(Plane_vector<FT> z, std::uint32_t exponent) {
  Plane_vector<FT> result{FT(1), FT(0)};
  for (; exponent > 0; exponent /= 2, z = z * z)
    if (exponent % 2 != 0) result = result * z;
  return result;
}

template class Turn_products<double>;
template class Turn_products<Interval_nt<false>>;
template class Turn_products<Short_ball>;
template class Turn_products<Long_ball>;

} // namespace CGAL::Intrinsic_triangulations::internal
