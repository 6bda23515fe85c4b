// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/support/Report.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>

namespace {

using CGAL::Intrinsic_triangulations::Report;

TEST(Report, keeps_figures_of_all_kinds_in_their_order) {
  const std::array<std::size_t, 3> histogram{1, 2, 3};
  Report report = {{"status", "done"},
                   {"count", 7U},
                   {"area", 2.5},
                   {"histogram", histogram},
                   {"genus", std::optional<int>()},
                   {"sides", std::optional<int>(2)},
                   {"inner", {{"is_exact", true}, {"name", std::string("x")}}}};
  EXPECT_EQ(report.at("status").get<std::string>(), "done");
  EXPECT_EQ(report.at("count").get<std::int64_t>(), 7);
  EXPECT_EQ(report.at("area").get<double>(), 2.5);
  std::int64_t sum = 0;
  for (const Report& n : report.at("histogram")) sum += n.get<std::int64_t>();
  EXPECT_EQ(sum, 6);
  EXPECT_TRUE(std::holds_alternative<std::monostate>(report.at("genus").value()));
  EXPECT_EQ(report.at("sides").get<std::int64_t>(), 2);
  EXPECT_TRUE(report.at("inner").at("is_exact").get<bool>());
  std::string names;
  for (const Report::Figure& f : report.get<Report::Figures>()) names += f.name + ' ';
  EXPECT_EQ(names, "status count area histogram genus sides inner ");
}

TEST(Report, appends_figures_and_replaces_those_that_are_there) {
  Report report;
  report["seconds"]["read"] = 1.5;
  report["seconds"]["build"] = 2;
  report["seconds"]["read"] = 0.5;
  EXPECT_EQ(report.at("seconds").get<Report::Figures>().size(), 2U);
  EXPECT_EQ(report.at("seconds").at("read").get<double>(), 0.5);
  report["domain"] = {{"kind", "stored"}, {"reason", "the file has a cover"}};
  EXPECT_EQ(report.at("domain").at("kind").get<std::string>(), "stored");
}

TEST(Report, names_a_figure_that_is_not_there) {
  const Report report = {{"a", 1}};
  EXPECT_TRUE(report.contains("a"));
  EXPECT_FALSE(report.contains("b"));
  EXPECT_FALSE(report.at("a").contains("a"));
  EXPECT_THROW(report.at("b"), std::out_of_range);
  EXPECT_THROW(report.at("a").get<double>(), std::bad_variant_access);
}

} // namespace
