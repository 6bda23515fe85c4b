// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_GEODESICS_CUTS_CUT_ALONG_H
#define CGAL_INTRINSIC_GEODESICS_CUTS_CUT_ALONG_H

#include <CGAL/Intrinsic_geodesics/curves/Curve_network.h>
#include <CGAL/Intrinsic_geodesics/curves/GeodesicTriangulation.h>
#include <CGAL/Intrinsic_geodesics/curves/add_marked_edges.h>
#include <CGAL/Intrinsic_geodesics/curves/insert_polyline.h>
#include <CGAL/Intrinsic_geodesics/cuts/Cut_surface.h>
#include <CGAL/Intrinsic_geodesics/isolines/isolines.h>
#include <CGAL/Intrinsic_geodesics/queries/trace_curve.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/constrained_input_edges.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/Status.h>
#include <CGAL/Intrinsic_triangulations/triangulation/common_mistakes.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Cuts the surface of a common subdivision along intrinsic edges with a label other than 0.
Cut_surface cut_subdivision(const Common_subdivision& s, const Input& input,
                            const std::vector<std::uint32_t>& label);

} // namespace internal

/// checks that curves can cut a surface. \throws Invalid_input if it is a cover
void expect_one_sheet(const Input& surface);

/*!
\brief cuts the surface of the user's mesh open along marked edges of an intrinsic triangulation:
geodesics, isolines, cut graphs, edges of the mesh.

Curves become edges of the triangulation first: by `add_geodesics()`, `insert_isolines()`,
`insert_polyline()`, `add_marked_edges()` or `constrained_input_edges()`. All other edges of the
triangulation leave no trace.

What is cut follows from integers alone, so rounding of points cannot spoil it: each triangle of the
mesh that curves enter is divided along them, and the pieces are triangulated. A piece has no area
only if rounding puts its corners on a line.
\tparam Triangulation a model of `CorrespondingTriangulation`
\tparam EdgeIsMarked a readable property map from its edges to `bool`, or to labels of which 0 is
  none, such as `curve_labels()`
\param t the triangulation
\param is_marked is true for the edges to cut
\throws Invalid_input if `t` is on a cover, whose sheets lie on each other
\complexity linear in the common subdivision; in a triangle that curves enter, the number of
  triangles at a vertex that is left out counts with its third power
*/
template <QueriedTriangulation Triangulation, class EdgeIsMarked>
  requires requires(const EdgeIsMarked& map, typename Triangulation::edge_descriptor e) {
    { get(map, e) } -> std::convertible_to<std::uint32_t>;
  }
Cut_surface cut_along(const Triangulation& t, const EdgeIsMarked& is_marked) {
  std::vector<std::uint32_t> label(t.numbers().edge_capacity(t.mesh()), 0);
  for (const auto e : edges(t.mesh()))
    label[t.index(e)] = static_cast<std::uint32_t>(get(is_marked, e));
  return internal::cut_subdivision(common_subdivision(t), internal::kept_input(t), label);
}

/*!
\brief cuts the surface of the user's mesh open along the curves of a network.
\tparam Triangulation a model of `CorrespondingTriangulation` and of `GeodesicTriangulation`
\param network the curves
\return the surface; curves have their numbers in the network, plus one, as labels
\throws Invalid_input also if a curve has no edges
\complexity see the overload with marked edges
*/
template <GeodesicTriangulation Triangulation>
  requires QueriedTriangulation<Triangulation>
      Cut_surface cut_along(const Curve_network<Triangulation>& network) {
    for (std::uint32_t c = 0; c < network.number_of_curves(); ++c)
      if (network.is_point(c))
        throw Invalid_input(Element_kind::none, 0,
                            "curve " + std::to_string(c) +
                                " has shrunk to a point, along which nothing can be cut; leave it "
                                "out, or fix vertices on its way");
    return cut_along(network.triangulation(), curve_labels(network));
  }

/// \cond
CGAL_INTRINSIC_TRIANGULATIONS_REFUSE_MESH(cut_along)
/// \endcond

namespace internal {

// Inserts curves; `name(i)` is what errors call number i.
template <class Triangulation, class Name>
std::vector<Inserted_polyline<Triangulation>>
insert_named_curves(Triangulation& t, const std::vector<Traced_curve>& curves, const Name& name) {
  std::vector<Inserted_polyline<Triangulation>> paths;
  for (const Traced_curve& curve : curves) {
    paths.push_back(insert_polyline(t, curve.points));
    if (curve.status == Status::not_traceable || paths.back().status != Move_status::done)
      throw Invalid_input(Element_kind::none, 0,
                          name(paths.size() - 1) +
                              " cannot be inserted into the triangulation; choose another");
  }
  return paths;
}

template <class Triangulation, class Label>
Marked_edges<Triangulation, std::uint32_t>
labels_along(const Triangulation& t, const std::vector<Inserted_polyline<Triangulation>>& paths,
             const Label& label) {
  Marked_edges<Triangulation, std::uint32_t> labels(t);
  for (std::size_t i = 0; i < paths.size(); ++i)
    for (const auto h : paths[i].halfedges)
      put(labels, edge(h, t.mesh()), static_cast<std::uint32_t>(label(i)));
  return labels;
}

} // namespace internal

/*!
\brief inserts curves over the input: they become paths of edges, along which `cut_along()` cuts.
They may cross.
\tparam Triangulation a model of `RefinableTriangulation` and of `CorrespondingTriangulation`
\param t the triangulation
\param curves the curves, such as isolines and traced geodesics
\return for each edge the number of the last curve along it, plus one; 0 for all others
\throws Invalid_input naming a curve that cannot be inserted, or is a point
\complexity see `insert_polyline()`
*/
template <RefinableTriangulation Triangulation>
  requires QueriedTriangulation<Triangulation> Marked_edges<Triangulation, std::uint32_t>
  insert_curves(Triangulation& t, const std::vector<Traced_curve>& curves) {
    const auto name = [](std::size_t i) { return "curves[" + std::to_string(i) + "]"; };
    const auto paths = internal::insert_named_curves(t, curves, name);
    for (std::size_t i = 0; i < paths.size(); ++i)
      if (paths[i].halfedges.empty())
        throw Invalid_input(Element_kind::none, 0,
                            name(i) + " is a point, along which nothing can be cut; leave it out");
    return internal::labels_along(t, paths, [](std::size_t i) { return i + 1; });
  }

/*!
\brief inserts isolines of a triangulation: they become paths of its edges, along which
`cut_along()` cuts.

Points of an isoline that coincide with a vertex, up to rounding, are this vertex.
\tparam Triangulation a model of `RefinableTriangulation` and of `CorrespondingTriangulation`
\param t the triangulation
\param lines what `isolines()` found on `t`, which has not changed since
\return for each edge the number of the level of the isoline along it, plus one; 0 for all others
\throws Invalid_input naming the line that cannot be inserted
\complexity see `trace_isoline()` and `insert_polyline()`
*/
template <RefinableTriangulation Triangulation>
  requires QueriedTriangulation<Triangulation> Marked_edges<Triangulation, std::uint32_t>
  insert_isolines(Triangulation& t, const std::vector<Isoline>& lines) {
    std::vector<Traced_curve> ways;
    for (const Isoline& line : lines) {
      ways.push_back(trace_isoline(t, line));
      if (ways.back().status != Status::done) ways.back().status = Status::not_traceable;
    }
    const auto paths = internal::insert_named_curves(t, ways, [&](std::size_t i) {
      return "isoline " + std::to_string(i) + ", of level " + std::to_string(lines[i].level) + ",";
    });
    return internal::labels_along(t, paths,
                                  [&](std::size_t i) { return lines[i].number_of_level + 1; });
  }

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_GEODESICS_CUTS_CUT_ALONG_H
