// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_METRIC_BOOST_FLOAT_TRAITS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_METRIC_BOOST_FLOAT_TRAITS_H

#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Real_embeddable_traits.h>
#include <CGAL/boost_mp.h>
#include <CGAL/tags.h>

#include <boost/multiprecision/number.hpp>

#include <limits>
#include <utility>

/*!
\file
Makes the floating point types of Boost.Multiprecision CGAL number types, so that `Euclidean_traits`
takes them; CGAL itself supports only the integers and rationals. Use them without expression
templates:

    using FT = boost::multiprecision::number<
        boost::multiprecision::cpp_bin_float<100, boost::multiprecision::digit_base_2>,
        boost::multiprecision::et_off>;
*/

namespace CGAL {

namespace Intrinsic_triangulations::internal {

template <class Backend>
concept Boost_float = boost::multiprecision::number_category<Backend>::value ==
                      boost::multiprecision::number_kind_floating_point;

} // namespace Intrinsic_triangulations::internal

/// \cond
template <class Backend, boost::multiprecision::expression_template_option templates>
  requires Intrinsic_triangulations::internal::Boost_float<Backend>
struct Algebraic_structure_traits<boost::multiprecision::number<Backend, templates>>
    : Algebraic_structure_traits_base<boost::multiprecision::number<Backend, templates>,
                                      Field_with_sqrt_tag> {
  using Type = boost::multiprecision::number<Backend, templates>;
  using Is_exact = Tag_false;
  using Is_numerical_sensitive = Tag_true;

  struct Sqrt {
    using argument_type = Type;
    using result_type = Type;
    Type operator()(const Type& x) const { return sqrt(x); }
  };
};

template <class Backend, boost::multiprecision::expression_template_option templates>
  requires Intrinsic_triangulations::internal::Boost_float<Backend>
struct Real_embeddable_traits<boost::multiprecision::number<Backend, templates>>
    : INTERN_RET::Real_embeddable_traits_base<boost::multiprecision::number<Backend, templates>,
                                              Tag_true> {
  using Type = boost::multiprecision::number<Backend, templates>;

  struct To_double {
    using argument_type = Type;
    using result_type = double;
    double operator()(const Type& x) const { return x.template convert_to<double>(); }
  };

  struct To_interval {
    using argument_type = Type;
    using result_type = std::pair<double, double>;
    // one step on either side, however the conversion rounds
    std::pair<double, double> operator()(const Type& x) const {
      constexpr double infinity = std::numeric_limits<double>::infinity();
      const double d = x.template convert_to<double>();
      return {std::nextafter(d, -infinity), std::nextafter(d, infinity)};
    }
  };
};
/// \endcond

} // namespace CGAL

#endif // CGAL_INTRINSIC_TRIANGULATIONS_METRIC_BOOST_FLOAT_TRAITS_H
