// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_WRITE_INTRINSIC_TRIANGULATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_WRITE_INTRINSIC_TRIANGULATION_H

#include <CGAL/Intrinsic_triangulations/IO/idt/intrinsic_triangulation_format.h>
#include <CGAL/Intrinsic_triangulations/IO/support/Replacing_file.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/as_gluing.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Vertex_places.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <ostream>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Numbers elements anew: in their order, but without the gaps that removals leave.
struct Compact_order {
  template <class Triangulation, class Range>
  Compact_order(const Triangulation& t, const Range& range) {
    for (const auto element : range) old.push_back(t.index(element));
    std::sort(old.begin(), old.end());
    if (!old.empty()) now.resize(old.back() + std::size_t{1});
    for (std::uint32_t i = 0; i < old.size(); ++i) now[old[i]] = i;
  }

  std::uint32_t count() const { return static_cast<std::uint32_t>(old.size()); }

  std::vector<std::uint32_t> old, now; // numbers, by those now and by the old ones
};

// Vertices of the input come first. Use it like a `Mesh_adaptor`.
template <class Triangulation>
struct Compact_numbers {
  using Mesh = typename Triangulation::Mesh;

  explicit Compact_numbers(const Triangulation& triangulation)
      : t(triangulation), of_vertices(t, vertices(t.mesh())), of_edges(t, edges(t.mesh())),
        of_faces(t, faces(t.mesh())) {}

  std::uint32_t vertex(typename Triangulation::vertex_descriptor v) const {
    return of_vertices.now[t.index(v)];
  }
  std::uint32_t halfedge(typename Triangulation::halfedge_descriptor h) const {
    const std::uint32_t i = t.numbers().halfedge(h);
    return 2 * of_edges.now[i / 2] + i % 2;
  }
  std::uint32_t face(typename Triangulation::face_descriptor f) const {
    return of_faces.now[t.index(f)];
  }

  std::uint32_t vertex_capacity(const Mesh&) const { return of_vertices.count(); }
  std::uint32_t edge_capacity(const Mesh&) const { return of_edges.count(); }
  std::uint32_t face_capacity(const Mesh&) const { return of_faces.count(); }

  const Triangulation& t;
  Compact_order of_vertices, of_edges, of_faces;
};

// The contents of a file, with compact numbers of elements.
template <class Metric>
struct Triangulation_to_write {
  const Input_definition& input;
  const Metric& metric;
  Gluing_map mesh;
  std::vector<std::uint32_t> old_vertices, old_edges, old_faces; // their numbers before
  const Integer_coordinates* coordinates = nullptr; // null if doubles are all that there is
};

// Writes a file; false if the stream fails.
template <class Metric>
bool write_stored_triangulation(std::ostream& out, Triangulation_to_write<Metric> t);

// Collects what a file holds of a triangulation.
template <class Triangulation>
class Intrinsic_triangulation_writer {
  using Metric = typename Triangulation::Metric;

public:
  static bool run(std::ostream& out, const Triangulation& t) {
    Compact_numbers<Triangulation> numbers(t);
    Gluing_map mesh = numbered_copy(t.mesh(), numbers);
    return write_stored_triangulation<Metric>(
        out, {t.input(), t.metric(), std::move(mesh), std::move(numbers.of_vertices.old),
              std::move(numbers.of_edges.old), std::move(numbers.of_faces.old), coordinates(t)});
  }

private:
  static const Integer_coordinates* coordinates(const Triangulation& t) {
    const Integer_coordinates* result = nullptr;
    if constexpr (Metric::is_exact) {
      result = t.places_.coordinates(t);
      if (result == nullptr)
        throw std::length_error("an edge crosses more input edges than a file can count");
    } else if constexpr (Triangulation::has_correspondence) {
      if (t.input().is_defined_by_metric()) result = integer_coordinates_of(t.correspondence());
    }
    return result;
  }
};

} // namespace internal

/*!
\brief writes an intrinsic triangulation in the format of `intrinsic_triangulation_format.h`,
without loss.

Elements keep their order; those after removed ones move up to smaller numbers.
\tparam Triangulation an `Intrinsic_triangulation` with `Exact_euclidean_traits` or
  `Euclidean_traits<double>`, and any mesh
\param out the stream
\param t the triangulation
\throws std::runtime_error if the stream fails
\complexity linear in the mesh and, with exact traits, if no vertex was ever inserted, in the number
  of flips done
*/
template <IntrinsicTriangulation Triangulation>
void write_intrinsic_triangulation(std::ostream& out, const Triangulation& t) {
  static_assert(!internal::arithmetic_name<typename Triangulation::Metric>.empty(),
                "the file format holds exact traits and Euclidean_traits<double>");
  if (!internal::Intrinsic_triangulation_writer<Triangulation>::run(out, t))
    throw std::runtime_error("the intrinsic triangulation cannot be written completely");
}

/*!
\brief writes an intrinsic triangulation to a file, usually with extension `.idt`.

If anything fails, the file is unchanged: see `Replacing_file`. Otherwise see the overload with a
stream.
\param path the file
\param t the triangulation
\throws File_error naming the file if it cannot be written
*/
template <IntrinsicTriangulation Triangulation>
void write_intrinsic_triangulation(const std::filesystem::path& path, const Triangulation& t) {
  write_file(path, [&t](std::ostream& out) { write_intrinsic_triangulation(out, t); });
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_WRITE_INTRINSIC_TRIANGULATION_H
