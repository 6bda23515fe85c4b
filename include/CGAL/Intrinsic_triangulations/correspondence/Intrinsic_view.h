// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_INTRINSIC_VIEW_H
#define CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_INTRINSIC_VIEW_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Metric_values.h>

#include <boost/graph/graph_traits.hpp>

#include <cstdint>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// BGL's functions under names that the members of a class do not hide.
template <class Mesh, class Halfedge = typename boost::graph_traits<Mesh>::halfedge_descriptor>
Halfedge graph_next(Halfedge h, const Mesh& mesh) {
  return next(h, mesh);
}
template <class Mesh>
typename boost::graph_traits<Mesh>::face_descriptor
graph_face(typename boost::graph_traits<Mesh>::halfedge_descriptor h, const Mesh& mesh) {
  return face(h, mesh);
}
template <class Mesh>
typename boost::graph_traits<Mesh>::vertex_descriptor
graph_target(typename boost::graph_traits<Mesh>::halfedge_descriptor h, const Mesh& mesh) {
  return target(h, mesh);
}
template <class Mesh, class Descriptor>
typename boost::graph_traits<Mesh>::halfedge_descriptor graph_halfedge(Descriptor d,
                                                                       const Mesh& mesh) {
  return halfedge(d, mesh);
}

} // namespace internal

/*!
\brief reads an intrinsic triangulation by the numbers of its elements, with the same functions as
`Input`: algorithms can walk over both.
\tparam Triangulation has a mesh and numbers of its elements; values are read where it has them
\cgalModels{NumberedComplex}
*/
template <class Triangulation>
class Intrinsic_view {
  using Mesh = typename Triangulation::Mesh;
  using Traits = boost::graph_traits<Mesh>;

public:
  /// views `t`, which must outlive the view.
  explicit Intrinsic_view(const Triangulation& t) : t_(&t) {}

  /// returns the halfedge after `h`.
  std::uint32_t next(std::uint32_t h) const {
    return number(internal::graph_next(descriptor(h), t_->mesh()));
  }
  /// returns the other side of the edge of `h`.
  static std::uint32_t opposite(std::uint32_t h) { return h ^ 1U; }
  /// tells whether `h` has no face.
  bool is_border(std::uint32_t h) const { return face(h) == Gluing::none; }
  /// returns the face of `h`, `Gluing::none` on the border.
  std::uint32_t face(std::uint32_t h) const {
    const typename Traits::face_descriptor f = internal::graph_face(descriptor(h), t_->mesh());
    return f == Traits::null_face() ? Gluing::none : t_->numbers().face(f);
  }
  /// returns the vertex that `h` starts from.
  std::uint32_t source(std::uint32_t h) const { return target(h ^ 1U); }
  /// returns the vertex that `h` points to.
  std::uint32_t target(std::uint32_t h) const {
    return t_->numbers().vertex(internal::graph_target(descriptor(h), t_->mesh()));
  }
  /// returns a halfedge of face `f`.
  std::uint32_t halfedge_of_face(std::uint32_t f) const {
    return number(internal::graph_halfedge(t_->numbers().face_at(f), t_->mesh()));
  }
  /// returns the halfedge of edge `e` in face `f` where the next one is on edge `next_e`.
  std::uint32_t halfedge(std::uint32_t f, std::uint32_t e, std::uint32_t next_e) const {
    return face(2 * e) == f && next(2 * e) / 2 == next_e ? 2 * e : 2 * e + 1;
  }
  /// returns a halfedge that starts at vertex `v`, the one whose right side is the border if there
  /// is one. \pre `v` is not isolated
  std::uint32_t outgoing_halfedge(std::uint32_t v) const {
    return number(internal::graph_halfedge(t_->numbers().vertex_at(v), t_->mesh())) ^ 1U;
  }
  /// returns the first halfedge of which a predicate is true, or `Gluing::none`. \complexity linear
  template <class Predicate>
  std::uint32_t find_halfedge(const Predicate& predicate) const {
    for (const auto h : halfedges(t_->mesh()))
      if (predicate(number(h))) return number(h);
    return Gluing::none;
  }
  /// returns the squared length of edge `e`, in scaled units.
  double squared_length(std::uint32_t e) const {
    return t_->metric().approximate_squared_length(e);
  }
  /// returns the quadruple area of face `f`, in scaled units.
  double quadruple_area(std::uint32_t f) const {
    return t_->metric().approximate_quadruple_area(f);
  }
  /// returns s, where lengths are 2^s times those in the units of the input.
  int scale_exponent() const { return t_->metric().scale_exponent(); }

private:
  typename Traits::halfedge_descriptor descriptor(std::uint32_t h) const {
    return t_->numbers().halfedge_at(h);
  }
  std::uint32_t number(typename Traits::halfedge_descriptor h) const {
    return t_->numbers().halfedge(h);
  }

  const Triangulation* t_;
};

namespace internal {

// Views a triangulation; with exact traits, values of thin faces are as accurate as others. In a
// face beside a very short edge the middle of the interval of an area may be far off, and the angle
// between the edge and a line with it.
template <class Triangulation>
class Accurate_view : public Intrinsic_view<Triangulation> {
  using Base = Intrinsic_view<Triangulation>;

public:
  explicit Accurate_view(const Triangulation& t) : Base(t), t_(&t) {}

  double squared_length(std::uint32_t e) const {
    sharpen(Base::face(this->is_border(2 * e) ? 2 * e + 1 : 2 * e));
    return Base::squared_length(e);
  }
  double quadruple_area(std::uint32_t f) const {
    sharpen(f);
    return Base::quadruple_area(f);
  }

private:
  void sharpen(std::uint32_t f) const { accurate_values(*t_, t_->numbers().face_at(f)); }

  const Triangulation* t_;
};

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_CORRESPONDENCE_INTRINSIC_VIEW_H
