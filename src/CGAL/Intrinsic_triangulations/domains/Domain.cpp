// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Incidence_reader.h>
#include <CGAL/Intrinsic_triangulations/connectivity/as_gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/build_gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/signed_incidence.h>
#include <CGAL/Intrinsic_triangulations/domains/Domain.h>
#include <CGAL/Intrinsic_triangulations/domains/check_coordinates.h>
#include <CGAL/Intrinsic_triangulations/domains/domain_of_stars.h>
#include <CGAL/Intrinsic_triangulations/domains/tufted_cover.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>
#include <CGAL/Intrinsic_triangulations/support/ranges.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

// Makes a surface, or a cover of it, from triangles that are glued in pairs and their other data.
class Domain_maker {
public:
  // \param input what the surface is but for the mesh
  // \param faces how the triangles are glued
  // \param edge of the squared lengths, by sides of faces; empty if the input has points
  Domain_maker(Intrinsic_input input, Domain_report report, Gluing faces,
               std::vector<std::uint32_t> edge)
      : result_{std::move(input), std::move(report)}, faces_(std::move(faces)),
        edge_(std::move(edge)) {}

  // If no edge has more than two faces. `conflict` is a side of one at which two of them disagree,
  // if there is one.
  Domain make(Domain_kind kind, std::uint32_t conflict) {
    if (kind == Domain_kind::tufted_cover || kind == Domain_kind::orientation_cover)
      return cover(kind, "you asked for it");
    if (kind == Domain_kind::closed)
      for (std::uint32_t h = 0; h < faces_.glue.size(); ++h)
        if (faces_.glue[h] == Gluing::none)
          return cover(Domain_kind::tufted_cover,
                       "face " + std::to_string(face_name(h / 3, names())) +
                           " is alone at an edge, and a surface without border was asked for");
    const Orientation_result r =
        conflict == Gluing::none ? Orientation_result{} : orient_faces(faces_);
    if (r.is_orientable) return manifold(r.reversed_faces);
    if (kind == Domain_kind::manifold) fail_orientation(faces_, conflict, names());
    return cover(
        Domain_kind::orientation_cover,
        "the surface has only one side: faces " + std::to_string(face_name(conflict / 3, names())) +
            " and " +
            std::to_string(face_name(Gluing::partner(faces_.glue[conflict]) / 3, names())) +
            " disagree, and no reversal of faces orients it");
  }

  // The cover of faces that are not glued in pairs.
  Domain finish(Double_cover cover, Domain_kind kind, std::string reason) {
    std::vector<std::uint32_t> vertex;
    Gluing_map mesh = Gluing_map::from_valid(cover.take(vertex, corners()));
    Intrinsic_input& in = result_.input;
    in.squared_lengths = squared_lengths(mesh, &Double_cover::side);
    in.mesh = std::move(mesh);
    if (!in.points.empty()) {
      std::vector<std::array<double, 3>> points;
      points.reserve(vertex.size());
      for (const std::uint32_t v : vertex) points.push_back(in.points[v]);
      in.points = std::move(points);
    }
    in.names = names_of_cover(std::move(vertex));
    result_.report.sheets = in.names.sheets;
    result_.report.kind = kind;
    result_.report.reason = std::move(reason);
    return std::move(result_);
  }

private:
  const std::vector<std::uint32_t>& names() const {
    return result_.input.names.polygon_of_triangle;
  }

  Domain manifold(const std::vector<char>& reversed) {
    Intrinsic_input& in = result_.input;
    const auto side = [&reversed](std::uint32_t h) { // as `orient_faces()` renames them
      return !reversed.empty() && reversed[h / 3] != 0 ? h - h % 3 + (2 - h % 3) : h;
    };
    if (in.mesh.number_of_faces() == 0 ||
        !reversed.empty()) { // else it is kept, with the numbers of its edges
      Gluing_map mesh = Gluing_map::from_valid(faces_);
      in.squared_lengths = squared_lengths(mesh, side);
      in.mesh = std::move(mesh);
    }
    in.reversed_faces = number_of_reversed(reversed, in.names.polygon_of_triangle);
    result_.report.kind = Domain_kind::manifold;
    result_.report.sheets = in.names.sheets;
    result_.report.reason = "every edge has at most two faces, and they agree in orientation";
    if (in.reversed_faces > 0)
      result_.report.reason +=
          " once " + std::to_string(in.reversed_faces) + " of them were turned around";
    return std::move(result_);
  }

  Domain cover(Domain_kind kind, const std::string& reason) {
    Double_cover cover(faces_);
    for (std::uint32_t h = 0; h < faces_.glue.size(); ++h) {
      const std::uint32_t other = Gluing::partner(faces_.glue[h]);
      if (other == Gluing::none) {
        if (kind == Domain_kind::tufted_cover) cover.glue(std::array{Edge_side{h, true}});
      } else if (h < other)
        cover.glue(
            std::array{Edge_side{h, true}, Edge_side{other, Gluing::is_reversed(faces_.glue[h])}});
    }
    return finish(std::move(cover), kind, reason);
  }

  // \param side the side of `faces_`, as given, that side k of face f of the mesh is, by 3f + k
  template <class Side>
  std::vector<double> squared_lengths(const Gluing_map& mesh, const Side& side) const {
    std::vector<double> result;
    if (edge_.empty()) return result;
    result.resize(mesh.number_of_edges());
    for (std::uint32_t f = 0; f < mesh.number_of_faces(); ++f)
      for (std::uint32_t k = 0; k < 3; ++k)
        result[mesh.sides({f})[k].index / 2] =
            result_.input.squared_lengths[edge_[side(3 * f + k)]];
    return result;
  }

  // The length of a side of `faces_`, rounded.
  double length(std::uint32_t h) const {
    const Intrinsic_input& in = result_.input;
    if (!edge_.empty()) return std::sqrt(in.squared_lengths[edge_[h]]);
    const std::array<double, 3>&p = in.points[faces_.origin[h]],
                             &q = in.points[faces_.origin[Gluing::next(h)]];
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  }

  // The corners of the triangles at the sources of their sides, rounded. Triangles without area,
  // and lengths that break the triangle inequality by rounding, have the angles 0 or pi.
  std::vector<Double_cover::Corner> corners() const {
    std::vector<Double_cover::Corner> result;
    result.reserve(faces_.origin.size());
    for (std::uint32_t h = 0; h < faces_.origin.size(); ++h) {
      const double a = length(h), b = length(Gluing::next(Gluing::next(h))),
                   c = length(Gluing::next(h)), x = ((a - b) + c) / a, y = ((b - a) + c) / b;
      const double square = x * y / 4; // of the sine of half of the angle
      result.push_back({square > 0 ? 2 * std::asin(std::sqrt(std::min(square, 1.))) : 0, c});
    }
    return result;
  }

  Input_names names_of_cover(std::vector<std::uint32_t> vertex) const {
    const Input_names& below = result_.input.names;
    Input_names names;
    names.sheets = 2 * below.sheets;
    for (std::uint32_t& v : vertex) v = below.row(v);
    names.row_of_vertex = std::move(vertex);
    names.polygon_of_triangle.reserve(2 * std::size_t{faces_.number_of_faces()});
    for (std::uint32_t f = 0; f < faces_.number_of_faces(); ++f)
      names.polygon_of_triangle.insert(names.polygon_of_triangle.end(), 2, below.polygon(f));
    return names;
  }

  Domain result_;
  Gluing faces_;
  std::vector<std::uint32_t> edge_;
};

void check_size_of_cover(std::size_t faces) {
  constexpr std::size_t most = Gluing::reversed_bit / 6; // two copies have six halfedges
  if (faces > most)
    throw Invalid_input(Element_kind::none, 0,
                        "a cover is made of at most " + std::to_string(most) +
                            " faces; split the mesh");
}

// Glues faces and makes a domain of them.
// \param edge the edge of each halfedge, if `input` has squared lengths
// \param refuse, describe called with an edge that has more than two faces: throws, or returns what
// it is
template <class Refuse, class Describe>
Domain domain_of_faces(Intrinsic_input&& input, Gluing&& faces, const Sides_by_edge& edges,
                       std::vector<std::uint32_t> edge, Domain_kind kind, const Refuse& refuse,
                       const Describe& describe, decltype(tufted_cover)& cover_of = tufted_cover) {
  Domain_report report;
  const Shared_edges shared = glue_pairs(faces, edges, [&](std::uint32_t e) {
    if (kind == Domain_kind::manifold || kind == Domain_kind::orientation_cover) refuse(e);
    if (report.nonmanifold_edges++ == 0) report.reason = describe(e);
  });
  report.unoriented_edges = shared.conflicts;
  if (report.nonmanifold_edges == 0)
    return Domain_maker(std::move(input), report, std::move(faces), std::move(edge))
        .make(kind, shared.conflict);
  Double_cover cover = cover_of(faces, edges, input.points);
  return Domain_maker(std::move(input), report, std::move(faces), std::move(edge))
      .finish(std::move(cover), Domain_kind::tufted_cover, report.reason);
}

static void expect_lengths_of_all(std::size_t triangles, std::size_t lengths) {
  if (lengths != triangles)
    throw Invalid_input(Element_kind::none, 0,
                        "there are " + std::to_string(lengths) +
                            " triples of lengths; give one for each of the " +
                            std::to_string(triangles) + " triangles");
}

// The square of the length of each edge, in which its sides must agree.
// \param edge the edge of each side, three for each triangle \param edges how many there are
static std::vector<double>
squared_lengths_of_edges(std::span<const std::uint32_t> edge, std::size_t edges,
                         const std::vector<std::array<double, 3>>& lengths) {
  std::vector<double> result(edges, -1); // lengths at first
  for (std::size_t side = 0; side < edge.size(); ++side) {
    const double l = lengths[side / 3][side % 3];
    const auto refuse = [&](const std::string& why) {
      throw Invalid_input(Element_kind::face, side / 3,
                          "lengths[" + std::to_string(side / 3) + ", " + std::to_string(side % 3) +
                              "] is " + shortest_text(l) + why);
    };
    if (!(l >= 0)) refuse("; give lengths that are not negative");
    double& known = result[edge[side]]; // up to the rounding of ten digits in a file
    if (known >= 0 && std::abs(l - known) > 1e-9 * std::max(l, known))
      refuse(", but the other side of that edge has the length " + shortest_text(known) +
             "; give both sides of an edge one length");
    if (known < 0) known = l;
  }
  for (double& l : result) l *= l;
  return result;
}

static Domain domain_of_soup(Triangle_soup&& soup, Domain_kind kind, Mollification mollification,
                             decltype(tufted_cover)& cover_of) {
  check_coordinates(soup.points);
  check_size_of_cover(soup.triangles.size());
  Gluing faces = unglued_triangles(static_cast<std::uint32_t>(soup.points.size()), soup.triangles);
  const Sides_by_edge edges = sides_by_edge(faces);
  Intrinsic_input input;
  input.points = std::move(soup.points);
  input.mollification = mollification;
  input.triangulated_polygons = soup.triangulated_polygons;
  input.names.polygon_of_triangle = std::move(soup.polygon_of_triangle);
  input.planar_polygons = std::move(soup.planar_polygons);
  const std::vector<std::uint32_t>& names = input.names.polygon_of_triangle;
  return domain_of_faces(
      std::move(input), std::move(faces), edges, {}, kind,
      [&](std::uint32_t e) { fail_nonmanifold(faces, edges[e], names); },
      [&](std::uint32_t e) { return edge_with_faces(faces, edges[e], names); }, cover_of);
}

Domain domain_of_stars(Triangle_soup stars, Mollification mollification) {
  return domain_of_soup(std::move(stars), Domain_kind::tufted_cover, mollification, cover_of_stars);
}

} // namespace internal

Domain make_domain(Triangle_soup soup, Domain_kind kind, Mollification mollification) {
  return internal::domain_of_soup(std::move(soup), kind, mollification, internal::tufted_cover);
}

Domain make_domain(Intrinsic_input input, Domain_kind kind) {
  internal::check_coordinates(input.points);
  internal::check_sizes(input);
  internal::check_size_of_cover(input.mesh.number_of_faces());
  Gluing faces = gluing_from_map(input.mesh);
  Domain_report report;
  std::uint32_t conflict = Gluing::none;
  for (std::uint32_t h = 0; h < faces.glue.size(); ++h)
    if (Gluing::is_reversed(faces.glue[h]) && h < Gluing::partner(faces.glue[h]) &&
        report.unoriented_edges++ == 0)
      conflict = h;
  std::vector<std::uint32_t> edge;
  if (!input.squared_lengths.empty())
    for (std::uint32_t f = 0; f < input.mesh.number_of_faces(); ++f)
      for (const Gluing_map::Halfedge h : input.mesh.sides({f})) edge.push_back(h.index / 2);
  return internal::Domain_maker(std::move(input), report, std::move(faces), std::move(edge))
      .make(kind, conflict);
}

Domain make_domain(std::uint32_t number_of_vertices,
                   const std::vector<std::array<std::uint32_t, 3>>& triangles,
                   const std::vector<std::array<double, 3>>& lengths, Domain_kind kind,
                   Mollification mollification) {
  internal::check_size_of_cover(triangles.size());
  internal::expect_lengths_of_all(triangles.size(), lengths.size());
  Gluing faces = internal::unglued_triangles(number_of_vertices, triangles);
  const internal::Sides_by_edge edges = internal::sides_by_edge(faces);
  Intrinsic_input input;
  input.mollification = mollification;
  std::vector<std::uint32_t> edge(faces.origin.size());
  for (std::uint32_t e = 0; e < edges.number_of_edges(); ++e)
    for (const internal::Edge_side& s : edges[e]) edge[s.halfedge] = e;
  input.squared_lengths =
      internal::squared_lengths_of_edges(edge, edges.number_of_edges(), lengths);
  return internal::domain_of_faces(
      std::move(input), std::move(faces), edges, std::move(edge), kind,
      [&](std::uint32_t e) { internal::fail_nonmanifold(faces, edges[e], {}); },
      [&](std::uint32_t e) { return internal::edge_with_faces(faces, edges[e], {}); });
}

Domain make_domain(Gluing_map mesh, const std::vector<std::array<double, 3>>& lengths,
                   Domain_kind kind, Mollification mollification) {
  internal::expect_lengths_of_all(mesh.number_of_faces(), lengths.size());
  std::vector<std::uint32_t> edge;
  for (std::uint32_t f = 0; f < mesh.number_of_faces(); ++f)
    for (const auto side : mesh.sides(Gluing_map::Face{f})) edge.push_back(side.index / 2);
  std::vector<double> squares =
      internal::squared_lengths_of_edges(edge, mesh.number_of_edges(), lengths);
  return make_domain(Intrinsic_input(std::move(mesh), std::move(squares), mollification), kind);
}

Domain make_domain(const Signed_incidence& s, std::vector<double> squared_lengths, Domain_kind kind,
                   Mollification mollification) {
  internal::check_size_of_cover(s.number_of_faces);
  if (squared_lengths.size() != s.number_of_edges)
    throw Invalid_input(Element_kind::none, 0,
                        "there are " + std::to_string(squared_lengths.size()) +
                            " squared lengths; give one for each of the " +
                            std::to_string(s.number_of_edges) + " edges");
  internal::Incidence_reader read(s);
  Intrinsic_input input;
  input.squared_lengths = std::move(squared_lengths);
  input.mollification = mollification;
  return internal::domain_of_faces(
      std::move(input), std::move(read.gluing), read.edges, std::move(read.edge_of_halfedge), kind,
      [&read](std::uint32_t e) { read.fail_shared(e); },
      [&read](std::uint32_t e) {
        return "edge " + std::to_string(e) + " has " + std::to_string(read.edges[e].size()) +
               " faces";
      });
}

} // namespace CGAL::Intrinsic_triangulations
