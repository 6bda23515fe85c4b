// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only.

/*!
\class ProofOf Question.h <CGAL/Intrinsic_triangulations/exact/proofs/Question.h>
\cgalConcept

The concept `ProofOf` describes a functor that answers questions of one kind: the sign of an
expression in the values of a figure, which follow from the input. The types of its calls say for
which figures and expressions it works; the ladder skips it for others.

\cgalHasModel{\itc{Flat_proof}\, \itc{Prism_proof}\, \itc{Prism_in_field_proof}\,
\itc{Mirrored_proof}\, \itc{Field_proof}}

\cgalHeading{Which operation needs what}

| operation | needs |
|---|---|
| \itc{Exact_ladder}, the list in Exact_ladder.cpp | also a static member `rung`, where statistics count it |

\cgalHeading{Invariants}

- An answer other than `open` is true: a proof does not round, or bounds what it rounds.
- `not_zero` needs no sign: numbers with more bits find it.

\cgalHeading{Complexity}

Each proof says its own; the list is in the order of costs, and a proof that finds that it would take
too long answers `open`.
*/
class ProofOf {
public:
  /// answers a question, or leaves it open.
  CGAL::Intrinsic_triangulations::Answer
  operator()(const CGAL::Intrinsic_triangulations::Question<Figure, Expression>& question);
};
