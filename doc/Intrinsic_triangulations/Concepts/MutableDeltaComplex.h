// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only.

/*!
\cgalConcept

The concept `MutableDeltaComplex` describes the connectivity of a triangulated surface that can be
built and whose edges can be flipped: a `MutableFaceGraph` of CGAL's BGL interface with triangular
faces, read as a Delta-complex (§2.1 of the course).

A Delta-complex is a set of disjoint triangles whose sides are glued in pairs. Its elements are not
determined by their vertices: an edge may be a loop, several edges may join the same vertices, both
sides of an edge may lie in the same face, two faces may share two or three edges. So no algorithm
looks an edge up by its end vertices, and `halfedge(u, v, mesh)` is not part of the concept.

<b>Invariants</b>, which `delta_complex_defect()` checks:
- `opposite()` is an involution without fixed point, and `edge()` the same for both halfedges;
- `next()` applied three times in a face is the identity; `face()` is constant around a face;
- `source(next(h)) == target(h)`; the two sides of an edge have the same end vertices;
- every edge has a face on at least one side; border halfedges have the null face and form closed
  loops under `next()`;
- `target(halfedge(v)) == v` and `face(halfedge(f)) == f`; isolated vertices have the null halfedge.

Between calls of the mutating functions invariants may be broken; a move restores them.

<b>Complexity.</b> All functions take constant time (amortised, for those that add elements), except
that `num_` functions may be linear.

<b>Which operation needs what</b>

| operation | needs |
|---|---|
| `gluing_map_from_face_graph()`, predicates of `Intrinsic_triangulation` | `vertices`, `halfedges`, `edges`, `faces`, `num_…`, `next`, `opposite`, `target`, `face`, `halfedge`, `edge`, `Mesh_adaptor` |
| `copy_gluing_map()`, the constructors of `Intrinsic_triangulation` | default constructor, `add_vertex`, `add_edge`, `add_face` and all setters on an empty mesh |
| `Intrinsic_triangulation::flip_edge()` | `source` and all setters |
| `insert_vertex()` | `add_vertex`, `add_edge`, `add_face`, `prev` at the border, all setters |
| `remove_vertex()` | `remove_vertex`, `remove_edge`, `remove_face`, `prev` at the border, all setters |
| `flip_to_delaunay()` | `edges`, `halfedge(e)`, `edge(h)`, `next`, `opposite` |
| `delta_complex_defect()` | also `prev`, unless the mesh is a `Gluing_map` |

A mesh other than those below also needs a specialisation of `Mesh_adaptor`, if its elements are not
numbered so that halfedges `2e` and `2e + 1` are the sides of edge `e`. It finds elements by their
numbers too (`vertex_at`, `halfedge_at`, `face_at`) and is told of elements that are added or removed.
Moves must not change the numbers of elements that stay.
Removed elements leave gaps in the numbers, which the elements added next fill. The ranges of the
mesh leave removed elements out; `num_vertices()`, ... may count them. Arrays by number are sized by
`vertex_capacity()`, `edge_capacity()` and `face_capacity()` of the adaptor. An adaptor of a mesh whose
`add_vertex()`, ... do not bring removed elements back may do so itself in `reuse_vertex()`,
`reuse_edge()` and `reuse_face()`, which return null where there is none.

The halfedge of a vertex on the border is one on the border: `copy_gluing_map()` sees to that, and moves
keep it so.

\cgalHasModel{`CGAL::Intrinsic_triangulations::Gluing_map`\, `CGAL::Surface_mesh`\,
`CGAL::Polyhedron_3`\, `OpenMesh::TriMesh_ArrayKernelT`\, `OpenMesh::PolyMesh_ArrayKernelT`}
*/
class MutableDeltaComplex {};
