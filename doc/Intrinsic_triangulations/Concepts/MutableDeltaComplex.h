// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only.

/*!
\class MutableDeltaComplex concepts.h <CGAL/Intrinsic_triangulations/connectivity/concepts.h>
\cgalConcept

The concept `MutableDeltaComplex` describes the connectivity of a triangulated surface that can be
built and whose edges can be flipped: a mesh with triangular faces and CGAL's BGL interface, read as
a Delta-complex (§2.1 of the course).

A Delta-complex is a set of disjoint triangles whose sides are glued in pairs. Vertices do not
determine its elements: an edge may be a loop, several edges may join the same vertices, both
sides of an edge may lie in the same face, two faces may share two or three edges. So no algorithm
looks an edge up by its end vertices, and `halfedge(u, v, mesh)` is not part of the concept.

\cgalRefines{[MutableFaceGraph](https://doc.cgal.org/latest/BGL/classMutableFaceGraph.html)\,
[HalfedgeListGraph](https://doc.cgal.org/latest/BGL/classHalfedgeListGraph.html) and
[FaceListGraph](https://doc.cgal.org/latest/BGL/classFaceListGraph.html) of CGAL\, but for
`halfedge(u\, v\, mesh)`; `DefaultConstructible` and `MoveConstructible` of the C++ standard}

\cgalHasModel{\itc{Gluing_map}\, `CGAL::Surface_mesh`\,
`CGAL::Polyhedron_3` (include Polyhedron_3_adaptor.h)\, `OpenMesh::TriMesh_ArrayKernelT` and
`OpenMesh::PolyMesh_ArrayKernelT` (include OpenMesh_adaptor.h)}

\cgalHeading{Types}

The descriptors of `boost::graph_traits`, and a \itc{Mesh_adaptor} that numbers elements. The
primary template serves meshes with internal indices in which halfedges `2e` and `2e + 1` are the
sides of edge `e`; other meshes need a specialisation. It also finds elements by their numbers
(`vertex_at`, `halfedge_at`, `face_at`); the triangulation calls it when it adds or removes
elements.

\cgalHeading{Operations}

The functions of the concepts that it refines, found by argument-dependent lookup.

| reads | writes |
|---|---|
| `vertices`, `halfedges`, `edges`, `faces`, `num_vertices`, `num_edges`, `num_faces` | `add_vertex`, `add_edge`, `add_face` |
| `next`, `prev`, `opposite`, `source`, `target` | `remove_vertex`, `remove_edge`, `remove_face` |
| `face`, `edge`, `halfedge(v)`, `halfedge(e)`, `halfedge(f)` | `set_next`, `set_target`, `set_face`, `set_halfedge(v)`, `set_halfedge(f)` |

\cgalHeading{Which operation needs what}

| operation | needs |
|---|---|
| \itf{gluing_map_from_face_graph}, predicates of `Intrinsic_triangulation` | all that read except `prev`, and `Mesh_adaptor` |
| \itf{copy_gluing_map}, the constructors of `Intrinsic_triangulation` | default constructor, `add_vertex`, `add_edge`, `add_face` and all setters on an empty mesh |
| `flip_edge()` | `source` and all setters |
| `insert_vertex()` | `add_vertex`, `add_edge`, `add_face`, `prev` at the border, all setters |
| `remove_vertex()` | `remove_vertex`, `remove_edge`, `remove_face`, `prev` at the border, all setters |
| \itf{flip_to_delaunay} | `edges`, `halfedge(e)`, `edge(h)`, `next`, `opposite` |

A mesh that is only *input* need not be a model, since triangulations copy it: see \ref meshes.

\cgalHeading{Invariants}

The tests check with `delta_complex_defect()` that
- `opposite()` is an involution without fixed point, and `edge()` the same for both halfedges;
- `next()` applied three times in a face is the identity; `face()` is constant around a face;
- `source(next(h)) == target(h)`; the two sides of an edge have the same end vertices;
- every edge has a face on at least one side; border halfedges have the null face and form closed
  loops under `next()`;
- `target(halfedge(v)) == v` and `face(halfedge(f)) == f`; isolated vertices have the null halfedge.

Invariants may fail between calls of the mutating functions; a move restores them. The halfedge of a
vertex on the border is on the border: \itf{copy_gluing_map} makes it so, and moves keep it so.

\cgalHeading{Numbers}

Moves must not change the numbers of elements that stay. Removed elements leave gaps in the numbers;
the next new elements fill them. The ranges of the mesh leave removed elements out;
`num_vertices()`, ... may count them. `vertex_capacity()`, `edge_capacity()` and `face_capacity()`
of the adaptor are the sizes of arrays by number. If `add_vertex()`, ... of a mesh do not use
removed elements again, its adaptor may do so in `reuse_vertex()`, `reuse_edge()` and
`reuse_face()`, which return a null descriptor if no removed element is left.

Before an insertion or a removal the triangulation calls `make_room(mesh)` of the adaptor: after
that, adding or removing one vertex, three edges and two faces must not fail. The default calls
`reserve()` of the mesh. `CGAL::Polyhedron_3` cannot reserve memory: if that is exhausted during an
insertion, the program ends.

\cgalHeading{Complexity}

All functions take constant time (amortised, for those that add elements), except that `num_`
functions may be linear.
*/
class MutableDeltaComplex {};
