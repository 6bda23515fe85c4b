// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_conformal/layout/Developer.h>
#include <CGAL/Intrinsic_conformal/layout/Glued_pieces.h>
#include <CGAL/Intrinsic_conformal/layout/flat_torus.h>
#include <CGAL/Intrinsic_conformal/layout/lay_out_in_plane.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <complex>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

namespace {

void check_flatness(const Flat_layout& layout) {
  double largest = layout.largest_side_error;
  for (const Layout_seam& seam : layout.seams) largest = std::max(largest, std::abs(seam.rotation));
  if (!(largest <= 1e-6))
    throw Invalid_input(Element_kind::none, 0,
                        "the torus is not flat: triangles beside each other differ by " +
                            std::to_string(largest) +
                            "; scale it until the angles at all vertices sum to 2 pi");
}

// Those of two seams; a cut of a torus has two or three, and any two of three generate the other.
std::array<std::complex<double>, 2> translations_of(const Flat_layout& layout) {
  std::vector<std::complex<double>> all;
  for (const Layout_seam& seam : layout.seams)
    all.emplace_back(seam.translation[0], seam.translation[1]);
  return {all[0], all[1]};
}

// Makes the translations as short as possible, and the second one to the left of the first.
std::array<std::complex<double>, 2> reduced(std::array<std::complex<double>, 2> basis) {
  auto& [a, b] = basis;
  for (int n = 0; n < 1000; ++n) { // lengths fall at least by sqrt(3) but at the end
    if (std::norm(b) < std::norm(a)) std::swap(a, b);
    const double times = std::round(std::real(b / a));
    if (times == 0) break;
    b -= times * a;
  }
  if (std::imag(b / a) < 0) b = -b;
  constexpr double slack = 1e-9; // among bases as short, as of a square, rounding must not choose
  if (std::real(b / a) < -0.5 + slack) b += a;
  if (const auto p = b / a; std::abs(p) < 1 + slack && std::real(p) < 0)
    basis = {b, -a}; // turned by a quarter in the basis: -1 / p
  return basis;
}

// Coordinates in the basis of the translations. Copies of a vertex differ by integers.
Eigen::MatrixX2d coordinates_in(const std::array<std::complex<double>, 2>& basis,
                                const Flat_layout& layout) {
  const auto cross = [](std::complex<double> p, std::complex<double> q) {
    return std::imag(std::conj(p) * q);
  };
  const double area = cross(basis[0], basis[1]);
  Eigen::MatrixX2d result(layout.positions.rows(), 2);
  for (Eigen::Index v = 0; v < result.rows(); ++v) {
    const std::complex<double> z = point_of_row(layout.positions, v);
    result.row(v) << cross(z, basis[1]) / area, cross(basis[0], z) / area;
  }
  for (std::size_t v = 0; v < layout.surface.original_vertex.size(); ++v) {
    const auto row = static_cast<Eigen::Index>(v),
               first = static_cast<Eigen::Index>(layout.surface.original_vertex[v]);
    for (Eigen::Index c = 0; c < 2; ++c)
      result(row, c) = result(first, c) + std::round(result(row, c) - result(first, c));
  }
  return result;
}

void turn_layout(Flat_layout& layout, std::complex<double> by) {
  Eigen::Matrix2d rotation;
  rotation << by.real(), -by.imag(), by.imag(), by.real();
  layout.positions = layout.positions * rotation.transpose();
  for (Layout_seam& seam : layout.seams) {
    const std::complex<double> t =
        by * std::complex<double>(seam.translation[0], seam.translation[1]);
    seam.translation = {t.real(), t.imag()};
  }
}

} // namespace

Flat_torus lay_out_torus(const Surface_to_cut& s, std::size_t roots, bool is_flat) {
  expect_closed(s.gluing, 1, "torus");
  Flat_torus result;
  result.layout = lay_out_in_plane(s, {}, roots);
  if (!is_flat) check_flatness(result.layout);
  result.translations = reduced(translations_of(result.layout));
  const std::complex<double> direction = result.translations[0] / std::abs(result.translations[0]);
  turn_layout(result.layout, std::conj(direction));
  for (std::complex<double>& t : result.translations) t *= std::conj(direction);
  result.period = result.translations[1] / result.translations[0];
  result.coordinates = coordinates_in(result.translations, result.layout);
  return result;
}

} // namespace internal

Flat_torus flat_torus(const Surface_to_cut& s, std::size_t roots) {
  return internal::lay_out_torus(s, roots, false);
}

} // namespace CGAL::Intrinsic_triangulations
