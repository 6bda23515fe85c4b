// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only.

/*!
\class WritableFaceGraph concepts.h <CGAL/Intrinsic_triangulations/connectivity/concepts.h>
\cgalConcept

The concept `WritableFaceGraph` describes a surface of polygons that is built one element after
another.

\cgalRefines{\ref ::ReadableFaceGraph and
[MutableFaceGraph](https://doc.cgal.org/latest/BGL/classMutableFaceGraph.html) of CGAL}

\cgalHasModel{all models of \ref ::MutableDeltaComplex}

\cgalHeading{Operations}

`add_vertex`, `add_edge`, `add_face`; `remove_vertex`, `remove_edge`, `remove_face`; `set_next`,
`set_target`, `set_face`; `set_halfedge` of a vertex and of a face.

\cgalHeading{Which operation needs what}

| operation | needs |
|---|---|
| \itf{copy_gluing_map} | all that add and set |

\cgalHeading{Complexity}

Amortised constant time for all functions.
*/
class WritableFaceGraph {};
