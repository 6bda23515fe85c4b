// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_TRIANGLE_SOUP_H
#define CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_TRIANGLE_SOUP_H

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/domains/Polygon_soup.h>
#include <CGAL/Intrinsic_triangulations/domains/triangulate_polygons.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>

#include <CGAL/number_utils.h>

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Collects the vertices and faces of a file, or of arrays, and refuses the first one that is
// unusable.
class Soup_builder {
public:
  // \param file the name of the file, for messages; empty: there is none
  // \param kind what is made of polygons that are not planar
  explicit Soup_builder(std::string file, Nonplanar_polygons kind = Nonplanar_polygons::fan)
      : file_(std::move(file)), kind_(kind) {}

  // Current line of the reader, from 1, for messages; 0 if the file has no lines.
  std::size_t line = 0;
  // Number of the first vertex in the file's own references, for messages.
  std::int64_t first_reference = 0;
  // Whether faces may refer to vertices that are still to come.
  bool forward_references = false;
  // Whether faces are required, and whether they are read: otherwise the vertices are a point
  // cloud, and faces are not checked.
  bool needs_faces = true, takes_faces = true;
  // Whether faces stay as they are, for `finish_polygons()`.
  bool keeps_polygons = false;

  std::size_t number_of_vertices() const { return soup_.points.size(); }
  const std::array<double, 3>& point(std::size_t v) const { return soup_.points[v]; }
  std::size_t number_of_faces() const { return soup_.input_faces; }

  [[noreturn]] void fail(Element_kind kind, std::size_t index, const std::string& what) const {
    fail_at(line, kind, index, what);
  }
  [[noreturn]] void fail(const std::string& what) const { fail(Element_kind::none, 0, what); }
  // Throws for the vertex or face to be added next; the message starts with its name.
  [[noreturn]] void fail_vertex(const std::string& what) const {
    fail(Element_kind::vertex, number_of_vertices(),
         "vertex " + std::to_string(number_of_vertices()) + what);
  }
  [[noreturn]] void fail_face(const std::string& what) const {
    fail(Element_kind::face, number_of_faces(), name(number_of_faces()) + what);
  }

  void reserve(std::size_t vertices, std::size_t faces) {
    soup_.points.reserve(vertices);
    soup_.triangles.reserve(faces);
  }

  void add_vertex(double x, double y, double z);

  void add_face(const std::vector<std::int64_t>& face);

  // Completes the soup; polygons are triangulated here.
  Triangle_soup finish();
  // Returns what was added.
  Polygon_soup finish_polygons();

private:
  // numbers of vertices are below `Gluing::none`, those of halfedges leave a bit for reversed ones
  static constexpr std::size_t maximal_vertices = Gluing::none - 1;
  static constexpr std::size_t maximal_triangles = Gluing::reversed_bit / 3 - 1;

  static std::string name(std::size_t f) { return "face " + std::to_string(f); }

  [[noreturn]] void fail_at(std::size_t at, Element_kind kind, std::size_t index,
                            const std::string& what) const;

  std::string out_of_range(std::size_t f, std::int64_t v) const;
  void check_latest_reference() const;

  void check_reference(std::size_t f, std::int64_t v);

  // Removes the parts without area of a face that lists a vertex twice: points, and lines there and
  // back.
  const std::vector<std::int64_t>& without_lines(const std::vector<std::int64_t>& face);

  // Several polygons may be one face with a hole.
  [[noreturn]] void fail_pinched(std::int64_t v) const;

  // From now on each triangle stores its face: until now each face was one triangle.
  void name_faces(std::size_t f);

  // A polygon takes the places of its triangles and is triangulated at the end.
  void append(std::size_t f, const std::vector<std::int64_t>& face);

  std::string file_;
  Nonplanar_polygons kind_;
  Triangle_soup soup_;
  Polygons polygons_;
  std::vector<std::vector<std::uint32_t>> kept_; // if polygons are kept
  std::vector<std::int64_t> sorted_, corners_;
  bool has_names_ = false;
  std::int64_t latest_reference_ = -1;
  std::size_t latest_face_ = 0, latest_line_ = 0;
};

} // namespace internal

/*!
\brief requires a range of points with `x()`, `y()` and `z()`, or of arrays of three coordinates.

Syntax of \ref ::PointRange, where its meaning is described.
*/
template <class Range>
concept PointRange = requires(const Range& points) {
  CGAL::to_double((*std::begin(points)).x());
}
|| requires(const Range& points) { CGAL::to_double((*std::begin(points))[0]); };

/*!
\brief requires a range of ranges of integers: the numbers of the vertices of each face.

Syntax of \ref ::FaceRange, where its meaning is described.
*/
template <class Range>
concept FaceRange = requires(const Range& faces) {
  { *std::begin(*std::begin(faces)) } -> std::convertible_to<std::int64_t>;
};

/*!
\brief makes a soup of points and faces in arrays.

It triangulates polygons and removes repeated vertices as `read_triangle_soup()` does. Faces need no
other property: `make_domain()` makes a surface of any.
\tparam Points a model of `PointRange`
\tparam Faces a model of `FaceRange`: vertices are in their order around the face
\param points the points
\param faces the faces
\param polygons what is made of polygons that are not planar
\throws Invalid_input naming a point with a coordinate that is not finite; or a face with fewer than
  three points, with one that does not exist, with area on two sides of one that occurs twice, or
  that cannot be triangulated; or if there are no faces
\complexity linear for polygons of bounded size
*/
template <PointRange Points, FaceRange Faces>
Triangle_soup triangle_soup(const Points& points, const Faces& faces,
                            Nonplanar_polygons polygons = Nonplanar_polygons::fan) {
  internal::Soup_builder builder{std::string(), polygons};
  for (const auto& p : points)
    if constexpr (requires { p.x(); })
      builder.add_vertex(CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z()));
    else
      builder.add_vertex(CGAL::to_double(p[0]), CGAL::to_double(p[1]), CGAL::to_double(p[2]));
  std::vector<std::int64_t> corners;
  for (const auto& face : faces) {
    corners.clear();
    for (const auto v : face) corners.push_back(static_cast<std::int64_t>(v));
    builder.add_face(corners);
  }
  return builder.finish();
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_DOMAINS_TRIANGLE_SOUP_H
