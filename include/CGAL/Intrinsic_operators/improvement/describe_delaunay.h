// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_IMPROVEMENT_DESCRIBE_DELAUNAY_H
#define CGAL_INTRINSIC_OPERATORS_IMPROVEMENT_DESCRIBE_DELAUNAY_H

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <sstream>
#include <string>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// What has figures by name.
template <class Tree>
concept Named_figures = requires(const Tree& tree, const char* name) {
  { tree.at(name) } -> std::convertible_to<const Tree&>;
  { tree.contains(name) } -> std::convertible_to<bool>;
};

// A histogram as a row of blocks.
template <class Tree>
std::string bars(const Tree& histogram) {
  static const char* const block[] = {"\u2581", "\u2582", "\u2583", "\u2584",
                                      "\u2585", "\u2586", "\u2587", "\u2588"};
  std::int64_t most = 1;
  for (const Tree& n : histogram) most = std::max(most, n.template get<std::int64_t>());
  std::string row;
  for (const Tree& n : histogram) {
    const auto count = n.template get<std::int64_t>();
    row += count == 0 ? "_" : block[count * 7 / most];
  }
  return row;
}

} // namespace internal

/*!
\brief says in some lines what was done to a triangulation, for people: the text of a page.
\tparam Tree `Report`, or JSON with the same names
\param report see `surface_report()` and `report_improvement()`
\return lines without a newline at the end
\throws std::out_of_range if a `Report` lacks a figure; JSON throws its own error
\complexity linear in the number of figures
*/
template <internal::Named_figures Tree>
std::string describe_delaunay(const Tree& report) {
  std::ostringstream text;
  text.precision(4);
  const Tree& quality = report.at("quality");
  text << report.at("delaunay").at("flips").template get<std::int64_t>() << " flips\nangles from "
       << quality.at("min_angle_deg").template get<double>() << " to "
       << quality.at("max_angle_deg").template get<double>() << " degrees\n"
       << report.at("arithmetic").template get<std::string>()
       << " arithmetic, certificate: " << report.at("certificate").template get<std::string>();
  if (report.contains("refine"))
    text << "\n"
         << report.at("refine").at("insertions").template get<std::int64_t>()
         << " vertices inserted, "
         << report.at("refine").at("unsatisfied_faces").template get<std::int64_t>()
         << " faces left below the bound\nangles before "
         << internal::bars(report.at("quality_before").at("angle_histogram"));
  text << "\nangles " << internal::bars(quality.at("angle_histogram")) << " (0 to 180\u00b0)";
  return text.str();
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_IMPROVEMENT_DESCRIBE_DELAUNAY_H
