// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Ball.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Double_double.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Flip_list.h>
#include <CGAL/Intrinsic_triangulations/exact/unfolding/Replayed_faces.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

Flipped_values<Short_ball> flipped(const Diamond_values<Short_ball>& d, double e) {
  using Number = Double_double;
  constexpr double tiny = 0x1p-1000; // what underflows
  const auto size = [](const Number& x) { return std::abs(x.magnitude()); };
  const auto sum = [](const Number& u, const Number& v) { return Number::rough_sum(u, v); };
  const Number &l = d.ij.center(), &f = d.area_f.center(), &g = d.area_g.center();
  const double r_l = d.ij.radius(), r_f = d.area_f.radius(), r_g = d.area_g.radius(),
               least = l.magnitude() * (1 - 0x1p-48) - r_l;
  if (!(least > 0)) { // the edge may have no length
    const Short_ball any = Short_ball::around(0, std::numeric_limits<double>::infinity());
    return {any, any, any};
  }

  const Number m = sum(d.mj.center(), -d.im.center()), k = sum(d.jk.center(), -d.ki.center()),
               x = sum(m, -k), y = sum(f, g), s = sum(x * x, y * y), n = sum(f * m, g * k),
               quarter = Number(0.25) / l, km = s * quarter, half = y.scaled(0.5),
               w = (n * quarter).scaled(2);
  const auto radius_of_sum = [&](const Ball<Number>& u, const Ball<Number>& v) {
    return u.radius() + v.radius() + e * (size(u.center()) + size(v.center()));
  };
  const double r_m = radius_of_sum(d.mj, d.im), r_k = radius_of_sum(d.jk, d.ki),
               r_x = r_m + r_k + e * (size(m) + size(k)), r_y = radius_of_sum(d.area_f, d.area_g);
  const double r_s = (2 * size(x) + r_x) * r_x + (2 * size(y) + r_y) * r_y + 2 * e * size(s),
               r_n = size(f) * r_m + (size(m) + r_m) * r_f + size(g) * r_k + (size(k) + r_k) * r_g +
                     2 * e * (size(f) * size(m) + size(g) * size(k));
  const double r_km = (0.25 * r_s + size(km) * r_l + tiny) / least + 2 * e * size(km),
               r_w = (0.5 * r_n + size(w) * r_l + tiny) / least + 2 * e * size(w),
               r_area = 0.5 * r_y + r_w + e * (size(half) + size(w));
  return {Ball<Number>::around(km, r_km), Ball<Number>::around(sum(half, w), r_area),
          Ball<Number>::around(sum(half, -w), r_area)};
}

Short_ball weight_in_106_bits(const Diamond_values<Short_ball>& d) {
  using Number = Double_double;
  constexpr double e = Double_double::rounding(), tiny = 0x1p-1000; // what underflows
  const auto size = [](const Number& x) { return std::abs(x.magnitude()); };
  struct Enclosed {
    Number center;
    double radius;
  };
  const auto numerator = [&](const Short_ball& u, const Short_ball& v) {
    const Number &x = u.center(), &y = v.center(), &l = d.ij.center();
    return Enclosed{Number::rough_sum(Number::rough_sum(x, y), -l),
                    u.radius() + v.radius() + d.ij.radius() +
                        2 * e * (size(x) + size(y) + size(l))};
  };
  const auto product = [&](const Enclosed& u, const Short_ball& v) {
    const double a = size(v.center()), r = v.radius();
    return Enclosed{u.center * v.center(),
                    size(u.center) * (r + e * a) + (a + r) * u.radius + tiny};
  };
  const Enclosed s = product(numerator(d.jk, d.ki), d.area_g),
                 t = product(numerator(d.im, d.mj), d.area_f),
                 areas = product({d.area_f.center(), d.area_f.radius()}, d.area_g);
  const double least = areas.center.magnitude() * (1 - 0x1p-48) - areas.radius;
  if (!(least > 0)) return Short_ball::around(0, std::numeric_limits<double>::infinity());
  const Number w = (Number::rough_sum(s.center, t.center) / areas.center).scaled(0.5);
  const double r = s.radius + t.radius + e * (size(s.center) + size(t.center));
  return Short_ball::around(w, (0.5 * r + size(w) * areas.radius) / least * (1 + 0x1p-40) +
                                   2 * e * size(w));
}

Replayed_faces::Replayed_faces(const Input_definition& input, Gluing_map mesh,
                               const Flip_list& flips, std::vector<Indexed_face> faces)
    : input_(&input), flips_(&flips), is_needed_(flips.size()), faces_(std::move(faces)) {
  std::vector<char> is_needed(mesh.number_of_faces(), 0);
  for (const Indexed_face& f : faces_) is_needed[f.face] = 1;
  mesh_ = flips.undone(std::move(mesh), [&](std::size_t n, const Gluing_map& after) {
    char& f = is_needed[after.face(flips[n]).index];
    char& g = is_needed[after.face(Gluing_map::opposite(flips[n])).index];
    if (f == 0 && g == 0) return;
    f = g = 1;
    is_needed_[n] = true;
    ++size_;
  });
}

} // namespace CGAL::Intrinsic_triangulations
