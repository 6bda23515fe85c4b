// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only.

/*!
\class ReadableFaceGraph concepts.h <CGAL/Intrinsic_triangulations/connectivity/concepts.h>
\cgalConcept

The concept `ReadableFaceGraph` describes the connectivity of a surface of polygons that is only
read. Triangulations copy their input, so a mesh that is input need not be more. Vertices need not
determine edges and faces.

\cgalRefines{[HalfedgeListGraph](https://doc.cgal.org/latest/BGL/classHalfedgeListGraph.html) and
[FaceListGraph](https://doc.cgal.org/latest/BGL/classFaceListGraph.html) of CGAL\, but for
`halfedge(u\, v\, mesh)` and `prev(h\, mesh)`}

\cgalHasModel{all models of \ref ::WritableFaceGraph}

\cgalHeading{Operations}

`vertices`, `halfedges`, `edges`, `faces` and their `num_` functions; `next`, `opposite`, `source`,
`target`, `face`, `edge`; `halfedge` of a vertex, an edge and a face; the null descriptors of
halfedges and faces. Argument-dependent lookup finds them.

\cgalHeading{Which operation needs what}

| operation | needs |
|---|---|
| \itf{gluing_map_from_face_graph} | also a \itc{Mesh_adaptor} |
| \itf{locate_on_input} and other queries on the user's mesh | also a \itc{Mesh_adaptor} |

\cgalHeading{Complexity}

Constant time for all functions, except that `num_` functions may be linear.
*/
class ReadableFaceGraph {};
