// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_READ_INTRINSIC_TRIANGULATION_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_READ_INTRINSIC_TRIANGULATION_H

#include <CGAL/Intrinsic_triangulations/IO/idt/intrinsic_triangulation_format.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Vertex_places.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/triangulation/concepts.h>

#include <filesystem>
#include <fstream>
#include <istream>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// The contents of a file.
template <class Metric>
struct Stored_triangulation {
  std::shared_ptr<const Input_definition> input;
  Gluing_map mesh;
  Metric metric;
  std::optional<Integer_coordinates> coordinates; // if the input has a surface
};

// Reads a file with the arithmetic of `Metric`. `lies_on_input`: coordinates are needed.
template <class Metric>
Stored_triangulation<Metric> read_stored_triangulation(std::istream& in, const std::string& name,
                                                       bool lies_on_input);

std::ifstream open_triangulation(const std::filesystem::path& path);

} // namespace internal

/*!
\brief reads an intrinsic triangulation in the format of `intrinsic_triangulation_format.h`.

Values, input and the order of elements are those of the written triangulation, so that later moves
have exactly the same results; numbers have no gaps after removals. The file does not keep how
predicates were decided.

The correspondence may differ from that of the written triangulation: none, integer coordinates or
explicit crossings, unless the file has only doubles.

It checks what safe use needs: counts and numbers are valid, the faces fit together, values are not
negative, and curves are the edges of the input. With exact traits it unfolds each face over the
input in interval arithmetic; values that contradict the stored ones are an error.
\tparam Triangulation an `Intrinsic_triangulation` with the arithmetic of the file, and any mesh
\param in the stream
\param name name of the file, for messages
\throws Invalid_input naming the file and the line if it is truncated or malformed, is of another
  version or of another arithmetic, or lacks how the triangulation lies on its input although a
  correspondence needs it
\complexity linear in the mesh and in the crossings of its edges with those of the input; memory
  follows the size of the file, never a count in it, but for explicit crossings
*/
template <IntrinsicTriangulation Triangulation>
Triangulation read_intrinsic_triangulation(std::istream& in, const std::string& name) {
  static_assert(!internal::arithmetic_name<typename Triangulation::Metric>.empty(),
                "the file format holds exact traits and Euclidean_traits<double>");
  constexpr bool is_readable =
      RestorableCorrespondence<typename Triangulation::Correspondence, Triangulation>;
  static_assert(is_readable, "files hold integer coordinates, from which signposts are not made; "
                             "read with Integer_coordinates");
  auto stored = internal::read_stored_triangulation<typename Triangulation::Metric>(
      in, name, Triangulation::has_correspondence);
  if constexpr (!Triangulation::has_correspondence)
    if (!stored.coordinates)
      return Triangulation(std::move(stored.mesh), std::move(stored.metric), stored.input);
  return Triangulation(std::move(stored.mesh), std::move(stored.metric),
                       std::shared_ptr<const Input>(stored.input, stored.input->surface()),
                       *stored.coordinates);
}

/*!
\brief reads an intrinsic triangulation from a file: see the overload with a stream.
\param path the file
\throws Invalid_input also if the file cannot be opened
*/
template <IntrinsicTriangulation Triangulation>
Triangulation read_intrinsic_triangulation(const std::filesystem::path& path) {
  std::ifstream in = internal::open_triangulation(path);
  return read_intrinsic_triangulation<Triangulation>(in, path.string());
}

/*!
\brief returns the arithmetic of a stored intrinsic triangulation: `"exact"` or `"double"`.
\param path the file
\throws Invalid_input naming the file and the line if the file cannot be opened, or is of another
  format or version
\complexity constant
*/
std::string read_intrinsic_triangulation_arithmetic(const std::filesystem::path& path);

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_READ_INTRINSIC_TRIANGULATION_H
