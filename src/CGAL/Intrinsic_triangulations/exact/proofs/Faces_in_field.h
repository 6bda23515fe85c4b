// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_PROOFS_FACES_IN_FIELD_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_PROOFS_FACES_IN_FIELD_H

#include <CGAL/Intrinsic_triangulations/exact/numbers/Square_class_basis.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>

#include <CGAL/Gmpq.h>

#include <array>
#include <cstdint>
#include <stdexcept>
#include <unordered_map>

namespace CGAL::Intrinsic_triangulations::internal {

// The values of input faces in one field, where roots are those of a basis.
class Faces_in_field {
public:
  struct Face {
    std::array<Gmpq, 3> squared_lengths;
    Square_root area; // quadruple
  };

  explicit Faces_in_field(const Input_metric& input) : input_(input) {}

  // throws std::length_error if there are too many roots
  const Face& operator()(std::uint32_t f) {
    const auto found = faces_.find(f);
    return found != faces_.end() ? found->second : faces_.emplace(f, face(f)).first->second;
  }
  Square_class_basis& basis() { return basis_; }

private:
  Face face(std::uint32_t f) {
    const auto area = basis_.sqrt_of(input_.squared_quadruple_area<Gmpq>(f));
    if (!area) throw std::length_error("too many square roots");
    return {{input_.squared_length<Gmpq>(f, 0), input_.squared_length<Gmpq>(f, 1),
             input_.squared_length<Gmpq>(f, 2)},
            *area};
  }

  const Input_metric& input_;
  Square_class_basis basis_;
  std::unordered_map<std::uint32_t, Face> faces_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_PROOFS_FACES_IN_FIELD_H
