// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_conformal/layout/Developer.h>
#include <CGAL/Intrinsic_conformal/layout/Plane_pieces.h>
#include <CGAL/Intrinsic_conformal/layout/lay_out_in_plane.h>
#include <CGAL/Intrinsic_geodesics/cuts/cut_open.h>
#include <CGAL/Intrinsic_geodesics/cuts/cut_to_disk.h>
#include <CGAL/Intrinsic_operators/parametrization/certify_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/formulas/apex.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

namespace {

// The square of four times the area of a triangle, with a small relative error even if it is nearly
// a segment (Kahan, Miscalculating area and angles of a needle-like triangle, 2014).
double squared_quadruple_area_of(std::array<double, 3> lengths) {
  std::sort(lengths.begin(), lengths.end());
  const auto [c, b, a] = lengths;
  return (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c));
}

Invalid_input no_triangle(std::uint32_t f) {
  return Invalid_input::about(Element_kind::face, f,
                              " has sides of which no triangle consists; give lengths that are "
                              "finite and satisfy the triangle inequality");
}

// The sides of a triangle of given lengths. The greatest may be longer than the others together by
// rounding of the lengths.
std::array<std::complex<double>, 3> sides_of_triangle(const Surface_to_cut& s, std::uint32_t f) {
  const double* l = s.length.data() + 3 * std::size_t{f};
  const double longest = std::max({l[0], l[1], l[2]}), least = std::min({l[0], l[1], l[2]});
  const int e = longest > 0 && std::isfinite(longest) ? std::ilogb(longest) : 0;
  std::array<double, 3> lengths, squares;
  for (std::size_t k = 0; k < 3; ++k) {
    lengths[k] = std::ldexp(l[k], -e);
    squares[k] = lengths[k] * lengths[k];
  }
  double area = squared_quadruple_area_of(lengths);
  // lengths to the fourth power, of which the greatest is between 1 and 16: 1e-14 is rounding
  if (!(least > 0) || !std::isfinite(longest) || !(area >= -1e-14)) throw no_triangle(f);
  area = std::sqrt(std::max(area, 0.));
  std::array<std::complex<double>, 3> result;
  const Plane_sides sides =
      CGAL::Intrinsic_triangulations::planar_sides(squares[0], squares[1], squares[2], area);
  for (std::size_t k = 0; k < 3; ++k)
    result[k] = {std::ldexp(sides[k].x, e), std::ldexp(sides[k].y, e)};
  return result;
}

// The triangles of a surface that was cut open as pieces.
Plane_pieces triangles_as_pieces(const Gluing& g, std::vector<std::complex<double>> sides) {
  Plane_pieces p{pieces_of(g), std::move(sides), {}};
  p.turn.assign(p.side.size(), 1);
  for (std::size_t h = 0; h < p.glue.size(); ++h)
    if (p.glue[h] != Gluing::none) p.turn[h] = turn_across(p.side[h], p.side[p.glue[h]]);
  return p;
}

// where a side starts
std::complex<double> place(const Flat_layout& layout, std::uint32_t h) {
  return point_of_row(layout.positions, layout.surface.gluing.origin[h]);
}

// A seam of a layout, with its motion.
Layout_seam with_motion(Border_seam found, const Flat_layout& layout, const Plane_pieces& pieces,
                        const Developed<Plane_pieces>& developed) {
  const auto side = [&](std::uint32_t h) { return developed.frame[h / 3] * pieces.side[h]; };
  Layout_seam seam{std::move(found.sides), std::move(found.partners)};
  std::complex<double> turn = 0, shift = 0;
  for (std::size_t i = 0; i < seam.sides.size(); ++i)
    turn -= side(seam.partners[i]) * std::conj(side(seam.sides[i]));
  turn /= std::abs(turn);
  for (std::size_t i = 0; i < seam.sides.size(); ++i)
    shift += place(layout, Gluing::next(seam.partners[i])) - turn * place(layout, seam.sides[i]);
  shift /= static_cast<double>(seam.sides.size());
  seam.rotation = std::arg(turn);
  seam.translation = {shift.real(), shift.imag()};
  return seam;
}

} // namespace

std::vector<std::array<double, 2>> vectors_of_triangles(const std::vector<Double_double>& lengths,
                                                        int scale_exponent) {
  std::vector<std::array<double, 2>> result;
  const auto add = [&](const Double_double& x, const Double_double& y) {
    result.push_back(
        {std::ldexp(x.to_double(), -scale_exponent), std::ldexp(y.to_double(), -scale_exponent)});
  };
  for (std::size_t h = 0; h < lengths.size(); h += 3) {
    const Double_double &a = lengths[h], &b = lengths[h + 1], &c = lengths[h + 2];
    const Double_double x = (a + (c - b) * ((c + b) / a)) * 0.5; // of the apex
    // (a + b + c) (b + c - a) (c + a - b) (a + b - c) is 16 times the squared area
    const Double_double product = ((b - a) + c) * ((c - b) + a) * ((a - c) + b) * (a + b + c),
                        y = product.to_double() > 0 ? sqrt(product) / (a + a) : Double_double();
    add(a, 0);
    add(x - a, y);
    add(-x, -y);
  }
  return result;
}

std::complex<double> turn_across(std::complex<double> side, std::complex<double> partner) {
  // of sides below 1e-154, the product would be too small for doubles
  const auto scaled = [](std::complex<double> z) {
    const double r = std::abs(z);
    const int e = r > 0 && std::isfinite(r) ? -std::ilogb(r) : 0;
    return std::complex<double>(std::ldexp(z.real(), e), std::ldexp(z.imag(), e));
  };
  const std::complex<double> turn = -scaled(side) * std::conj(scaled(partner));
  return turn / std::abs(turn);
}

std::vector<std::complex<double>> sides_of_triangles(const Surface_to_cut& s) {
  std::vector<std::complex<double>> result;
  result.reserve(s.length.size());
  for (const auto& [x, y] : s.vector) {
    if (!std::isnormal(std::hypot(x, y)))
      throw Invalid_input::about(Element_kind::face, static_cast<std::uint32_t>(result.size() / 3),
                                 " has sides that are too long or too short for doubles; the scale "
                                 "factors of its vertices differ too much");
    result.emplace_back(x, y);
  }
  if (!result.empty()) return result;
  for (std::uint32_t f = 0; f < s.gluing.number_of_faces(); ++f)
    for (const std::complex<double>& side : sides_of_triangle(s, f)) result.push_back(side);
  return result;
}

static double seam_error(const Flat_layout& layout) {
  if (layout.positions.rows() == 0) return 0;
  const double extent =
      (layout.positions.colwise().maxCoeff() - layout.positions.colwise().minCoeff()).norm();
  double largest = 0;
  for (const Layout_seam& seam : layout.seams) {
    const std::complex<double> turn = std::polar(1., seam.rotation),
                               shift(seam.translation[0], seam.translation[1]);
    for (std::size_t i = 0; i < seam.sides.size(); ++i) {
      const std::uint32_t h = seam.sides[i], p = seam.partners[i];
      for (const auto& [from, to] : {std::array{h, Gluing::next(p)}, {Gluing::next(h), p}}) {
        const std::complex<double> moved = turn * place(layout, from) + shift;
        largest = std::max(largest, std::abs(moved - place(layout, to)));
      }
    }
  }
  return extent > 0 ? largest / extent : largest;
}

} // namespace internal

Flat_layout lay_out_in_plane(const Surface_to_cut& s, std::span<const std::uint32_t> cones,
                             std::size_t roots) {
  internal::expect_oriented(s.gluing);
  Flat_layout result;
  result.surface = cut_open(s.gluing, cut_to_disk(s, cones, roots));
  const internal::Plane_pieces pieces =
      internal::triangles_as_pieces(result.surface.gluing, internal::sides_of_triangles(s));
  const auto developed = internal::develop(pieces);
  result.positions = developed.rows();
  result.largest_side_error = developed.largest_error;
  for (internal::Border_seam& seam :
       internal::seams_of(result.surface, pieces, internal::copies_of(result.surface, cones)))
    result.seams.push_back(internal::with_motion(std::move(seam), result, pieces, developed));
  result.largest_seam_error = internal::seam_error(result);
  return result;
}

Map_certificate certify_map(const Flat_layout& layout) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  const std::vector<std::uint32_t>& origin = layout.surface.gluing.origin;
  for (std::size_t h = 0; h < origin.size(); h += 3)
    triangles.push_back({origin[h], origin[h + 1], origin[h + 2]});
  return certify_map(triangles, layout.positions);
}

} // namespace CGAL::Intrinsic_triangulations
