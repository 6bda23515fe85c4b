// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/exact/proofs/flat.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/extrinsic/extrinsic_delaunay.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>

#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

namespace {

// Whether the surface stays straight in space when an inner edge is flipped.
class Bend_test {
public:
  explicit Bend_test(const Input& input) : input_(input) {}

  bool operator()(std::uint32_t h) const {
    if (input_.is_border(h) || input_.is_border(h ^ 1U)) return true;
    if (is_base_of_cap(h) || is_base_of_cap(h ^ 1U)) return false;
    const std::uint32_t f = input_.face(h), g = input_.face(h ^ 1U);
    return !(input_.quadruple_area(f) > 0) ||
           !are_coplanar(input_.metric(), f, g, apex_slot(h ^ 1U));
  }

private:
  // A face without area lies in the long one of its sides; a flip gives both halves to the
  // neighbour.
  bool is_base_of_cap(std::uint32_t h) const {
    if (input_.quadruple_area(input_.face(h)) > 0) return false;
    const std::uint32_t n = input_.next(h), l = input_.next(n);
    const double base = input_.squared_length(h / 2);
    return base > input_.squared_length(n / 2) && base > input_.squared_length(l / 2);
  }
  // the slot in the metric of the corner behind a halfedge
  std::uint32_t apex_slot(std::uint32_t h) const {
    const Input_metric::Sides& corners = input_.metric().sides(input_.face(h));
    const std::uint32_t apex = input_.source(input_.next(input_.next(h)));
    return static_cast<std::uint32_t>(corners[0] == apex ? 0 : corners[1] == apex ? 1 : 2);
  }

  const Input& input_;
};

} // namespace

} // namespace internal

std::vector<char> bent_edges(const Input& input) {
  if (!input.metric().is_in_space())
    throw Invalid_input(Element_kind::none, 0,
                        "an extrinsic triangulation needs a mesh in space whose lengths are those "
                        "of its points; build it with `Mollification::none`");
  const internal::Bend_test is_bent(input);
  std::vector<char> result;
  for (std::uint32_t e = 0; e < input.number_of_edges(); ++e) result.push_back(is_bent(2 * e));
  return result;
}

} // namespace CGAL::Intrinsic_triangulations
