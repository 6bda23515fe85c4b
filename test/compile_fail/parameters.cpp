// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Options and visitors that a function does not have: messages name them, or what is meant.

#include <CGAL/Intrinsic_geodesics/shortening/shorten_curves.h>
#include <CGAL/Intrinsic_simplification/simplification/hierarchy.h>
#include <CGAL/Intrinsic_simplification/simplification/simplify.h>
#include <CGAL/Intrinsic_triangulations.h>

#include <cstddef>

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<>;

namespace case_const_triangulation {
// Algorithms change the triangulation.
// error at once: const here: pass one that is not
void misuse(const IT::Corresponding_triangulation& t) { IT::flip_to_delaunay(t); }
} // namespace case_const_triangulation

namespace case_cost_without_number {
// A cost is a number, which the call is refused without.
// error at once: the cost of simplify.. is a functor that takes a Removal_candidate and returns a number
void misuse(const IT::Corresponding_triangulation& t) {
  IT::simplify(t, {}, [](const IT::Removal_candidate&) { return "cheap"; });
}
} // namespace case_cost_without_number

namespace case_cost_of_a_vertex {
// Costs are of candidates. A hierarchy says the same.
// error at once: the cost of hierarchy.. is a functor that takes a Removal_candidate and returns a number
void misuse(const IT::Corresponding_triangulation& t) {
  IT::hierarchy(t, 3, 0.25, {}, [](const char* vertex) { return *vertex; });
}
} // namespace case_cost_of_a_vertex

namespace case_map_without_keys {
// A number is no map.
// error at once: edge_is_constrained_map.. takes a property map
void misuse(Triangulation& t) {
  IT::flip_to_delaunay(t, IT::parameters::edge_is_constrained_map(4));
}
} // namespace case_map_without_keys

namespace case_misspelled_parameter {
// The name that is nearest to a wrong one is not another one of an angle.
// error at once: did you mean .minimum_angle.
void misuse(Triangulation& t) { IT::delaunay_refine(t, IT::parameters::min_angle(30)); }
} // namespace case_misspelled_parameter

namespace case_number_as_enumerator {
// An order has a name.
// error at once: order.. takes a Refinement_order
void misuse(IT::Corresponding_triangulation& t) {
  IT::delaunay_refine(t, IT::parameters::order(1));
}
} // namespace case_number_as_enumerator

namespace case_number_as_visitor {
// A visitor is called.
// error at once: visitor.. takes an object, or std::ref
void misuse(Triangulation& t) { IT::flip_to_delaunay(t, IT::parameters::visitor(3)); }
} // namespace case_number_as_visitor

namespace case_number_of_flips_without_name {
// A number is no range of edges.
// error at once: maximum_number.1000
void misuse(Triangulation& t) { IT::flip_to_delaunay(t, 1000); }
} // namespace case_number_of_flips_without_name

namespace case_option_without_name {
// Options have names.
// error at once: parameters::minimum_angle
void misuse(IT::Corresponding_triangulation& t) { IT::delaunay_refine(t, 25); }
} // namespace case_option_without_name

namespace case_other_enumeration {
// Enumerators would be converted by their numbers.
// error: a value of another enumeration
void misuse(IT::Corresponding_triangulation& t) {
  IT::delaunay_refine(t, IT::parameters::order(IT::Triangle_inequality::check));
}
} // namespace case_other_enumeration

namespace case_shortest_when_shortening {
// Only functions that look for paths can look for the shortest; others keep what they start from.
// error at once: (Unknown_parameter = [^;]*shortest|expect_name<[^,]*shortest)
void misuse(IT::Curve_network<Triangulation>& network) {
  IT::shorten_curves(network, IT::parameters::shortest(true));
}
} // namespace case_shortest_when_shortening

namespace case_text_as_flag {
// The text would be true.
// error at once: conforming.. takes true or false
void misuse(IT::Corresponding_triangulation& t) {
  IT::delaunay_refine(t, IT::parameters::conforming("no"));
}
} // namespace case_text_as_flag

namespace case_text_as_number {
// No conversion of the value is tried first.
// error at once: minimum_angle.. takes a number of degrees
void misuse(IT::Corresponding_triangulation& t) {
  IT::delaunay_refine(t, IT::parameters::minimum_angle("30"));
}
} // namespace case_text_as_number

namespace case_unknown_parameter {
// Rounds are a matter of adaptive refinement. The compiler names the parameter.
// error at once: (Unknown_parameter = [^;]*maximum_rounds|expect_name<[^,]*maximum_rounds)
void misuse(Triangulation& t) {
  IT::delaunay_refine(t, IT::parameters::minimum_angle(30).maximum_rounds(3));
}
} // namespace case_unknown_parameter

namespace case_unknown_parameter_of_cgal {
// A triangulation knows its points. The compiler names CGAL's parameter, also before one that is known.
// error at once: (Unknown_parameter = [^;]*point_t|expect_name<[^,]*point_t)
void misuse(Triangulation& t) {
  IT::flip_to_delaunay(t, CGAL::parameters::vertex_point_map(1).maximum_number(3));
}
} // namespace case_unknown_parameter_of_cgal

namespace case_visitor_without_base {
// A visitor has all that refinement calls, by its base.
// error at once: a visitor of refinement derives from Refinement_visitor
struct Progress {
  bool progress(std::size_t) { return true; }
};
void misuse(IT::Corresponding_triangulation& t) {
  IT::delaunay_refine(t, IT::parameters::minimum_angle(25).visitor(Progress()));
}
} // namespace case_visitor_without_base

namespace case_visitor_without_progress {
// A visitor of flips has what they call.
// error at once: a visitor of flip_to_delaunay.. derives from Flip_to_delaunay_visitor
struct Counter {
  std::size_t flips = 0;
};
void misuse(Triangulation& t) { IT::flip_to_delaunay(t, IT::parameters::visitor(Counter())); }
} // namespace case_visitor_without_progress
