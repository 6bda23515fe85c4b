// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_HISTORY_ZERO_TEST_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_HISTORY_ZERO_TEST_H

#include <CGAL/Intrinsic_triangulations/exact/Field_zero_test.h>
#include <CGAL/Intrinsic_triangulations/exact/Zero_answer.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Integer_faces.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Multiquadratic_number.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Flip_history.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/History_evaluator.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Recorded_expression.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>

#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief decides whether an expression in the values of faces is exactly zero, by repeating the flips that made
them: see `Field_zero_test`.
*/
class History_zero_test {
public:
  /// prepares the test of values of the diamond between two sides; all must outlive the test.
  History_zero_test(const Input_metric& input, const Flip_history& history, Flip_history::Side left,
                    Flip_history::Side right)
      : History_zero_test(input, history, {left, right}) {}

  /// prepares the test of values of faces, each from a side on; all must outlive the test.
  History_zero_test(const Input_metric& input, const Flip_history& history,
                    std::vector<Flip_history::Side> sides)
      : history_(history), sides_(std::move(sides)), is_zero_(input, integers_) {}
  History_zero_test(const History_zero_test&) = delete;
  History_zero_test& operator=(const History_zero_test&) = delete;

  /// decides about an expression in the values of a diamond. \pre the test is that of a diamond
  Zero_answer operator()(const Recorded_diamond_expression& expression) {
    return is_zero_([&](const auto& input_faces) {
      const auto faces = values(input_faces);
      return expression(diamond_values(faces[0], faces[1]));
    });
  }

  /// decides about an expression in the values of the faces.
  Zero_answer for_faces(const Recorded_face_expression& expression) {
    return is_zero_([&](const auto& input_faces) { return expression(values(input_faces)); });
  }

  /*!
  \brief computes the values of the diamond exactly.
  \return numbers that are valid as long as this object
  */
  Diamond_values<Multiquadratic_number> exact_values() {
    const auto faces = values(is_zero_.exact_faces());
    return diamond_values(faces[0], faces[1]);
  }

private:
  template <class Faces>
  std::vector<Face_values<typename Faces::Number>> values(const Faces& input_faces) const {
    using Number = typename Faces::Number;
    History_values<Number> memory;
    return History_evaluator<Number, Faces>(history_, input_faces, memory).faces(sides_);
  }

  const Flip_history& history_;
  std::vector<Flip_history::Side> sides_;
  Integer_faces integers_;
  Field_zero_test is_zero_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_HISTORY_ZERO_TEST_H
