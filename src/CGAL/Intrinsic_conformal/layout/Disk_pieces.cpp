// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_conformal/angles/Ideal_surface.h>
#include <CGAL/Intrinsic_conformal/angles/triangle_angles.h>
#include <CGAL/Intrinsic_conformal/layout/Developer.h>
#include <CGAL/Intrinsic_conformal/layout/Disk_pieces.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

Disk_motion rotation_about_centre(double angle) { return {std::polar(1., angle / 2), 0}; }

// Restores |a|^2 - |b|^2 = 1, which products lose by rounding, without subtraction.
Disk_motion normalised(Disk_motion m) {
  m.a *= std::sqrt(1 + std::norm(m.b)) / std::abs(m.a);
  return m;
}

// The motion that takes a point to the centre.
Disk_motion to_centre(const Disk_point& p) {
  const double a = 1 / std::sqrt(p.gap);
  return {a, -p.z * a};
}

} // namespace

Disk_motion translation_along_axis(double distance) {
  return {std::cosh(distance / 2), std::sinh(distance / 2)};
}

double place_on_axis(double length, double part) {
  const double half = std::sinh(length / 2), square = half * half;
  const double time = 1 + 2 * part * square, norm = std::sqrt(1 + 4 * part * (1 - part) * square);
  return part * std::sinh(length) / (time + norm);
}

std::vector<Disk_motion> frames_of_sides(const Surface_to_cut& s) {
  std::vector<Disk_motion> result;
  result.reserve(s.length.size());
  for (std::uint32_t f = 0; f < s.gluing.number_of_faces(); ++f) {
    const double* l = s.length.data() + 3 * std::size_t{f};
    const double perimeter = l[0] + l[1] + l[2], longest = std::max({l[0], l[1], l[2]});
    // 1e-14 is 90 roundings of lengths
    if (!(std::min({l[0], l[1], l[2]}) > 0) || !std::isfinite(perimeter) ||
        !(longest <= (1 + 1e-14) * perimeter / 2))
      throw Invalid_input::about(Element_kind::face, f,
                                 " has sides of which no hyperbolic triangle consists; give "
                                 "lengths that are positive and satisfy the triangle inequality");
    std::array<double, 3> lambda; // opposite the corners
    for (std::size_t k = 0; k < 3; ++k) lambda[k] = 2 * std::sinh(l[(k + 1) % 3] / 2);
    const std::array<double, 3> angle = hyperbolic_angles(lambda, surpluses(lambda)).angle;
    Disk_motion m;
    for (std::size_t k = 0; k < 3; ++k) {
      result.push_back(m);
      const Disk_motion turn = rotation_about_centre(std::numbers::pi - angle[(k + 1) % 3]);
      m = normalised(m * translation_along_axis(l[k]) * turn);
    }
  }
  return result;
}

Disk_motion motion_across(const Disk_motion& side, double length, const Disk_motion& partner) {
  return normalised(side * translation_along_axis(length) *
                    rotation_about_centre(std::numbers::pi) * partner.inverse());
}

double Disk_point::distance(const Disk_point& p) const {
  return 2 * std::asinh(std::abs(z - p.z) / std::sqrt(gap * p.gap));
}

Disk_point Disk_point::moved(const Disk_motion& m) const {
  const std::complex<double> below = std::conj(m.b) * z + std::conj(m.a);
  return {(m.a * z + m.b) / below, gap / std::norm(below)};
}

Disk_motion Disk_pieces::across(const Disk_motion& frame, std::uint32_t c) const {
  return normalised(frame * turn[c]);
}

namespace {

// The sum of vectors to the corners of the last component in the hyperboloid model, scaled to a
// point of the plane: it has the least sum of hyperbolic cosines of distances to them.
Disk_point centre(const Disk_pieces& pieces, const Developer<Disk_pieces>& developer) {
  std::complex<double> space = 0;
  double time = 0;
  developer.for_each_corner([&](std::uint32_t, std::uint32_t c) {
    const Disk_point& p = developer.result.position[pieces.vertex[c]];
    space += 2. * p.z / p.gap;
    time += (1 + std::norm(p.z)) / p.gap;
  });
  const double length = std::abs(space), least = 1e-7 * time; // where all digits are lost
  const double root = std::max(std::sqrt(std::max(0., (time - length) * (time + length))), least);
  const std::complex<double> z = space / (time + root);
  return {z, 2 * root / (time + root)};
}

// The piece with the corner that a motion takes nearest to the centre.
std::uint32_t nearest_piece(const Disk_pieces& pieces, const Developer<Disk_pieces>& developer,
                            std::uint32_t best, const Disk_motion& m) {
  double largest = 0;
  developer.for_each_corner([&](std::uint32_t i, std::uint32_t c) {
    const double gap = developer.result.position[pieces.vertex[c]].moved(m).gap;
    if (gap <= largest) return;
    largest = gap;
    best = i;
  });
  return best;
}

// Finds motions of seams, and checks their relations.
class Side_pairer {
public:
  Side_pairer(const Disk_pieces& pieces, const Developed_disk& developed,
              const std::vector<char>& is_cone)
      : p_(pieces), d_(developed), is_cone_(is_cone), piece_(pieces.piece_of_corner()),
        partner_(pieces.vertex.size(), Gluing::none), motion_(pieces.vertex.size()) {}

  Side_pairings run(std::vector<Border_seam> seams) {
    for (Border_seam& found : seams) {
      Disk_seam& seam = result_.seams.emplace_back();
      seam.sides = std::move(found.sides);
      seam.partners = std::move(found.partners);
      seam.motion = motion_of(seam);
      for (std::size_t i = 0; i < seam.sides.size(); ++i) add(seam, i);
    }
    check_relations();
    return std::move(result_);
  }

private:
  const Disk_point& start(std::uint32_t c) const { return d_.position[p_.vertex[c]]; }
  std::uint32_t next(std::uint32_t c) const { return p_.next(piece_[c], c); }

  // That of the side nearest to the centre.
  Disk_motion motion_of(const Disk_seam& seam) const {
    Disk_motion best;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < seam.sides.size(); ++i) {
      const std::uint32_t c = seam.sides[i];
      const Disk_motion &from = d_.frame[piece_[c]], &to = d_.frame[piece_[seam.partners[i]]];
      const double size = std::norm(from.a) * std::norm(to.a);
      if (!(size < least)) continue;
      least = size;
      best = normalised(to * (from * p_.turn[c]).inverse());
    }
    return best;
  }

  void add(const Disk_seam& seam, std::size_t i) {
    const std::uint32_t c = seam.sides[i], q = seam.partners[i];
    partner_[c] = q;
    partner_[q] = c;
    motion_[c] = seam.motion;
    motion_[q] = seam.motion.inverse();
    for (const auto& [from, to] : {std::array{c, next(q)}, {next(c), q}})
      result_.largest_seam_error =
          std::max(result_.largest_seam_error, start(from).moved(seam.motion).distance(start(to)));
  }

  void check_relations() {
    const std::vector<std::uint32_t> from = border_from(p_);
    std::vector<char> is_done(from.size(), 0);
    for (std::uint32_t v = 0; v < from.size(); ++v) {
      if (from[v] == Gluing::none || is_done[v] != 0) continue;
      Disk_motion product;
      std::uint32_t w = v;
      do {
        is_done[w] = 1;
        const std::uint32_t c = from[w], q = partner_[c];
        if (q == Gluing::none) break; // the surface has a border there
        const std::uint32_t then = p_.vertex[next(q)];
        product = to_centre(d_.position[then]) * motion_[c] * to_centre(d_.position[w]).inverse() *
                  product;
        w = then;
      } while (w != v);
      if (w != v || partner_[from[w]] == Gluing::none || is_cone_[v] != 0) continue;
      const double error = std::min(std::abs(product.a - 1.), std::abs(product.a + 1.));
      result_.largest_relation_error =
          std::max({result_.largest_relation_error, error, std::abs(product.b)});
    }
  }

  const Disk_pieces& p_;
  const Developed_disk& d_;
  const std::vector<char>& is_cone_;
  std::vector<std::uint32_t> piece_;   // of each corner
  std::vector<std::uint32_t> partner_; // of each side in a seam
  std::vector<Disk_motion> motion_;    // of the same
  Side_pairings result_;
};

} // namespace

Developed_disk develop(const Disk_pieces& pieces) {
  // The first ones may be wrong far from where they start. On the data set, with radii up to 7, one
  // is enough; at 36, places in the disk have no digits left.
  constexpr int rounds = 4;
  Developer<Disk_pieces> developer(pieces);
  for (std::uint32_t i = 0; i < pieces.size(); ++i) {
    if (developer.is_placed(i)) continue;
    std::uint32_t root = i;
    Disk_motion start;
    for (int n = 0; n < rounds; ++n) {
      developer.spread_from(root, start);
      const Disk_motion centring = to_centre(centre(pieces, developer));
      root = nearest_piece(pieces, developer, root, centring);
      start = normalised(centring * developer.result.frame[root]);
    }
    developer.spread_from(root, start);
  }
  developer.result.largest_error = developer.largest_error(developer.result.position);
  Developed_disk result{std::move(developer.result)};
  for (const Disk_point& p : result.position)
    result.radius = std::max(result.radius, p.distance(Disk_point()));
  return result;
}

Side_pairings side_pairings(const Disk_pieces& pieces, const Developed_disk& developed,
                            std::vector<Border_seam> seams, const std::vector<char>& is_cone) {
  return Side_pairer(pieces, developed, is_cone).run(std::move(seams));
}

} // namespace CGAL::Intrinsic_triangulations::internal
