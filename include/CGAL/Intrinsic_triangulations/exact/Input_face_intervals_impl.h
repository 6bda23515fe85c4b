// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_EXACT_INPUT_FACE_INTERVALS_IMPL_H
#define CGAL_INTRINSIC_TRIANGULATIONS_EXACT_INPUT_FACE_INTERVALS_IMPL_H

#include <CGAL/Intrinsic_triangulations/exact/Input_face_intervals.h>
#include <CGAL/Intrinsic_triangulations/exact/escalation.h>
#include <CGAL/Intrinsic_triangulations/formulas/triangle_formulas.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>

#include <CGAL/Gmpfi.h>
#include <CGAL/Gmpq.h>

#include <array>
#include <cstdint>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

template <class FT>
std::pair<std::array<FT, 3>, FT> wide_face(const Input_metric& input, std::uint32_t f) {
  const typename FT::Precision_type bits = FT::get_default_precision();
  const Gmpfi_precision wide(static_cast<unsigned>(2 * bits + 64));
  const std::array<FT, 3> l = {input.squared_length<FT>(f, 0), input.squared_length<FT>(f, 1),
                               input.squared_length<FT>(f, 2)};
  FT d = squared_quadruple_area(l[0], l[1], l[2]);
  if (!(d.inf() > 0)) d = FT(input.squared_quadruple_area<Gmpq>(f));
  return {{FT(l[0], bits), FT(l[1], bits), FT(l[2], bits)}, FT(d.sqrt(), bits)};
}

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_EXACT_INPUT_FACE_INTERVALS_IMPL_H
