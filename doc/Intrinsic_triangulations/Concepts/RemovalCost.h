// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only.

/*!
\class RemovalCost removal_costs.h <CGAL/Intrinsic_simplification/simplification/removal_costs.h>
\cgalConcept

The concept `RemovalCost` describes what the removal of a vertex costs: \itc{simplify} removes the
vertices with low costs first.

\cgalHeading{Operations}

A call with a \itc{Removal_candidate}, whose result `CGAL::to_double()` converts. It may depend on
nothing else that changes meanwhile.

A cost that remembers has two operations instead. `c` is the candidate, and `neighbors` a
`std::span` of a \itc{Removal_neighbor} for each edge at it that is not a loop; the span is valid
during the call:

- `cost(c, neighbors)`, constant: the cost;
- `cost.remove(c, neighbors)`: is called when `c` is gone, with what was there before.

If it has a static constant `needs_vectors` that is false, `turn` and `back` of neighbours are zero,
which saves the time to find them.

\cgalHeading{Invariants}

A vertex whose cost is not finite stays. Costs are asked for again when a vertex is next in turn and
faces at it have changed; not if the cost of one of its neighbours has. On a cover each copy of a
vertex has a cost, of which the greatest counts, and they are removed one after another.
*/
class RemovalCost {};
