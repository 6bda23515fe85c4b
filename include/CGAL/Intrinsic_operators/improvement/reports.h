// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_OPERATORS_IMPROVEMENT_REPORTS_H
#define CGAL_INTRINSIC_OPERATORS_IMPROVEMENT_REPORTS_H

#include <CGAL/Intrinsic_operators/improvement/Improve_options.h>
#include <CGAL/Intrinsic_operators/improvement/Improvement.h>
#include <CGAL/Intrinsic_operators/improvement/improve_and_measure.h>
#include <CGAL/Intrinsic_triangulations/IO/soup/read_surface.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/support/Report.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <cstddef>
#include <optional>
#include <string>

/*!
\file
What was read, done and measured as reports, with the names that the program and Python have.
*/

namespace CGAL::Intrinsic_triangulations {

namespace internal {

const char* name_of(Mollification kind);
Report report_of_input(const std::string& name, const Surface_facts& facts,
                       const Input_report& report);
Report report_of_domain(const Surface_facts& facts, std::size_t vertices);

} // namespace internal

/*!
\brief reports what a triangulation was built of: the keys `input`, `arithmetic`, `correspondence`,
`mollification`, `domain` and `seconds`.
\tparam Triangulation an `Intrinsic_triangulation`
\param name what the surface is called, such as its file
\param t its triangulation
\param facts what is known of it, see `build_surface()`
\complexity constant, but for points of a cloud, which are counted
*/
template <IntrinsicTriangulation Triangulation>
Report surface_report(const std::string& name, const Triangulation& t, const Surface_facts& facts) {
  const Input_report& made = t.report();
  Report report = {{"input", internal::report_of_input(name, facts, made)},
                   {"arithmetic", Triangulation::Metric::is_exact ? "exact" : "double"},
                   {"correspondence", Triangulation::Correspondence::name},
                   {"mollification",
                    {{"kind", internal::name_of(made.mollification.kind)},
                     {"delta", made.mollification.delta}}}};
  const std::size_t rows = t.input().number_of_rows();
  if (!facts.domain.reason.empty())
    report["domain"] = internal::report_of_domain(facts, rows);
  else if (t.input().names().is_cover())
    report["domain"] = {{"kind", "stored"},
                        {"reason", "the file has a cover"},
                        {"sheets", t.input().names().sheets},
                        {"vertices", rows}};
  report["seconds"] = {{"read", facts.seconds_of_reading},
                       {"build", facts.seconds_of_building},
                       {"topology", facts.seconds_of_counting}};
  return report;
}

/// reports what was made of polygons.
Report polygon_report(const Polygon_report& report);

/*!
\brief reports what `improve_soundly()` has done, and `measure_improved()` has found.
\param report gets the figures; `seconds` may be there already
\param improved the result
\param options what was asked for
\param kept_input_edges how many edges of the input are kept; none: this was not asked for
\pre `options` are those of `improve_soundly()`
\complexity linear in the number of figures
*/
void report_improvement(Report& report, const Improved_surface& improved,
                        const Improve_options& options,
                        std::optional<std::size_t> kept_input_edges = {});

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_OPERATORS_IMPROVEMENT_REPORTS_H
