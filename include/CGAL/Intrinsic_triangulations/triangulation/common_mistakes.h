// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_COMMON_MISTAKES_H
#define CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_COMMON_MISTAKES_H

#include <CGAL/Intrinsic_triangulations/connectivity/adaptors/Mesh_adaptor.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>
#include <CGAL/Intrinsic_triangulations/support/parameters.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <cstdint>
#include <type_traits>

/*!
\file
Overloads for common wrong calls. They are declared and not defined: the compiler refuses the call
itself, before any use of its result, and says in one line what to do; a constraint would list the
failures of all candidates.
*/

/// declares a function that must not be called, and why.
#define CGAL_INTRINSIC_TRIANGULATIONS_MISTAKE(text) __attribute__((unavailable(text)))

/// refuses a mesh in place of a triangulation.
#define CGAL_INTRINSIC_TRIANGULATIONS_REFUSE_MESH(function)                                        \
  template <internal::Mesh_without_metric Mesh, class... Options>                                  \
  CGAL_INTRINSIC_TRIANGULATIONS_MISTAKE(                                                           \
      #function "() takes an intrinsic triangulation, not a mesh: build one of the mesh, "         \
                "Corresponding_triangulation t(mesh), and pass t")                                 \
  internal::Refused_call                                                                           \
  function(const Mesh&, const Options&...);

/// refuses Euclid's metric, or a mesh, for a function of ideal triangulations; `call` does all.
#define CGAL_INTRINSIC_TRIANGULATIONS_REFUSE_EUCLIDEAN(function, call)                             \
  template <internal::Has_no_horocycles Other, class... Options>                                   \
  CGAL_INTRINSIC_TRIANGULATIONS_MISTAKE(                                                           \
      #function "() takes an ideal triangulation, with the traits Exact_ideal_hyperbolic_traits: " \
                "build one of ideal_start(t), or call " call)                                      \
  internal::Refused_call                                                                           \
  function(const Other&, const Options&...);

/// refuses a mesh, a const triangulation and an option without name, for a function that changes a
/// triangulation. `example` is one of its options.
#define CGAL_INTRINSIC_TRIANGULATIONS_REFUSE_MISTAKES(function, Concept, example)                  \
  CGAL_INTRINSIC_TRIANGULATIONS_REFUSE_MESH(function)                                              \
  template <Concept Triangulation, NamedParameters... NP>                                          \
  CGAL_INTRINSIC_TRIANGULATIONS_MISTAKE(                                                           \
      #function "() changes the triangulation, which is const here: pass one that is not, or a "   \
                "copy of it")                                                                      \
  internal::Refused_call                                                                           \
  function(const Triangulation&, const NP&...);                                                    \
  template <Concept Triangulation, class Number>                                                   \
    requires std::is_arithmetic_v<Number> CGAL_INTRINSIC_TRIANGULATIONS_MISTAKE(                   \
        #function "() takes options by name: for a number, such as " #function                     \
                  "(t, parameters::" example "); its page lists the names")                        \
  internal::Refused_call function(const Triangulation&, Number);

/// refuses other arguments for a constructor from a mesh in space.
#define CGAL_INTRINSIC_TRIANGULATIONS_REFUSE_INPUT(Class)                                          \
  template <internal::Not_a_surface<Class> Other>                                                  \
  CGAL_INTRINSIC_TRIANGULATIONS_MISTAKE(                                                           \
      "BGL cannot number the vertices and faces of this mesh: for OpenMesh include "               \
      "CGAL/Intrinsic_triangulations/connectivity/adaptors/OpenMesh_adaptor.h, for a "             \
      "Polyhedron_3 "                                                                              \
      "Polyhedron_3_adaptor.h there; for a Domain or Point_cloud pass its input; read a file by "  \
      "read_triangle_soup(name)")                                                                  \
  explicit Class(const Other&, Mollification = Mollification::automatic);

namespace CGAL::Intrinsic_triangulations::internal {

// the return type of refused calls
struct Refused_call {};

template <class Mesh>
concept Mesh_without_metric = Has_mesh_elements<Mesh> && !requires(const Mesh& m) {
  m.metric();
};

// a `CGAL::Polyhedron_3`, whose elements have no numbers
template <class Mesh>
concept Lacks_adaptor = requires {
  typename Mesh::HalfedgeDS;
  typename Mesh::Facet_handle;
  requires Mesh_adaptor<Mesh>::is_primary;
};

// meshes, and triangulations without lambda lengths
template <class Other>
concept Has_no_horocycles = Mesh_without_metric<Other> ||(
    requires(const Other& t) { t.metric(); } &&
    !requires(const Other& t) { t.metric().approximate_lambda(std::uint32_t()); });

// inputs of triangulations, except an `Intrinsic_input`
template <class Surface>
concept Surface_in_space = std::is_same_v<Surface, Triangle_soup> ||
    (Mesh_without_metric<Surface> && !Lacks_adaptor<Surface>);

// Say in words what the first two arguments of `Intrinsic_triangulation` are. A constraint of a
// class has no text; an assertion that is met on the way to the constraint has one.
template <class Mesh>
struct Checked_mesh {
  static_assert(MutableDeltaComplex<Mesh>,
                "the first argument of Intrinsic_triangulation is a mesh that it owns and flips, "
                "mostly Gluing_map, which is built from any mesh of yours; for OpenMesh or a "
                "Polyhedron_3 with ids include OpenMesh_adaptor.h or Polyhedron_3_adaptor.h in "
                "CGAL/Intrinsic_triangulations/connectivity/adaptors/");
  static constexpr bool is_one = true;
};
template <class Traits>
struct Checked_traits {
  static_assert(IntrinsicTriangulationTraits<Traits>,
                "the second argument of Intrinsic_triangulation is a traits class, mostly "
                "Exact_euclidean_traits; for a kernel or a number type FT write "
                "Euclidean_traits<FT>; a correspondence is the third argument");
  static constexpr bool is_one = true;
};
template <class Mesh>
concept Owned_mesh = Checked_mesh<Mesh>::is_one && MutableDeltaComplex<Mesh>;
template <class Traits>
concept Deciding_traits = Checked_traits<Traits>::is_one && IntrinsicTriangulationTraits<Traits>;

template <class Other, class Triangulation>
concept Not_a_surface = !Surface_in_space<Other> && !std::is_base_of_v<Triangulation, Other> &&
                        !std::is_base_of_v<Intrinsic_input, Other>;

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_TRIANGULATION_COMMON_MISTAKES_H
