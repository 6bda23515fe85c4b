// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_STUDY_COMPARED_METRIC_H
#define INTRINSIC_STUDY_COMPARED_METRIC_H

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_euclidean_traits.h>

#include <cstdint>
#include <exception>
#include <memory>
#include <optional>
#include <utility>

namespace program {

namespace IT = CGAL::Intrinsic_triangulations;

/*!
\brief decides as another metric does, and compares with an exact triangulation that makes the same
flips. The comparison ends at the first flip of a diamond that is not convex, which is impossible in
the exact triangulation.
\tparam Metric a model of `IntrinsicMetric`
*/
template <class Metric>
class Compared_metric : public Metric {
public:
  Compared_metric() = default;
  Compared_metric(const IT::Gluing_map& mesh, const IT::Input_metric& input)
      : Metric(mesh, input),
        exact_(std::in_place, mesh, IT::Exact_euclidean_metric(mesh, input),
               std::make_shared<const IT::Input_definition>(
                   IT::Input_definition::Parts{mesh.number_of_vertices(), input, {}, {}, {}})) {}

  bool is_locally_delaunay(const IT::Diamond& d) const {
    if (failure_) std::rethrow_exception(failure_);
    const bool answer = Metric::is_locally_delaunay(d);
    if (is_following_ && answer != is_exactly_delaunay(d)) ++different_decisions_;
    return answer;
  }

  void store_flip(const IT::Diamond& d, typename Metric::Flipped&& n) noexcept {
    Metric::store_flip(d, std::move(n));
    if (!is_following_) return;
    try {
      if (follow(d)) return;
      ++nonconvex_flips_;
    } catch (...) { // memory is exhausted; the next predicate says so
      failure_ = std::current_exception();
    }
    is_following_ = false;
  }

  /// tells whether the exact triangulation has made all flips so far.
  bool is_following() const { return is_following_; }
  /// returns how often the other metric decided differently.
  std::uint64_t different_decisions() const { return different_decisions_; }
  /// returns whether a diamond was flipped that is not convex.
  std::uint64_t nonconvex_flips() const { return nonconvex_flips_; }

private:
  using Exact = IT::Intrinsic_triangulation<>;

  // Not inline: the other metric's arithmetic must not be moved to where rounding is upwards.
  [[gnu::noinline]] bool is_exactly_delaunay(const IT::Diamond& d) const {
    return exact_->is_locally_delaunay(halfedge_of(d));
  }

  [[gnu::noinline]] bool follow(const IT::Diamond& d) {
    return exact_->flip_edge(halfedge_of(d)) == IT::Move_status::done;
  }

  Exact::halfedge_descriptor halfedge_of(const IT::Diamond& d) const {
    const Exact::halfedge_descriptor h{2 * d.ij};
    const IT::Gluing_map& m = exact_->mesh();
    return m.face(h).index == d.f && m.next(h).index / 2 == d.jk ? h : m.opposite(h);
  }

  std::optional<Exact> exact_; // none of an empty metric
  bool is_following_ = true;
  mutable std::uint64_t different_decisions_ = 0;
  std::uint64_t nonconvex_flips_ = 0;
  std::exception_ptr failure_; // of the exact triangulation, in a flip
};

/// lets an intrinsic triangulation compute as with other traits, compared with exact ones.
template <class Traits>
struct Compared_traits {
  using FT = typename Traits::FT;
  using Metric = Compared_metric<typename Traits::Metric>;
};

} // namespace program

#endif // INTRINSIC_STUDY_COMPARED_METRIC_H
