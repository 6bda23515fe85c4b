// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/isometry/Isometry_run.h>
#include <CGAL/Intrinsic_simplification/isometry/Square_root_field.h>
#include <CGAL/Intrinsic_simplification/isometry/search/hash_of_surface.h>
#include <CGAL/Intrinsic_simplification/isometry/tessellation/Dart_complex.h>
#include <CGAL/Intrinsic_simplification/isometry/tessellation/Moved_triangulation.h>
#include <CGAL/Intrinsic_simplification/isometry/tessellation/Singular_surface.h>
#include <CGAL/Intrinsic_triangulations/exact/numbers/Ball.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

// Steele, Lea and Flood, Fast splittable pseudorandom number generators, 2014.
std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15U;
  x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27U)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31U);
}
std::uint64_t mixed(std::uint64_t x, std::uint64_t y) { return mixed(mixed(x) + 3 * y); }

// Colours of darts, from lengths, sides of polygons and degrees of both ends; each round adds the
// colours of the next and the opposite dart.
class Dart_colours {
public:
  Dart_colours(const Dart_complex& darts, const std::vector<std::uint64_t>& lengths,
               bool is_mirrored)
      : darts_(darts), next_(is_mirrored ? darts.previous : darts.next), colour_(lengths) {
    for (std::uint32_t d = 0; d < darts.size(); ++d) {
      const std::uint32_t start = darts.degree[d], end = darts.degree[darts.next[d]];
      const std::uint64_t ends = is_mirrored ? mixed(end, start) : mixed(start, end);
      colour_[d] = mixed(mixed(lengths[d], darts.sides[d]), ends);
    }
    for (unsigned round = 0; round < number_of_rounds; ++round) add_round();
  }
  // the sum over each component
  std::vector<std::uint64_t> sums() const {
    std::vector<std::uint64_t> result(darts_.number_of_components, 0);
    for (std::uint32_t d = 0; d < darts_.size(); ++d)
      result[darts_.component[d]] += mixed(colour_[d]);
    return result;
  }

private:
  void add_round() {
    const std::vector<std::uint64_t> before = colour_;
    for (std::uint32_t d = 0; d < darts_.size(); ++d) {
      const std::uint32_t o = darts_.opposite[d];
      colour_[d] =
          mixed(mixed(before[d], before[next_[d]]), o == Dart_complex::none ? 1 : before[o]);
    }
  }

  static constexpr unsigned number_of_rounds = 12;

  const Dart_complex& darts_;
  const std::vector<std::uint32_t>& next_;
  std::vector<std::uint64_t> colour_;
};

// The nearest double to a squared length or an area, in the units of the user.
double rounded(const Singular_surface& s, Value_recipes::Id id) {
  try {
    expect_to_go_on();
    return std::ldexp(s.triangulation().nearest(id), -2 * s.start().input().scale_exponent());
  } catch (const Undecidable& e) {
    throw Invalid_input(Element_kind::none, 0,
                        std::string("a length cannot be rounded correctly: ") + e.what());
  }
}

} // namespace

double rounded_squared_length(const Singular_surface& s, std::uint32_t dart) {
  return rounded(s, s.length(dart));
}

std::uint64_t hash_of_surface(const Singular_surface& s, Isometry_run& run) {
  const Dart_complex& darts = s.darts();
  const std::uint32_t sheets = s.surface().names().sheets; // a cover is another surface
  const auto refuse = [](const std::string& why) {
    throw Invalid_input(Element_kind::none, 0, "the surface gets no hash, since " + why);
  };
  if (s.is_ended()) refuse(s.open());
  if (!s.is_proven()) // another triangulation of the surface might get a hash
    refuse(s.open() + "; remove flat vertices from the mesh");
  try {
    run.begin(Isometry_stage::lengths);
  } catch (const Undecidable& e) {
    refuse(e.what());
  }
  std::vector<std::uint64_t> lengths(darts.size());
  for (std::uint32_t d = 0; d < darts.size(); ++d) {
    const std::uint32_t o = darts.opposite[d], edge = darts.halfedge[d] / 2;
    lengths[d] = o < d ? lengths[o] : std::bit_cast<std::uint64_t>(rounded(s, s.measure(edge)));
    if (const std::uint32_t copied = s.number_of_copied_ends(edge); o >= d && copied > 0)
      lengths[d] = mixed(lengths[d], copied);
  }
  const std::vector<std::uint64_t> sums = Dart_colours(darts, lengths, false).sums(),
                                   mirrored = Dart_colours(darts, lengths, true).sums();
  std::uint64_t all = 0;
  for (std::size_t c = 0; c < sums.size(); ++c)
    all += mixed(std::min(sums[c], mirrored[c]), std::max(sums[c], mirrored[c]));
  return mixed(mixed(all, darts.size()), sheets);
}

} // namespace CGAL::Intrinsic_triangulations::internal
