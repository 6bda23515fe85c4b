// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_DECIDING_FOLLOWED_VALUES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_DECIDING_FOLLOWED_VALUES_H

#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Ball.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Replayed_faces.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Vertex_star.h>
#include <CGAL/Intrinsic_triangulations/metric/Enclosed_values.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Moves.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

/*
Values in 106 bits. Queries make them until the next move, see `Euclidean_decider`.

Once edges were flipped more than once on average, they follow flips: else further flips would make
the stored intervals wider and wider. The 240,000 edges of a sheared torus flip eight times each:
flips took 365 ms instead of 151, but the Laplacian, areas and lengths after them 26 instead of 600.

Where faces cross long strips of input faces before the first insertion, around needles, they follow
all moves. The strips are unfolded at an insertion anyway; for statistics of a CAD part of slivers,
doing it again took as long as all of refinement. So that moves do not depend on it, the metric gets
these values only when it is asked for accurate ones. Where some hundred flips follow each other
without an insertion, their errors exceed 106 bits, and faces are unfolded again.
*/
class Followed_values {
public:
  // The values; null if there are none, or not of the faces.
  const Replayed_values<Short_ball>* of(const Diamond& d) const {
    return values_ && values_->knows(d.f) && values_->knows(d.g) ? &*values_ : nullptr;
  }
  const Replayed_values<Short_ball>* of(const Indexed_face& f) const {
    return values_ && values_->knows(f.face) ? &*values_ : nullptr;
  }

  // whether there are those of all faces
  bool are_known(std::span<const Indexed_face> faces) const;
  // Gives them to a metric, where there are some. \return of how many faces
  std::size_t refine(const Enclosed_values& metric, std::span<const Indexed_face> faces) const;

  void keep(Replayed_values<Short_ball> values, bool follow) {
    values_ = std::move(values);
    following_ = follow ? Following::flips : Following::nothing;
  }
  // a query must not end that
  bool is_following() const { return following_ != Following::nothing; }
  bool follows_flips() const { return following_ == Following::flips; }
  bool follows_insertions() const { return following_ == Following::insertions; }

  // Tells whether to follow flips from now on: the next time after twice as many, since flips that
  // are taken back end it.
  bool is_time_to_follow(std::size_t edges) {
    if (flips_ < enough_flips_) return false;
    enough_flips_ = std::max(2 * flips_, edges);
    return flips_ >= edges && !is_following();
  }

  // Follows a flip. Where all flips are followed, the metric gets the new values.
  void flip(const Enclosed_values& metric, const Flip& move) noexcept {
    move.is_taken_back() ? flips_ -= std::min<std::size_t>(flips_, 1) : ++flips_;
    if (values_) follow(metric, move);
  }

  // Lets values of all faces follow insertions from now on, unless repeated flips left some wide:
  // then most would be wide soon.
  void follow_insertions(Replayed_values<Short_ball> values);
  // Announces an insertion, whose values they take from coordinates. \pre rounding is upwards
  // \param edges how many there may be afterwards, and faces
  void announce(const Integer_coordinates& coordinates, std::uint32_t edges, std::uint32_t faces);
  // Follow moves. Values that do not follow insertions are forgotten.
  void insert(const Vertex_star& star) noexcept;
  void insert(const Border_star& star) noexcept;
  void remove(const Vertex_star& star) noexcept;
  void remove(const Border_star& star) noexcept;

private:
  enum class Following { nothing, flips, insertions };

  void follow(const Enclosed_values& metric, const Flip& move) noexcept;
  void forget() noexcept;

  std::optional<Replayed_values<Short_ball>> values_;
  Vertex_move_values<Short_ball> inserted_; // at the vertex that was announced
  Following following_ = Following::nothing;
  std::size_t flips_ = 0; // less those taken back
  std::size_t enough_flips_ = 0;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_DECIDING_FOLLOWED_VALUES_H
