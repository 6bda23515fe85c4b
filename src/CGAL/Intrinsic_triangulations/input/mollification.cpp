// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/input/Input_metric.h>
#include <CGAL/Intrinsic_triangulations/input/mollification.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <CGAL/Gmpq.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

bool has_edge_without_length(const Input_metric& input) {
  for (std::uint32_t f = 0; f < input.number_of_faces(); ++f)
    for (unsigned k = 0; k < 3; ++k)
      if (!(input.squared_length<double>(f, k) > 0x1p-900) && // else rounding cannot hide it
          input.squared_length<Gmpq>(f, k) == Gmpq(0))
        return true;
  return false;
}

std::vector<double> edge_lengths(const Gluing_map& mesh, const Input_metric& input) {
  std::vector<double> lengths(mesh.number_of_edges(), 0);
  for (std::uint32_t f = 0; f < mesh.number_of_faces(); ++f) {
    const std::array<Gluing_map::Halfedge, 3> h = mesh.sides({f});
    for (unsigned k = 0; k < 3; ++k)
      lengths[h[k].index / 2] = std::sqrt(input.squared_length<double>(f, k));
  }
  return lengths;
}

// Calls f(a, b, c) for the lengths of the sides of each face, three times, each one last once.
template <class Function>
static void for_each_side_of_faces(const Gluing_map& mesh, const std::vector<double>& lengths,
                                   Function f) {
  for (std::uint32_t i = 0; i < mesh.number_of_faces(); ++i) {
    const std::array<Gluing_map::Halfedge, 3> h = mesh.sides({i});
    for (std::size_t k = 0; k < 3; ++k)
      f(lengths[h[k].index / 2], lengths[h[(k + 1) % 3].index / 2],
        lengths[h[(k + 2) % 3].index / 2]);
  }
}

double mollifying_epsilon(const Gluing_map& mesh, const std::vector<double>& lengths,
                          double delta) {
  double epsilon = 0;
  for_each_side_of_faces(mesh, lengths, [&](double a, double b, double c) {
    epsilon = std::max(epsilon, delta - a - b + c);
  });
  return epsilon;
}

bool has_nearly_degenerate_face(const Gluing_map& mesh, const std::vector<double>& lengths) {
  bool result = false;
  for_each_side_of_faces(mesh, lengths, [&](double a, double b, double c) {
    result = result || !(a + b - c > 0x1p-30 * c);
  });
  return result;
}

Input_metric mollify_lengths(const Gluing_map& mesh, const Input_metric& input, double delta,
                             double& epsilon) {
  std::vector<double> lengths = edge_lengths(mesh, input);
  epsilon = mollifying_epsilon(mesh, lengths, delta);
  if (epsilon <= 0) return input;
  for (double& x : lengths) x = (x + epsilon) * (x + epsilon);
  return Input_metric::from_squared_lengths(mesh, std::move(lengths), input.scale_exponent());
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations
