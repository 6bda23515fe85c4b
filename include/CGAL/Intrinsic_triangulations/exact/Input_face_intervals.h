// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_INPUT_FACE_INTERVALS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_INPUT_FACE_INTERVALS_H

#include <CGAL/Intrinsic_triangulations/exact/numbers/Ball.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Mpfr_number.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/thresholds.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/concepts.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief encloses squared lengths and quadruple areas of input faces in balls, without memory:
repeated flips use most of them once or twice.

If all differences of coordinates are doubles, as for points near each other, values of 106 bits are
sums of exact products with known error bounds.
\tparam FT a `Ball`; rounding is to the nearest
*/
template <FieldNumber FT>
class Input_side_values {
public:
  /// takes the input, which must outlive this object.
  explicit Input_side_values(const Input_metric& input)
      : input_(input), is_plain_(input.is_embedded() && input.delta() == 0) {}

  /// encloses the squared length of a side.
  FT squared_length(Face_side s) const;
  /// encloses the square of the quadruple area of a face.
  FT squared_quadruple_area(std::uint32_t f) const;
  /// encloses the quadruple area of a face.
  FT quadruple_area(std::uint32_t f) const { return sqrt(squared_quadruple_area(f)); }

private:
  const Input_metric& input_;
  bool is_plain_; // whether lengths are distances
};

/*!
\brief encloses the squared lengths and the quadruple areas of input faces, and stores them.
\tparam FT `Interval_nt<false>` or a `Ball`, of the same precision in all calls; rounding is as the
type requires
*/
template <FieldNumber FT>
class Input_face_intervals {
public:
  /// Encloses a number.
  using Number = FT;
  /// Squared lengths and quadruple area of a face.
  using Face = std::pair<std::array<FT, 3>, FT>;

  /// returns a functor from a face to its values; references stay valid until the next call of this
  /// function.
  auto of(const Input_metric& input) {
    if (faces_.size() > maximal_faces) {
      faces_.clear();
      place_.clear();
    }
    place_.resize(input.number_of_faces(), 0);
    return [&input, this](std::uint32_t f) -> const Face& {
      std::uint32_t& place = place_[f];
      if (place == 0) {
        faces_.push_back(face(input, f));
        place = static_cast<std::uint32_t>(faces_.size());
      }
      return faces_[place - 1];
    };
  }

  /// computes the values of a face.
  static Face face(const Input_metric& input, std::uint32_t f);

private:
  static constexpr std::size_t maximal_faces = std::is_same_v<FT, Long_ball>
                                                   ? thresholds::remembered_faces
                                                   : std::numeric_limits<std::size_t>::max();

  // in the order of their first use: faces that are unfolded together are near each other
  std::deque<Face> faces_;
  std::vector<std::uint32_t> place_; // of each face: its number there and one, or zero
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_INPUT_FACE_INTERVALS_H
