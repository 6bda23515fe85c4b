// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Insertion_placer.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Unfolded_face.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/exact/Input_face_intervals.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Ball.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Double_double.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Mpfr_number.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Vertex_star.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Moves.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <CGAL/Interval_nt.h>

#include <array>
#include <cstddef>
#include <optional>

namespace CGAL::Intrinsic_triangulations {

void Insertion_placer::forget_unfolded() {
  short_.is_unfolded = false;
  for (auto& [bits, numbers] : long_) numbers.is_unfolded = false;
}

std::optional<Seen_corner> Insertion_placer::seen_corner(const Input& input) const {
  const auto seen_in = [&](const auto& face) { return face.farthest_corner(input, place_); };
  if (!face_.is_vague()) return seen_in(face_);
  if (!short_.is_unfolded) return std::nullopt;
  return internal::to_nearest([&] { return seen_in(short_.face); });
}

std::array<double, 3> Insertion_placer::inside(std::array<double, 3> w, double distance) {
  double before = 0, after = 0; // of the weights that are raised
  for (double& x : w)
    if (x < distance) before += x, after += distance;
  for (double& x : w)
    x = x < distance ? distance : after > 0 ? x * ((1 - after) / (1 - before)) : x;
  return w;
}

bool Insertion_placer::are_positive(bool along_side) const {
  for (std::size_t k = 0; k < 3; ++k)
    if (!(values_.squared_lengths[k].inf() > 0) ||
        (!(values_.quadruple_areas[k].inf() > 0) && !(along_side && k == 0)))
      return false;
  return true;
}

bool Insertion_placer::is_open(bool along_side) const {
  for (const FT& area : values_.quadruple_areas)
    if (area.sup() < 0) return false;
  return !are_positive(along_side);
}

Unfolded_face<Insertion_placer::FT>::Values Insertion_placer::values_of(const Input& input) {
  return internal::values_from(input, intervals_.of(input.metric()));
}

Vertex_move_values<Short_ball> Insertion_placer::short_values(const Input& input) {
  Vertex_move_values<Short_ball> result = internal::to_nearest([&] {
    unfold(short_, input);
    return short_.face.values(place_);
  });
  if (is_along_side_) result.quadruple_areas[0] = 0.;
  return result;
}

template <class Center>
void Insertion_placer::unfold(Numbers<Center>& numbers, const Input& input) {
  if (numbers.is_unfolded) return;
  numbers.face.unfold(face_, internal::values_from(input, numbers.input.of(input.metric())));
  numbers.is_unfolded = true;
}

template <class Center>
void Insertion_placer::find_values(Numbers<Center>& numbers, const Input& input, bool along_side) {
  const Vertex_move_values<Ball<Center>> wide = internal::to_nearest([&] {
    unfold(numbers, input);
    return numbers.face.values(place_);
  });
  for (std::size_t k = 0; k < 3; ++k) {
    values_.squared_lengths[k] = wide.squared_lengths[k].interval();
    if (!along_side || k > 0) values_.quadruple_areas[k] = wide.quadruple_areas[k].interval();
  }
}

void Insertion_placer::find_values(unsigned bits, const Input& input, bool along_side) {
  bits == 106 ? find_values(short_, input, along_side)
              : find_values(long_[bits], input, along_side);
}

template void Insertion_placer::unfold(Numbers<Double_double>&, const Input&);

} // namespace CGAL::Intrinsic_triangulations
