// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_EXACT_LADDER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_EXACT_LADDER_H

#include <CGAL/Intrinsic_triangulations/exact/Predicate_statistics.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Ball.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Mpfr_number.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Replayed_faces.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/figures.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Recorded_expression.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>

#include <CGAL/Interval_nt.h>
#include <CGAL/enum.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief decides signs that the stored intervals of a metric leave open, and encloses values as
narrowly as required.

It evaluates on a *figure*, which says how values follow from the faces of the input:

| figure | how | values |
|--------|-----|--------|
| `Input_diamond` | two faces of the input | of a diamond |
| `Flat_diamond` | corners in a plane in space | of a diamond |
| `Unfolded_diamond` | input triangles under a diamond, unfolded | of a diamond |
| `Unfolded_faces` | those under faces | of faces |
| `Replayed_diamond`, `Replayed_faces` | repeated flips, if edges cross too many faces | of both |

`Exact_ladder.cpp` gives the steps, their order and the reasons.

All members require rounding upwards.
*/
class Exact_ladder {
public:
  /// Number type of enclosures.
  using FT = Interval_nt<false>;

  /// starts with an empty memory.
  Exact_ladder() = default;
  /// starts with an empty memory.
  Exact_ladder(const Exact_ladder&) {}
  /// takes the memory of another one.
  Exact_ladder(Exact_ladder&&) = default;
  /// clears the memory.
  Exact_ladder& operator=(const Exact_ladder&) {
    memory_ = nullptr;
    return *this;
  }
  /// takes the memory of another one.
  Exact_ladder& operator=(Exact_ladder&&) = default;
  ~Exact_ladder() = default;

  /*!
  \brief returns the sign of an expression in the values of a figure.
  \param input the input, always the same
  \param figure see above; no triangle is entered by a side without length
  \param expression a `Recorded_diamond_expression` or a `Recorded_face_expression`
  \param better intervals that contain the values, which may become narrower
  \param statistics counts how the sign was decided
  */
  template <class Figure, class Expression, class Values>
  Sign sign(const Input_metric& input, const Figure& figure, const Expression& expression,
            Values& better, Predicate_statistics& statistics);

  /*!
  \brief encloses the values of faces.
  \param input the input, always the same
  \param faces the input triangles under the faces
  \param bits 53, 106, 256, or any more
  */
  std::vector<Face_values<FT>> enclosures(const Input_metric& input, const Unfolded_faces& faces,
                                          unsigned bits);

  /// Function called with the number of a face in the list, and intervals that contain its values.
  using Visit = std::function<void(std::size_t, const Face_values<FT>&)>;
  /// encloses the values of faces one by one; bits are 106, 256, or any more.
  void for_each_enclosure(const Input_metric& input, const Replayed_faces& faces, unsigned bits,
                          const Visit& visit);

  /// encloses the squared distance of corners i and j of a diamond that is unfolded; see above.
  FT squared_length(const Input_metric& input, const Unfolded_diamond& diamond, unsigned bits);

  /*!
  \brief returns the double nearest to the cotangent weight of a diamond; nothing if so many bits do
  not tell it, as where it is zero.
  \param input, diamond see `sign()`
  \param statistics counts the bits that it took
  \param error relative error with which another double does, too, below 1/2
  \param most_bits, first_bits the most to try, and those to begin with: 106, 256 or more
  \pre with the default, the weight is not zero: then it is always found
  */
  template <class Figure>
  std::optional<double>
  weight(const Input_metric& input, const Figure& diamond, Predicate_statistics& statistics,
         double error = 0, unsigned most_bits = Mpfr_number::most_bits, unsigned first_bits = 106);

  /// repeats flips in 106 bits and returns what it found. \param input see `sign()`
  static Replayed_values<Short_ball> values(const Input_metric& input, Replayed_faces faces);
  /// returns the double nearest to the cotangent weight of a diamond, if its values tell it.
  static std::optional<double> nearest_weight(const Diamond_values<Short_ball>& diamond);

private:
  struct Memory;
  Memory& memory(); // made at its first use

  std::shared_ptr<Memory> memory_; // of this object only
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_EXACT_LADDER_H
