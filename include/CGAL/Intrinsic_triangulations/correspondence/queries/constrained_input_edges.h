// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_CONSTRAINED_INPUT_EDGES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_CONSTRAINED_INPUT_EDGES_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/adaptors/Mesh_adaptor.h>
#include <CGAL/Intrinsic_triangulations/connectivity/concepts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/Curve_queries.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/places_on_mesh.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <boost/property_map/property_map.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// The edge of the input with a user's number.
inline std::uint32_t edge_of_name(const Input_definition& input, std::uint32_t name) {
  const std::uint32_t here = input.names().edges.here(name);
  if (here == Gluing::none)
    throw Invalid_input(Element_kind::edge, name,
                        "edge " + std::to_string(name) +
                            " is not one of those that the triangulation was built from");
  return here;
}

} // namespace internal

/*!
\brief is a writable property map from the edges of an intrinsic triangulation to marks; copies
share their values, and new edges have the value false.
\tparam Triangulation a model of `NumberedTriangulation`
\tparam Mark `bool`, or the type of labels, of which 0 is none
*/
template <NumberedTriangulation Triangulation, std::copyable Mark = bool>
class Marked_edges {
  using Stored = std::conditional_t<std::is_same_v<Mark, bool>, char, Mark>;

public:
  /// \cond
  using key_type = typename Triangulation::edge_descriptor;
  using value_type = Mark;
  using reference = Mark;
  using category = boost::read_write_property_map_tag;
  friend Mark get(const Marked_edges& m, const key_type& e) {
    const std::uint32_t i = m.t_->index(e);
    return i < m.marks_->size() ? static_cast<Mark>((*m.marks_)[i]) : Mark();
  }
  friend void put(const Marked_edges& m, const key_type& e, Mark value) {
    const std::uint32_t i = m.t_->index(e);
    if (i >= m.marks_->size()) m.marks_->resize(i + std::size_t{1}, Stored());
    (*m.marks_)[i] = static_cast<Stored>(value);
  }
  /// \endcond

  /// marks no edge of `t`, which must outlive the map and its copies.
  explicit Marked_edges(const Triangulation& t)
      : t_(&t), marks_(std::make_shared<std::vector<Stored>>()) {}

private:
  const Triangulation* t_;
  std::shared_ptr<std::vector<Stored>> marks_;
};

/*!
\brief marks the intrinsic edges that run along some edges of the input.
\param t the triangulation; without correspondence, before its first move
\param is_constrained nonzero for each edge that is constrained, by its number in `t.input()`
\complexity linear; with `Signposts`, all edges are traced
*/
template <NumberedTriangulation Triangulation>
Marked_edges<Triangulation> constrained_input_edges(const Triangulation& t,
                                                    const std::vector<char>& is_constrained) {
  const auto along = [&](const auto& e) -> std::uint32_t {
    if constexpr (requires { t.correspondence().input(); })
      return internal::queries(t).input_edge_along(t.index(e));
    else
      return t.index(e);
  };
  Marked_edges<Triangulation> result(t);
  for (const auto e : edges(t.mesh())) {
    const std::uint32_t x = along(e);
    if (x < is_constrained.size() && is_constrained[x] != 0) put(result, e, true);
  }
  return result;
}

/*!
\brief marks the intrinsic edges that run along constrained edges of the user's mesh.

Pass it as named parameter `edge_is_constrained_map`. The parts of a split edge stay marked.
\tparam Mesh the type of the user's mesh
\tparam EdgeIsConstrained a readable property map from edges of `Mesh` to `bool`
\param t the triangulation; without correspondence, before its first move
\param mesh the mesh that `t` was built from; its faces may be polygons
\param map tells which of its edges are constrained
\throws Invalid_input if the mesh is another one
\complexity linear; with `Signposts`, all edges are traced
*/
template <NumberedTriangulation Triangulation, ReadableFaceGraph Mesh, class EdgeIsConstrained>
  requires requires(const EdgeIsConstrained& map,
                    typename boost::graph_traits<Mesh>::edge_descriptor e) {
    { get(map, e) } -> std::convertible_to<bool>;
  }
Marked_edges<Triangulation> constrained_input_edges(const Triangulation& t, const Mesh& mesh,
                                                    EdgeIsConstrained map) {
  std::vector<char> is_constrained(t.numbers().edge_capacity(t.mesh()), 0);
  if constexpr (requires { t.correspondence().input(); }) {
    const internal::Named_mesh_elements<Mesh> named(t.correspondence().input(), mesh);
    for (const auto e : edges(mesh))
      if (get(map, e)) is_constrained[named.halfedge_on_input(halfedge(e, mesh)) / 2] = 1;
  } else { // only names are stored of the edges of the input
    const Mesh_adaptor<Mesh> number(mesh);
    internal::check_is_mesh_of(t.input(), number.vertex_capacity(mesh));
    for (const auto e : edges(mesh))
      if (get(map, e))
        is_constrained[internal::edge_of_name(t.input(), number.halfedge(halfedge(e, mesh)) / 2)] =
            1;
  }
  return constrained_input_edges(t, is_constrained);
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_QUERIES_CONSTRAINED_INPUT_EDGES_H
