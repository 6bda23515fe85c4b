// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/exact/numbers/Multiquadratic_number.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Square_class_basis.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/thresholds.h>
#include <CGAL/Intrinsic_triangulations/exact/proofs/Question.h>
#include <CGAL/Intrinsic_triangulations/exact/proofs/field.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Replayed_faces.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/figures.h>
#include <CGAL/Intrinsic_triangulations/formulas/Recorded_expression.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>

#include <CGAL/Gmpq.h>

#include <array>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <unordered_map>
#include <utility>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

namespace {

// A part of a figure over which the expression is zero if and only if it is over the figure.
// Convexity at one end does not depend on where the other one is, which may be across hundreds of
// triangles.
template <class Asked>
const typename Asked::Figure& decisive_part(const Asked& q,
                                            std::optional<typename Asked::Figure>& part) {
  if constexpr (std::is_same_v<typename Asked::Figure, Unfolded_diamond>) {
    const Zero_meaning zero = q.expression.zero_meaning();
    if (zero == Zero_meaning::collinear_at_source) part = q.figure.without(1);
    if (zero == Zero_meaning::collinear_at_target) part = q.figure.without(0);
  }
  return part ? *part : q.figure;
}

// the values of input faces in one field
class Faces_in_field {
  using Number = Multiquadratic_number;
  using Face = std::pair<std::array<Number, 3>, Number>; // squared lengths, quadruple area

public:
  explicit Faces_in_field(const Input_metric& input) : input_(input) {
    basis_.limit_products(thresholds::pairs_of_terms);
  }
  const Face& operator()(std::uint32_t f) const {
    const auto found = faces_.find(f);
    return found != faces_.end() ? found->second : faces_.emplace(f, face(f)).first->second;
  }

private:
  Face face(std::uint32_t f) const {
    const auto length = [&](unsigned k) { return Number(input_.squared_length<Gmpq>(f, k)); };
    const auto area = basis_.sqrt_of(input_.squared_quadruple_area<Gmpq>(f));
    if (!area) throw std::length_error("too many square roots");
    return {{length(0), length(1), length(2)}, Number(basis_, *area)};
  }

  const Input_metric& input_;
  mutable Square_class_basis basis_;
  mutable std::unordered_map<std::uint32_t, Face> faces_;
};

} // namespace

} // namespace internal

template <class Figure, class Expression>
  requires(!std::is_same_v<Figure, Flat_diamond>)
Answer Field_proof::operator()(const Question<Figure, Expression>& q) const {
  std::optional<Figure> part;
  const Figure& figure = internal::decisive_part(q, part);
  const internal::Faces_in_field faces(q.input);
  try {
    const auto value = q.expression(figure.template values<Multiquadratic_number>(faces));
    return value.is_zero() ? Answer::zero : Answer::not_zero;
  } catch (const std::length_error&) {
    return Answer::open;
  }
}

template Answer
Field_proof::operator()(const Question<Input_diamond, Recorded_diamond_expression>&) const;
template Answer
Field_proof::operator()(const Question<Unfolded_diamond, Recorded_diamond_expression>&) const;
template Answer
Field_proof::operator()(const Question<Replayed_diamond, Recorded_diamond_expression>&) const;
template Answer
Field_proof::operator()(const Question<Unfolded_faces, Recorded_face_expression>&) const;
template Answer
Field_proof::operator()(const Question<Replayed_faces, Recorded_face_expression>&) const;

} // namespace CGAL::Intrinsic_triangulations
