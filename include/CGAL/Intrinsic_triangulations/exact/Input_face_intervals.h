// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_INPUT_FACE_INTERVALS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_INPUT_FACE_INTERVALS_H

#include <CGAL/Intrinsic_triangulations/exact/numbers/Ball.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Double_double.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/input/initial_values.h>

#include <CGAL/Interval_nt.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
class Gmpfi;
}

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// More bits leave enough of them where a thin face loses some; rational numbers, which take ten times as
// long, do the rest. See `Input_face_intervals_impl.h`.
template <class FT>
std::pair<std::array<FT, 3>, FT> wide_face(const Input_metric& input, std::uint32_t f);

} // namespace internal

/*!
\brief encloses the squared lengths and the quadruple areas of input faces, and remembers them.
\tparam FT `Interval_nt<false>`, a `Ball`, or `Gmpfi` of one precision, which is the default precision of all
calls; rounding is as the type asks for
*/
template <class FT>
class Input_face_intervals {
public:
  /// Encloses a number.
  using Number = FT;
  /// Squared lengths and quadruple area of a face.
  using Face = std::pair<std::array<FT, 3>, FT>;

  /// returns a functor from a face to its values; references stay valid until the next call.
  auto of(const Input_metric& input) {
    if (number_of_pages_ > maximal_pages) {
      pages_.clear();
      number_of_pages_ = 0;
    }
    pages_.resize(input.number_of_faces() / page_size + 1);
    return [&input, this](std::uint32_t f) -> const Face& {
      std::optional<Face>& known = page(f / page_size)[f % page_size];
      return known ? *known : known.emplace(face(input, f));
    };
  }

private:
  static constexpr std::uint32_t page_size = 16;
  // numbers of many bits take up to a kilobyte per face
  static constexpr std::size_t maximal_pages = std::is_same_v<FT, Gmpfi> ? 4000 : 1U << 31;

  using Page = std::vector<std::optional<Face>>; // empty until a face is asked for

  Page& page(std::uint32_t number) {
    Page& p = pages_[number];
    if (p.empty()) {
      p.resize(page_size);
      ++number_of_pages_;
    }
    return p;
  }

  static Face face(const Input_metric& input, std::uint32_t f) {
    if constexpr (std::is_same_v<FT, Gmpfi>)
      return internal::wide_face<FT>(input, f);
    else if constexpr (std::is_same_v<FT, Interval_nt<false>>)
      return {lengths(input, f), narrow_area(input, f)};
    else
      return {lengths(input, f), sqrt(squared_area<FT>(input, f))};
  }

  template <class Number>
  static Number squared_area(const Input_metric& input, std::uint32_t f) {
    return input.is_embedded() ? internal::Embedded_area<Number>(input, f).squared
                               : input.squared_quadruple_area<Number>(f);
  }

  // Errors of areas are where most of those of unfolded points come from.
  static FT narrow_area(const Input_metric& input, std::uint32_t f) {
    const auto compute = [&] { return squared_area<Ball<Double_double>>(input, f); };
    const FT squared = internal::to_nearest(compute).interval();
    return squared.sup() - squared.inf() <= 0x1p-50 * squared.sup() ? CGAL::sqrt(squared)
                                                                    : quadruple_area<FT>(input, f);
  }

  static std::array<FT, 3> lengths(const Input_metric& input, std::uint32_t f) {
    return {input.squared_length<FT>(f, 0), input.squared_length<FT>(f, 1),
            input.squared_length<FT>(f, 2)};
  }

  std::vector<Page> pages_;
  std::size_t number_of_pages_ = 0;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_INPUT_FACE_INTERVALS_H
