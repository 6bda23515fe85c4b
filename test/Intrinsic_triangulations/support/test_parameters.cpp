// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/support/parameters.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <type_traits>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
namespace tags = IT::internal::tags;
namespace parameters = IT::parameters;
using IT::internal::object_or;
using IT::internal::value_or;

struct Visitor {
  int calls = 0;
};

static_assert(IT::NamedParameters<parameters::Parameters<>>);
static_assert(IT::NamedParameters<decltype(parameters::minimum_angle(30))>);
static_assert(IT::NamedParameters<CGAL::parameters::Default_named_parameters>);
static_assert(IT::NamedParameters<decltype(CGAL::parameters::visitor(1).point_map(2))>);
static_assert(!IT::NamedParameters<int>);
static_assert(!IT::NamedParameters<Visitor>);

TEST(Parameters, Have_their_defaults_where_nothing_is_given) {
  const auto np = parameters::default_values();
  EXPECT_EQ(value_or<tags::minimum_angle>(np, 25.), 25);
  EXPECT_EQ(object_or<tags::visitor>(np, Visitor{7}).calls, 7);
  const auto cgal = CGAL::parameters::default_values();
  EXPECT_EQ(value_or<tags::minimum_angle>(cgal, 25.), 25);
  EXPECT_EQ(object_or<tags::visitor>(cgal, Visitor{7}).calls, 7);
}

TEST(Parameters, Are_chained_in_any_order_with_names_of_CGAL_among_them) {
  const auto check = [](const auto& np) {
    EXPECT_EQ(value_or<tags::minimum_angle>(np, 25.), 30);
    EXPECT_EQ(object_or<tags::visitor>(np, Visitor{}).calls, 3);
    EXPECT_EQ(value_or<tags::conforming>(np, false), true);
    EXPECT_EQ(value_or<tags::maximum_edge_length>(np, 1.5), 1.5);
  };
  const Visitor v{3};
  check(parameters::minimum_angle(30).visitor(v).conforming(true));
  check(parameters::visitor(v).conforming(true).minimum_angle(30.F));
  check(parameters::conforming(true).minimum_angle(30.).visitor(v));
}

TEST(Parameters, Are_converted_to_the_type_that_is_wanted) {
  const auto np = parameters::maximum_insertions(100).maximum_edge_length(2);
  const auto cap =
      value_or<tags::maximum_insertions>(np, std::optional<std::uint64_t>(std::nullopt));
  static_assert(std::is_same_v<decltype(cap), const std::optional<std::uint64_t>>);
  EXPECT_EQ(cap, 100U);
  EXPECT_EQ(value_or<tags::maximum_edge_length>(np, std::numeric_limits<double>::infinity()), 2.);
}

TEST(Parameters, Of_CGAL_are_taken) {
  const auto np =
      CGAL::parameters::visitor(Visitor{5}).maximum_number(9).edge_is_constrained_map(4);
  EXPECT_EQ(object_or<tags::visitor>(np, 0).calls, 5);
  EXPECT_EQ(value_or<tags::maximum_number>(np, std::uint64_t{1}), 9U);
  EXPECT_EQ(object_or<tags::edge_is_constrained_map>(np, 0), 4);
  EXPECT_EQ(value_or<tags::number_of_iterations>(np, 2), 2);
  EXPECT_EQ(value_or<tags::number_of_iterations>(CGAL::parameters::number_of_iterations(8), 2), 8);
}

TEST(Parameters, Passed_by_reference_are_not_copied) {
  Visitor v;
  const auto ours = parameters::margin(1).visitor(std::ref(v));
  auto stored = object_or<tags::visitor>(ours, Visitor());
  ++IT::internal::unwrapped(stored).calls;
  auto stored_by_cgal = object_or<tags::visitor>(CGAL::parameters::visitor(std::ref(v)), Visitor());
  ++IT::internal::unwrapped(stored_by_cgal).calls;
  EXPECT_EQ(v.calls, 2);
  auto copied = object_or<tags::visitor>(parameters::visitor(v), Visitor());
  ++IT::internal::unwrapped(copied).calls;
  EXPECT_EQ(v.calls, 2);
}

} // namespace
