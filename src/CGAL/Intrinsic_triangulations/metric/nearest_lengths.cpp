// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/exact/numbers/Double_double.h>
#include <CGAL/Intrinsic_triangulations/metric/nearest_lengths.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <CGAL/Gmpq.h>
#include <CGAL/number_utils.h>

#include <cstddef>
#include <limits>
#include <string>

namespace CGAL::Intrinsic_triangulations {

namespace {

// The double nearest to a root, found by squaring what lies between doubles. \pre 0 < x < 2^1400
double nearest_root(const Gmpq& x) {
  const Gmpq power(0x1p700);
  const bool is_tiny = x < Gmpq(0x1p-900); // its square root is far above the least double
  const Gmpq y = is_tiny ? x * power * power : x;
  double s = std::sqrt(CGAL::to_double(y));
  const auto is_below_middle = [&](double a, double b) {
    const Gmpq middle = (Gmpq(a) + Gmpq(b)) / Gmpq(2);
    return middle * middle < y;
  };
  for (double up = std::nextafter(s, std::numeric_limits<double>::max()); is_below_middle(s, up);
       up = std::nextafter(s, std::numeric_limits<double>::max()))
    s = up;
  for (double down = std::nextafter(s, 0); !is_below_middle(down, s); down = std::nextafter(s, 0))
    s = down;
  return is_tiny ? std::ldexp(s, -700) : s;
}

// The square of a length in twice the digits, or zero if that is not accurate enough.
Double_double accurate_squared_length(const Input_metric& m, std::uint32_t f, unsigned k) {
  const Input_metric::Sides& s = m.sides(f);
  if (m.has_excess(f)) return 0;
  Double_double sum = m.delta();
  if (m.is_embedded()) {
    const auto &p = m.points()[s[k]], &q = m.points()[s[(k + 1) % 3]];
    for (std::size_t c = 0; c < 3; ++c) {
      const Double_double x = Double_double::difference(p[c], q[c]);
      sum = sum + x * x;
    }
  } else {
    sum = sum + m.squared_lengths()[s[k]];
  }
  const bool is_in_range = sum.to_double() > 0x1p-800 && sum.to_double() < 0x1p800;
  return is_in_range ? sum : 0;
}

double nearest_length(const Input_metric& m, std::uint32_t f, unsigned k) {
  if (const Double_double l = accurate_squared_length(m, f, k); l.to_double() > 0) {
    const Double_double root = sqrt(l);
    const double high = root.to_double(), low = (root - Double_double(high)).to_double();
    if (std::abs(low) < 0x1p-55 * high) return high; // half a unit in the last place is more
    const double next = std::nextafter(high, low > 0 ? std::numeric_limits<double>::max() : 0);
    // the root errs by less than 2^-40 of a unit in the last place
    if (std::abs(low) < (0.5 - 0x1p-30) * std::abs(next - high)) return high;
  }
  const Gmpq exact = m.squared_length<Gmpq>(f, k);
  return CGAL::is_positive(exact) ? nearest_root(exact) : 0;
}

} // namespace

std::vector<double> nearest_lengths(const Input_metric& input, const Gluing_map& mesh) {
  std::vector<double> result(mesh.number_of_edges(), 0);
  for (std::uint32_t f = 0; f < mesh.number_of_faces(); ++f) {
    unsigned k = 0;
    for (const Gluing_map::Halfedge h : mesh.sides({f})) {
      double& length = result[h.index / 2];
      if (length == 0) length = nearest_length(input, f, k);
      if (length == 0)
        throw Invalid_input::about(Element_kind::edge, h.index / 2,
                                   " has length zero; mollify the lengths");
      ++k;
    }
  }
  return result;
}

void check_vertex_factors(std::span<const double> factors, std::uint32_t number) {
  if (factors.size() != number) {
    std::string what = std::to_string(factors.size());
    what += " factors for ";
    what += std::to_string(number);
    what += " vertices; pass one factor for each vertex";
    throw Invalid_input(Element_kind::none, 0, what);
  }
  for (std::size_t v = 0; v < factors.size(); ++v)
    if (!(factors[v] > 0 && factors[v] < std::numeric_limits<double>::infinity()))
      throw Invalid_input::about(Element_kind::vertex, v,
                                 " has a factor that is not positive and finite");
}

} // namespace CGAL::Intrinsic_triangulations
