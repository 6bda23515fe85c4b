// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only.

/*!
\class DiamondExpression Recorded_expression.h <CGAL/Intrinsic_triangulations/formulas/Recorded_expression.h>
\cgalConcept

The concept `DiamondExpression` describes a formula in the seven values of a diamond, whose sign is a
predicate: five squared lengths and the quadruple areas of two faces. To add a predicate, write one;
the metric evaluates it, and with exact traits decides its sign, whatever its degree.

\cgalRefines{CopyConstructible}

\cgalHasModel{\itc{Delaunay_expression}\, \itc{Convexity_at_source_expression}\,
\itc{Convexity_at_target_expression}\, \itc{Recorded_diamond_expression}}

\cgalHeading{Which operation needs what}

| operation | needs |
|---|---|
| `sign()` of a metric with intervals | the call with `Interval_nt<false>` |
| `sign()` of an exact metric | also the call with \itc{Recorded_number} |
| `sign()` of a metric with another number type | the call with that type |

\cgalHeading{Invariants}

- A call uses `+`, `-`, `*`, `/` and constants made of `int` or `double`, and neither compares nor
  branches on values: its steps are recorded once, and repeated with other numbers.
- The result depends on the values and on the state of the functor, which does not change. There are
  no static numbers: they cannot be recorded.

\cgalHeading{Complexity}

Constant time.
*/
class DiamondExpression {
public:
  /// evaluates the formula. \tparam FT a model of \ref ::FieldNumber
  template <class FT>
  FT operator()(const CGAL::Intrinsic_triangulations::Diamond_values<FT>& d) const;
};
