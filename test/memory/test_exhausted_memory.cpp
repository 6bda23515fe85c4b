// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "checksum.h"
#include "meshes.h"
#include "soups.h"

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Explicit_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/No_correspondence.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signposts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/locate.h>
#include <CGAL/Intrinsic_triangulations/domains/Domain.h>
#include <CGAL/Intrinsic_triangulations/metric/Euclidean_traits.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_euclidean_traits.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/certify_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <boost/graph/graph_traits.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <map>
#include <new>
#include <optional>
#include <random>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// Memory is exhausted at each place in turn where a move allocates some: everything but caches and
// statistics stays as it was, and the move can be made later.

namespace {

constexpr std::size_t unlimited = std::numeric_limits<std::size_t>::max();
std::size_t allocations_left = unlimited;

} // namespace

void* operator new(std::size_t size) {
  if (allocations_left == 0) throw std::bad_alloc();
  if (allocations_left != unlimited) --allocations_left;
  if (void* p = std::malloc(size)) return p;
  throw std::bad_alloc();
}
// Arrays do not fail. They are numbers of CGAL: a sum of `CGAL::Mpzf` that cannot allocate its array
// frees a pointer that was never set.
void* operator new[](std::size_t size) {
  if (void* p = std::malloc(size)) return p;
  throw std::bad_alloc();
}
void operator delete(void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Move_status;

template <class Traits, class Correspondence>
using With = IT::Intrinsic_triangulation<IT::Gluing_map, Traits, Correspondence>;
using Exact = IT::Exact_euclidean_traits;
using Rounding = IT::Euclidean_traits<double>;

// \param t a copy: places may be found only now, which must not change what follows
template <class T>
std::uint64_t checksum(const T t) {
  return checksums::checksum(t);
}

/// A move, chosen before memory is exhausted.
template <class T>
struct Move {
  std::string kind;
  typename T::halfedge_descriptor h;
  typename T::vertex_descriptor v;
  double parameter = 0.5;
  std::array<double, 3> weights{};
  std::optional<IT::Surface_point> place{};

  Move_status make(T& t) const {
    if (kind == "flip") return t.flip_edge(h);
    if (kind == "insertion") return t.insert_vertex(h, weights).status;
    if (kind == "copy") return typename T::Session(t).insert_copy(h, weights, *place).status;
    if (kind == "removal") return t.remove_vertex(v);
    if (kind == "reposition") return t.reposition_vertex(v, h, weights).status;
    return t.split_edge(h, parameter).status;
  }
};

// a vertex that is inserted at a known place of the input, as copies on covers are
template <class T>
void choose_place(Move<T>& m, const T& t, bool is_on_edge) {
  if constexpr (T::has_correspondence) {
    if (is_on_edge) m.weights = {0.5, 0.5, 0};
    const auto p = IT::locate_on_input(t, IT::Surface_point{t.numbers().halfedge(m.h), m.weights});
    if (!p || !IT::representable_weights(p->weights)) return;
    m.kind = "copy";
    m.place = IT::Surface_point{p->halfedge, *IT::representable_weights(p->weights)};
  }
}

template <class T>
Move<T> move_at_random(const T& t, std::minstd_rand& random) {
  using Graph = boost::graph_traits<IT::Gluing_map>;
  std::vector<typename T::vertex_descriptor> inserted;
  for (const auto v : vertices(t.mesh()))
    if (t.is_inserted(v)) inserted.push_back(v);
  const std::vector<typename T::halfedge_descriptor> all(halfedges(t.mesh()).begin(),
                                                         halfedges(t.mesh()).end());
  Move<T> m{"flip", all[random() % all.size()], {}};
  m.parameter = 0.25 + 0.25 * static_cast<double>(random() % 3);
  m.weights = {(1 - m.parameter) / 2, m.parameter, (1 - m.parameter) / 2};
  if (!inserted.empty()) m.v = inserted[random() % inserted.size()];
  const auto kind = inserted.size() < 3 ? random() % 6 : random() % (inserted.size() > 9 ? 10 : 8);
  if (kind >= 7)
    m.kind = "removal";
  else if (kind == 6)
    m.kind = "reposition";
  else if (kind > 2) {
    const bool is_on_border = face(m.h, t.mesh()) == Graph::null_face() ||
                              face(opposite(m.h, t.mesh()), t.mesh()) == Graph::null_face();
    m.kind = is_on_border ? "border split" : "split";
  } else if (kind > 0)
    m.kind = "insertion";
  if (kind == 2 || kind == 3)
    if (face(m.h, t.mesh()) != Graph::null_face()) choose_place(m, t, kind == 3);
  return m;
}

// Makes a move as soon as there is enough memory. \return the status, and how often there was not
template <class T>
std::pair<Move_status, int> make_at_last(T& t, const Move<T>& m) {
  const std::uint64_t before = checksum(t);
  int exceptions = 0;
  for (std::size_t n = 0;; n += 1 + n / 32) {
    try {
      allocations_left = n;
      const Move_status s = m.make(t);
      allocations_left = unlimited;
      EXPECT_TRUE(s == Move_status::done || checksum(t) == before) << m.kind << " refused";
      return {s, exceptions};
    } catch (const std::bad_alloc&) {
      allocations_left = unlimited;
    }
    ++exceptions;
    EXPECT_EQ(checksum(t), before) << m.kind << " after " << n << " allocations";
    if (::testing::Test::HasFailure()) return {Move_status::done, exceptions};
  }
}

template <class T>
void expect_good(T& t) {
  if constexpr (std::is_same_v<typename T::Correspondence, IT::Explicit_crossings>) {
    IT::Explicit_crossings followed;
    followed.restore(t, t.correspondence());
    for (const auto e : edges(t.mesh()))
      EXPECT_TRUE(std::ranges::equal(followed.entered_on(t.index(e)),
                                     t.correspondence().entered_on(t.index(e))));
  }
  if constexpr (T::Metric::is_exact) {
    EXPECT_EQ(IT::flip_to_delaunay(t).status, IT::Status::done);
    EXPECT_TRUE(IT::is_delaunay(t));
  }
  if constexpr (std::is_same_v<T, With<Exact, IT::Integer_coordinates>>) {
    EXPECT_TRUE(IT::certify_delaunay(t).is_delaunay());
  }
}

template <class Case>
class Exhausted_memory : public ::testing::Test {};
using Cases =
    ::testing::Types<With<Exact, IT::No_correspondence>, With<Exact, IT::Integer_coordinates>,
                     With<Exact, IT::Explicit_crossings>, With<Exact, IT::Signposts>,
                     With<Rounding, IT::No_correspondence>,
                     With<Rounding, IT::Integer_coordinates>>;
TYPED_TEST_SUITE(Exhausted_memory, Cases);

TYPED_TEST(Exhausted_memory, during_moves_of_all_kinds_changes_nothing) {
  std::minstd_rand random(7);
  std::map<std::string, int> done, exceptions;
  for (int start = 0; start < 30; ++start) {
    TypeParam t(start % 3 == 0   ? meshes::rough_grid(3, 1).input()
                : start % 3 == 1 ? meshes::box(2, 2, 1).input()
                                 : IT::make_domain(soups::soup(soups::three_fins()),
                                                   IT::Domain_kind::tufted_cover)
                                       .input);
    for (int i = 0; i < 40; ++i) {
      const Move<TypeParam> m = move_at_random(t, random);
      const auto [status, failures] = make_at_last(t, m);
      ASSERT_FALSE(::testing::Test::HasFailure()) << "start " << start << ", move " << i;
      done[m.kind] += status == Move_status::done ? 1 : 0;
      exceptions[m.kind] += failures;
    }
    expect_good(t);
  }
  for (const char* kind : {"insertion", "split", "border split", "reposition", "removal"}) {
    EXPECT_GT(done[kind], 2) << kind;
    EXPECT_GT(exceptions[kind], 2) << kind;
  }
  EXPECT_TRUE(!TypeParam::has_correspondence || exceptions["copy"] > 2);
}

} // namespace
