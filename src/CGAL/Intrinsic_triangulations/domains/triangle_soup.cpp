// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/domains/triangle_soup.h>
#include <CGAL/Intrinsic_triangulations/domains/triangulate_polygons.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

void Soup_builder::add_vertex(double x, double y, double z) {
  const std::size_t v = soup_.points.size();
  if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z))
    fail_vertex(" has a coordinate that is not a finite number; correct the coordinate, or remove "
                "the vertex and its faces");
  if (std::max({std::abs(x), std::abs(y), std::abs(z)}) > 0x1p500)
    fail_vertex(" has a coordinate beyond 2^500 (3e150), where areas are infinite in doubles; "
                "scale the mesh, "
                "or correct the coordinate");
  if (v == maximal_vertices)
    fail(Element_kind::vertex, v, "there are more than 4294967294 vertices; split the mesh");
  soup_.points.push_back({x, y, z});
}

void Soup_builder::add_face(const std::vector<std::int64_t>& face) {
  const std::size_t f = soup_.input_faces;
  if (!takes_faces) {
    ++soup_.input_faces;
    return;
  }
  if (face.size() < 3)
    fail_face(" has " + std::to_string(face.size()) + (face.size() == 1 ? " vertex" : " vertices") +
              "; a face needs at least three: remove it");
  for (const std::int64_t v : face) check_reference(f, v);
  if (soup_.triangles.size() + face.size() - 2 > maximal_triangles)
    fail(Element_kind::face, f, "the file has more than 715827881 triangles; split the mesh");
  if (keeps_polygons)
    kept_.emplace_back(face.begin(), face.end());
  else
    append(f, without_lines(face));
  ++soup_.input_faces;
}

void Soup_builder::check_latest_reference() const {
  if (latest_reference_ >= std::int64_t(soup_.points.size()) && soup_.input_faces != 0)
    fail_at(latest_line_, Element_kind::face, latest_face_,
            out_of_range(latest_face_, latest_reference_));
}

Polygon_soup Soup_builder::finish_polygons() {
  check_latest_reference();
  if (soup_.points.empty())
    fail_at(0, Element_kind::none, 0, "the file has no points; get a complete copy");
  return {std::move(soup_.points), std::move(kept_)};
}

Triangle_soup Soup_builder::finish() {
  check_latest_reference();
  if (!takes_faces) soup_.input_faces = 0;
  if (soup_.input_faces == 0 && needs_faces)
    fail_at(0, Element_kind::none, 0,
            "the file has no faces; give a surface mesh, or make a point cloud of its points");
  if (soup_.input_faces != 0 && soup_.triangles.empty())
    fail_at(0, Element_kind::none, 0,
            "no face has three different vertices; correct the faces, or make a point cloud of "
            "the points");
  if (soup_.input_faces == 0 && soup_.points.empty())
    fail_at(0, Element_kind::none, 0, "the file has no points; get a complete copy");
  triangulate_polygons(polygons_, kind_, soup_, [this](std::size_t f, const std::string& what) {
    fail_at(0, Element_kind::face, f, what);
  });
  return std::move(soup_);
}

void Soup_builder::fail_at(std::size_t at, Element_kind kind, std::size_t index,
                           const std::string& what) const {
  throw Invalid_input(kind, index,
                      file_ + (at == 0 ? "" : ":" + std::to_string(at)) +
                          (file_.empty() ? "" : ": ") + what);
}

std::string Soup_builder::out_of_range(std::size_t f, std::int64_t v) const {
  const auto count = std::int64_t(soup_.points.size());
  return name(f) + " refers to vertex " + std::to_string(v + first_reference) +
         (count == 0 ? ", but the file has no vertices"
                     : ", but vertices are numbered from " + std::to_string(first_reference) +
                           " to " + std::to_string(count - 1 + first_reference)) +
         "; correct the index or remove the face";
}

void Soup_builder::check_reference(std::size_t f, std::int64_t v) {
  const auto count = std::int64_t(soup_.points.size());
  if (v < 0 || (v >= count && !forward_references) || v >= std::int64_t(maximal_vertices))
    fail(Element_kind::face, f, out_of_range(f, v));
  if (v >= count && v > latest_reference_) {
    latest_reference_ = v;
    latest_face_ = f;
    latest_line_ = line;
  }
}

const std::vector<std::int64_t>&
Soup_builder::without_lines(const std::vector<std::int64_t>& face) {
  if (face.size() == 3 && face[0] != face[1] && face[1] != face[2] && face[2] != face[0])
    return face;
  sorted_.assign(face.begin(), face.end());
  std::sort(sorted_.begin(), sorted_.end());
  if (std::adjacent_find(sorted_.begin(), sorted_.end()) == sorted_.end()) return face;
  ++soup_.faces_with_repeated_vertices;
  std::vector<std::int64_t> way, polygon; // around the face; the part of it that is a polygon
  std::unordered_map<std::int64_t, std::size_t> place; // of a vertex on the way
  const auto take = [&](std::size_t first) {
    if (way.size() - first >= 3) {
      if (!polygon.empty()) fail_pinched(way[first]);
      polygon.assign(way.begin() + static_cast<std::ptrdiff_t>(first), way.end());
    }
    for (std::size_t i = first; i < way.size(); ++i) place.erase(way[i]);
    way.resize(first);
  };
  for (const std::int64_t v : face) {
    if (const auto before = place.find(v); before != place.end()) take(before->second);
    place[v] = way.size();
    way.push_back(v);
  }
  take(0);
  corners_ = std::move(polygon);
  return corners_;
}

void Soup_builder::fail_pinched(std::int64_t v) const {
  fail_face(" repeats vertex " + std::to_string(v + first_reference) +
            ", and has area on both sides of it; cut the face there into faces that each list a "
            "vertex once");
}

void Soup_builder::name_faces(std::size_t f) {
  if (has_names_) return;
  has_names_ = true;
  soup_.polygon_of_triangle.reserve(soup_.triangles.capacity());
  for (std::size_t t = 0; t < f; ++t)
    soup_.polygon_of_triangle.push_back(static_cast<std::uint32_t>(t));
}

void Soup_builder::append(std::size_t f, const std::vector<std::int64_t>& face) {
  const auto corner = [&](std::size_t i) { return static_cast<std::uint32_t>(face[i]); };
  if (face.size() > 3) {
    polygons_.add(f, soup_.triangles.size());
    for (std::size_t i = 0; i < face.size(); ++i) polygons_.corners.push_back(corner(i));
    ++soup_.triangulated_polygons;
  }
  if (face.size() != 3) name_faces(f);
  for (std::size_t i = 2; i < face.size(); ++i) {
    soup_.triangles.push_back({corner(0), corner(i - 1), corner(i)});
    if (has_names_) soup_.polygon_of_triangle.push_back(static_cast<std::uint32_t>(f));
  }
}

} // namespace CGAL::Intrinsic_triangulations::internal
