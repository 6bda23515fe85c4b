// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "base64.h"
#include "refusals.h"
#include "subdivisions.h"

#include <CGAL/Intrinsic_triangulations/IO/soup/read_triangle_soup.h>
#include <CGAL/Intrinsic_triangulations/IO/subdivision/write_common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/intrinsic_face_colors.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/subdivision_edges.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

using Subdivision = IT::Common_subdivision;
using Points = subdivisions::Points;
using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Polygons = std::vector<std::vector<std::size_t>>;

struct Example {
  Subdivision s;
  Points points; // of the subdivision
};

Example grid(std::uint32_t n) {
  Example result{subdivisions::grid(n), {}};
  result.points = IT::positions(result.s, subdivisions::grid_points(n));
  return result;
}

Example tetrahedron() {
  const double x = 1. / 3;
  return {subdivisions::tetrahedron(), {{0, 0, 0}, {x, 0, 0}, {0, 1e-300, 1e300}, {-x, -0.1, 7}}};
}

// an inserted vertex with a location in a face: only its labels are meant
Example labelled() {
  Example e = grid(2);
  e.s.vertices[4] = {
      17, IT::Subdivision_vertex_kind::inserted, 3, {3, {1, 4, 5}, {0.25, 0.125, 0.625}}};
  e.s.number_of_intrinsic_vertices = 18;
  for (IT::Common_subdivision::Crossing& c : e.s.crossings)
    std::replace(c.on_intrinsic.vertices.begin(), c.on_intrinsic.vertices.end(), 4U, 17U);
  return e;
}

template <class NP = IT::parameters::Parameters<>>
std::string written(const std::string& extension, const Example& e,
                    const NP& np = IT::parameters::default_values(),
                    std::span<const IT::Subdivision_field> fields = {}) {
  std::ostringstream out;
  IT::write_common_subdivision(out, extension, e.s, e.points, fields, np);
  return out.str();
}

double area(const Point& a, const Point& b, const Point& c) {
  return std::sqrt(CGAL::to_double(CGAL::squared_area(a, b, c)));
}
double total_area(const std::vector<Point>& points, const Polygons& polygons) {
  double result = 0;
  for (const auto& p : polygons)
    for (std::size_t k = 2; k < p.size(); ++k)
      result += area(points[p[0]], points[p[k - 1]], points[p[k]]);
  return result;
}

void expect_same_mesh(const Example& e, const std::vector<Point>& points,
                      const Polygons& polygons) {
  ASSERT_EQ(points.size(), e.points.size());
  for (std::size_t v = 0; v < points.size(); ++v)
    EXPECT_EQ(points[v], Point(e.points[v][0], e.points[v][1], e.points[v][2]));
  ASSERT_EQ(polygons.size(), e.s.number_of_faces());
  for (std::size_t f = 0; f < polygons.size(); ++f)
    EXPECT_EQ(polygons[f], std::vector<std::size_t>(e.s.face(f).begin(), e.s.face(f).end()));
}

// ---- a reader of PLY for the types written here ------------------------------------------

using Row = std::map<std::string, std::vector<double>>;

template <class T>
double read_binary(std::istream& in) {
  T x{};
  in.read(reinterpret_cast<char*>(&x), sizeof(T)); // test machines are little endian
  return static_cast<double>(x);
}

double read_number(std::istream& in, const std::string& type, bool binary) {
  if (!binary) {
    std::string word;
    in >> word;
    return std::stod(word);
  }
  if (type == "uchar") return read_binary<std::uint8_t>(in);
  if (type == "int") return read_binary<std::int32_t>(in);
  EXPECT_EQ(type, "double");
  return read_binary<double>(in);
}

std::map<std::string, std::vector<Row>> read_PLY(const std::string& file) {
  std::istringstream in(file);
  struct Element {
    std::string name;
    std::size_t count;
    std::vector<std::array<std::string, 3>> properties; // type, type of the length, name
  };
  std::vector<Element> elements;
  bool binary = false;
  for (std::string line; std::getline(in, line) && line != "end_header";) {
    std::istringstream words(line);
    std::string word, type, length, name;
    words >> word;
    if (word == "format") binary = line.find("binary_little_endian") != std::string::npos;
    if (word == "element") {
      elements.emplace_back();
      words >> elements.back().name >> elements.back().count;
    }
    if (word != "property") continue;
    words >> type;
    if (type == "list") words >> length >> type;
    words >> name;
    elements.back().properties.push_back({type, length, name});
  }
  std::map<std::string, std::vector<Row>> result;
  for (const Element& e : elements)
    for (std::size_t i = 0; i < e.count; ++i) {
      Row& row = result[e.name].emplace_back();
      for (const auto& [type, length, name] : e.properties) {
        const double n = length.empty() ? 1 : read_number(in, length, binary);
        for (int k = 0; k < n; ++k) row[name].push_back(read_number(in, type, binary));
      }
    }
  EXPECT_TRUE(in.good());
  in >> std::ws;
  EXPECT_EQ(in.peek(), std::istringstream::traits_type::eof()) << "something follows the elements";
  return result;
}

double label(std::uint32_t i) { return i == Subdivision::none ? -1 : double(i); }

void expect_location(const Row& row, const std::string& name, std::size_t size,
                     const IT::Weighted_vertices& w) {
  for (std::size_t i = 0; i < size; ++i) {
    const std::string k = std::to_string(i);
    EXPECT_EQ(row.at(name + "_vertex_" + k)[0], i < w.size ? label(w.vertices[i]) : -1);
    EXPECT_EQ(row.at(name + "_weight_" + k)[0], i < w.size ? w.weights[i] : 0);
  }
}

void expect_labels(const Example& e, std::map<std::string, std::vector<Row>> ply) {
  ASSERT_EQ(ply["vertex"].size(), e.points.size());
  for (std::size_t v = 0; v < e.points.size(); ++v) {
    const Row& row = ply["vertex"][v];
    EXPECT_EQ(row.at("z")[0], e.points[v][2]);
    EXPECT_EQ(row.at("kind")[0], static_cast<int>(e.s.kind(v)));
    expect_location(row, "input", 3, e.s.on_input(v));
    expect_location(row, "intrinsic", 2, e.s.on_intrinsic(v));
    const bool is_crossing = v >= e.s.vertices.size();
    const std::size_t c = v - e.s.vertices.size();
    EXPECT_EQ(row.at("input_face")[0], is_crossing ? -1 : label(e.s.vertices[v].input_face));
    EXPECT_EQ(row.at("input_edge")[0], is_crossing ? label(e.s.crossings[c].on_input.edge) : -1);
    EXPECT_EQ(row.at("intrinsic_edge")[0],
              is_crossing ? label(e.s.crossings[c].on_intrinsic.edge) : -1);
  }
  const std::vector<IT::Rgb_color> colors = IT::intrinsic_face_colors(e.s);
  ASSERT_EQ(ply["face"].size(), e.s.number_of_faces());
  for (std::size_t f = 0; f < e.s.number_of_faces(); ++f) {
    const Row& row = ply["face"][f];
    EXPECT_EQ(row.at("vertex_indices"),
              std::vector<double>(e.s.face(f).begin(), e.s.face(f).end()));
    EXPECT_EQ(row.at("input_face")[0], label(e.s.input_face[f]));
    EXPECT_EQ(row.at("intrinsic_face")[0], label(e.s.intrinsic_face[f]));
    EXPECT_EQ(row.at("green")[0], colors[e.s.intrinsic_face[f]][1]);
  }
  std::size_t edges = 0;
  IT::for_each_subdivision_edge(
      e.s, [&](std::uint32_t a, std::uint32_t b, const Subdivision::Side& side) {
        ASSERT_LT(edges, ply["edge"].size());
        const Row& row = ply["edge"][edges++];
        EXPECT_EQ(row.at("vertex1")[0], a);
        EXPECT_EQ(row.at("vertex2")[0], b);
        EXPECT_EQ(row.at("input_edge")[0], label(side.input_edge));
        EXPECT_EQ(row.at("intrinsic_edge")[0], label(side.intrinsic_edge));
      });
  EXPECT_EQ(edges, ply["edge"].size());
}

// ---- a reader of VTP for the structure written here --------------------------------------

std::string attribute(const std::string& tag, const std::string& name) {
  const std::size_t begin = tag.find(' ' + name + "=\"") + name.size() + 3;
  EXPECT_NE(tag.find(' ' + name + "=\""), std::string::npos) << name << " in " << tag;
  return tag.substr(begin, tag.find('"', begin) - begin);
}

// the numbers of an array in a section
std::vector<double> vtp_array(const std::string& file, const std::string& section,
                              const std::string& name) {
  const std::size_t from = file.find('<' + section + '>'), to = file.find("</" + section + '>');
  EXPECT_NE(to, std::string::npos);
  const std::string part = file.substr(from, to - from);
  const std::size_t at = part.find(" Name=\"" + name + '"');
  if (at == std::string::npos) {
    ADD_FAILURE() << section << " has no " << name;
    return {};
  }
  const std::size_t tag = part.rfind('<', at), content = part.find(">\n", at) + 2;
  const std::string type = attribute(part.substr(tag, content - tag), "type");
  const std::string bytes =
      base64::decoded(part.substr(content, part.find('\n', content) - content));
  std::istringstream in(bytes);
  EXPECT_EQ(read_binary<std::uint64_t>(in), static_cast<double>(bytes.size() - 8));
  std::vector<double> result;
  while (in.peek() != std::istringstream::traits_type::eof())
    result.push_back(type == "UInt8"     ? read_binary<std::uint8_t>(in)
                     : type == "Int32"   ? read_binary<std::int32_t>(in)
                     : type == "Int64"   ? read_binary<std::int64_t>(in)
                     : type == "Float64" ? read_binary<double>(in)
                                         : throw std::runtime_error(type));
  EXPECT_FALSE(in.fail());
  return result;
}

} // namespace

// ---- tests --------------------------------------------------------------------------------------

TEST(Write_common_subdivision, Gives_CGAL_the_same_polygons_without_loss_as_OFF_OBJ_and_PLY) {
  for (const Example& e : {grid(1), grid(7), tetrahedron(), labelled()}) {
    {
      std::vector<Point> points;
      Polygons polygons;
      std::istringstream in(written("off", e));
      ASSERT_TRUE(CGAL::IO::read_OFF(in, points, polygons));
      expect_same_mesh(e, points, polygons);
    }
    {
      std::vector<Point> points;
      Polygons polygons;
      std::istringstream in(written("obj", e));
      ASSERT_TRUE(CGAL::IO::read_OBJ(in, points, polygons));
      expect_same_mesh(e, points, polygons);
    }
    for (const bool binary : {false, true}) {
      std::vector<Point> points;
      Polygons polygons;
      std::istringstream in(written("ply", e, IT::parameters::use_binary_mode(binary)));
      ASSERT_TRUE(CGAL::IO::read_PLY(in, points, polygons));
      expect_same_mesh(e, points, polygons);
    }
  }
}

// Rounding to single precision moves a coordinate by a relative 2^-24; the coordinates are below 7 and
// the triangles have angles far from 0, so that the area changes by less than 1e-5 of itself.
TEST(Write_common_subdivision, Gives_CGAL_triangles_of_the_same_area_as_STL) {
  const Example e = grid(7);
  std::vector<Point> points, exact;
  Polygons triangles, polygons;
  std::istringstream in(written("stl", e));
  ASSERT_TRUE(CGAL::IO::read_STL(in, points, triangles));
  EXPECT_EQ(triangles.size(), e.s.corner.size() - 2 * e.s.number_of_faces());
  EXPECT_EQ(points.size(), e.points.size());
  for (const auto& p : e.points) exact.emplace_back(p[0], p[1], p[2]);
  for (std::size_t f = 0; f < e.s.number_of_faces(); ++f)
    polygons.emplace_back(e.s.face(f).begin(), e.s.face(f).end());
  const double expected = total_area(exact, polygons);
  EXPECT_NEAR(total_area(points, triangles), expected, 1e-5 * expected);
}

TEST(Write_common_subdivision, Splits_polygons_into_fans_for_STL) {
  Example e;
  subdivisions::add_input_vertices(e.s, 5);
  subdivisions::add_face(e.s, {0, 1, 2, 3, 4}, std::vector<subdivisions::Side>(5, {0, 0}), 0, 0);
  e.points = {{0, 0, 1}, {2, 0, 1}, {3, 1, 1}, {2, 2, 1}, {0, 2, 1}};
  const std::string file = written("stl", e);
  ASSERT_EQ(file.size(), 84u + 3 * 50);
  EXPECT_NE(file.substr(0, 5), "solid");
  std::istringstream in(file.substr(80));
  EXPECT_EQ(read_binary<std::uint32_t>(in), 3);
  for (std::size_t k = 2; k < 5; ++k) {
    for (const double x : {0., 0., 1.}) EXPECT_EQ(read_binary<float>(in), x) << "normal";
    for (const std::size_t v : {std::size_t{0}, k - 1, k})
      for (const double x : e.points[v]) EXPECT_EQ(read_binary<float>(in), x);
    EXPECT_EQ(read_binary<std::uint16_t>(in), 0);
  }
}

TEST(Write_common_subdivision, Takes_the_parameter_of_CGAL) {
  const std::string text = written("ply", grid(2), CGAL::parameters::use_binary_mode(false));
  EXPECT_EQ(text.substr(0, 21), "ply\nformat ascii 1.0\n");
  EXPECT_EQ(text, written("ply", grid(2), IT::parameters::use_binary_mode(false)));
}

TEST(Write_common_subdivision, Writes_all_labels_to_PLY_as_text_and_in_binary) {
  for (const Example& e : {grid(1), grid(4), tetrahedron(), labelled()})
    for (const bool binary : {false, true})
      expect_labels(e, read_PLY(written("ply", e, IT::parameters::use_binary_mode(binary))));
}

TEST(Write_common_subdivision, Writes_all_labels_and_lines_to_VTP) {
  for (const Example& e : {grid(1), grid(4), tetrahedron(), labelled()}) {
    const std::string file = written("vtp", e);
    const std::size_t n = e.points.size(), faces = e.s.number_of_faces();
    const IT::Edge_polylines lines = IT::intrinsic_edge_polylines(e.s);
    const std::size_t piece = file.find("<Piece");
    const std::string tag = file.substr(piece, file.find('>', piece) - piece);
    EXPECT_EQ(attribute(tag, "NumberOfPoints"), std::to_string(n));
    EXPECT_EQ(attribute(tag, "NumberOfLines"), std::to_string(lines.size()));
    EXPECT_EQ(attribute(tag, "NumberOfPolys"), std::to_string(faces));
    const std::vector<double> points = vtp_array(file, "Points", "Points"),
                              kind = vtp_array(file, "PointData", "kind"),
                              vertices = vtp_array(file, "PointData", "input_vertices"),
                              weights = vtp_array(file, "PointData", "input_weights"),
                              intrinsic = vtp_array(file, "PointData", "intrinsic_vertices");
    ASSERT_EQ(points.size(), 3 * n);
    ASSERT_EQ(weights.size(), 3 * n);
    ASSERT_EQ(intrinsic.size(), 2 * n);
    for (std::size_t v = 0; v < n; ++v) {
      EXPECT_EQ(kind[v], static_cast<int>(e.s.kind(v)));
      const IT::Weighted_vertices w = e.s.on_input(v);
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(points[3 * v + i], e.points[v][i]);
        EXPECT_EQ(vertices[3 * v + i], i < w.size ? label(w.vertices[i]) : -1);
        EXPECT_EQ(weights[3 * v + i], i < w.size ? w.weights[i] : 0);
      }
      EXPECT_EQ(intrinsic[2 * v], label(e.s.on_intrinsic(v).vertices[0]));
    }
    const std::vector<double> connectivity = vtp_array(file, "Polys", "connectivity"),
                              offsets = vtp_array(file, "Polys", "offsets");
    EXPECT_EQ(connectivity, std::vector<double>(e.s.corner.begin(), e.s.corner.end()));
    EXPECT_EQ(offsets, std::vector<double>(e.s.face_begin.begin() + 1, e.s.face_begin.end()));
    EXPECT_EQ(vtp_array(file, "Lines", "connectivity"),
              std::vector<double>(lines.vertices.begin(), lines.vertices.end()));
    EXPECT_EQ(vtp_array(file, "Lines", "offsets"),
              std::vector<double>(lines.begin.begin() + 1, lines.begin.end()));
    const std::vector<double> input_face = vtp_array(file, "CellData", "input_face"),
                              intrinsic_edge = vtp_array(file, "CellData", "intrinsic_edge");
    ASSERT_EQ(input_face.size(), lines.size() + faces);
    for (std::size_t f = 0; f < faces; ++f)
      EXPECT_EQ(input_face[lines.size() + f], label(e.s.input_face[f]));
    for (std::size_t l = 0; l < lines.size(); ++l) EXPECT_EQ(intrinsic_edge[l], double(l));
  }
}

TEST(Write_common_subdivision, Writes_fields_to_PLY_and_VTP) {
  const Example e = grid(3);
  std::vector<double> height, noise;
  for (std::size_t v = 0; v < e.points.size(); ++v) {
    height.push_back(e.points[v][2]);
    noise.push_back(std::sin(double(v * v)));
  }
  const std::vector<IT::Subdivision_field> fields{{"height", height}, {"u.2", noise}};
  for (const bool binary : {false, true}) {
    auto ply = read_PLY(written("ply", e, IT::parameters::use_binary_mode(binary), fields));
    for (std::size_t v = 0; v < e.points.size(); ++v) {
      EXPECT_EQ(ply["vertex"][v]["height"][0], height[v]);
      EXPECT_EQ(ply["vertex"][v]["u.2"][0], noise[v]);
    }
    expect_labels(e, ply);
  }
  const std::string vtp = written("vtp", e, IT::parameters::default_values(), fields);
  EXPECT_EQ(vtp_array(vtp, "PointData", "height"), height);
  EXPECT_EQ(vtp_array(vtp, "PointData", "u.2"), noise);
}

TEST(Write_common_subdivision, Writes_vectors_and_fields_of_faces_to_PLY_and_VTP) {
  using Place = IT::Subdivision_field::Place;
  const Example e = grid(3);
  const unsigned seed = 5;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
  std::normal_distribution<double> number;
  const auto vectors = [&](std::size_t n) {
    std::vector<std::array<double, 3>> result(n);
    for (std::array<double, 3>& p : result)
      for (double& x : p) x = number(random);
    return result;
  };
  const std::size_t faces = e.s.number_of_faces();
  const std::vector<std::array<double, 3>> at_vertices = vectors(e.points.size()),
                                           at_faces = vectors(faces);
  std::vector<double> index;
  for (std::size_t f = 0; f < faces; ++f) index.push_back(number(random));
  // vertices and faces may have fields of the same name
  const std::vector<IT::Subdivision_field> fields{{"direction", at_vertices},
                                                  {"direction", at_faces, Place::faces},
                                                  {"index", index, Place::faces}};
  const std::array<std::string, 3> components{"direction_x", "direction_y", "direction_z"};
  for (const bool binary : {false, true}) {
    auto ply = read_PLY(written("ply", e, IT::parameters::use_binary_mode(binary), fields));
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t v = 0; v < e.points.size(); ++v)
        EXPECT_EQ(ply["vertex"][v][components[c]][0], at_vertices[v][c]);
      for (std::size_t f = 0; f < faces; ++f)
        EXPECT_EQ(ply["face"][f][components[c]][0], at_faces[f][c]);
    }
    for (std::size_t f = 0; f < faces; ++f) EXPECT_EQ(ply["face"][f]["index"][0], index[f]);
    expect_labels(e, ply);
  }
  for (const bool lines : {false, true}) { // which come before faces
    const std::string vtp = written("vtp", e, IT::parameters::lines(lines), fields);
    EXPECT_NE(vtp.find("Name=\"direction\" NumberOfComponents=\"3\""), std::string::npos);
    const std::vector<double> of_vertices = vtp_array(vtp, "PointData", "direction"),
                              of_cells = vtp_array(vtp, "CellData", "direction"),
                              numbers = vtp_array(vtp, "CellData", "index");
    const std::size_t first = numbers.size() - faces;
    EXPECT_EQ(first > 0, lines);
    ASSERT_EQ(of_cells.size(), 3 * numbers.size());
    ASSERT_EQ(of_vertices.size(), 3 * e.points.size());
    for (std::size_t i = 0; i < of_vertices.size(); ++i)
      EXPECT_EQ(of_vertices[i], at_vertices[i / 3][i % 3]);
    for (std::size_t i = 0; i < of_cells.size(); ++i)
      EXPECT_EQ(of_cells[i], i < 3 * first ? 0 : at_faces[i / 3 - first][i % 3]);
    for (std::size_t i = 0; i < numbers.size(); ++i)
      if (i < first)
        EXPECT_TRUE(std::isnan(numbers[i]));
      else
        EXPECT_EQ(numbers[i], index[i - first]);
  }
}

TEST(Write_common_subdivision, Contains_the_intrinsic_edges_as_lines_if_so_asked) {
  const Example e = grid(2);
  EXPECT_EQ(written("obj", e).find("\nl "), std::string::npos);
  EXPECT_NE(written("obj", e, IT::parameters::lines(true)).find("\nl "), std::string::npos);
  const std::string vtp = written("vtp", e, IT::parameters::lines(false));
  EXPECT_NE(vtp.find("NumberOfLines=\"0\""), std::string::npos);
  EXPECT_TRUE(vtp_array(vtp, "Lines", "connectivity").empty());
  EXPECT_EQ(vtp_array(vtp, "CellData", "input_face").size(), e.s.number_of_faces());
}

TEST(Write_common_subdivision, Labels_faces_and_lines_of_OBJ_in_comments) {
  const std::string obj = written("obj", grid(1), IT::parameters::lines(true));
  EXPECT_NE(obj.find("# intrinsic_face 1 input_faces 0 1\nf 2 4 5\nf 4 3 5\n"), std::string::npos)
      << obj;
  EXPECT_NE(obj.find("# intrinsic_edge 4\nl 3 5 2\n"), std::string::npos) << obj;
}

TEST(Write_common_subdivision, Gives_OBJ_the_fields_u_and_v_as_texture_coordinates) {
  const Example e = grid(1); // five vertices
  const auto obj = [&e](const std::vector<IT::Subdivision_field>& fields) {
    std::ostringstream out;
    IT::write_common_subdivision(out, "obj", e.s, e.points, fields);
    return out.str();
  };
  const IT::Subdivision_field u{"u", std::vector<double>{0, 1, 0, 1, 0.5}},
      v{"v", std::vector<double>{0, 0, 2, 2, 1}};
  const std::string both = obj({u, v});
  EXPECT_NE(both.find("\nvt 0 0\nvt 1 0\nvt 0 2\nvt 1 2\nvt 0.5 1\n"), std::string::npos) << both;
  EXPECT_NE(both.find("\nf 2/2 4/4 5/5\nf 4/4 3/3 5/5\n"), std::string::npos) << both;
  EXPECT_EQ(obj({u}), obj({}));
}

TEST(Write_common_subdivision, Gives_OBJ_and_PLY_numbers_at_corners) {
  const Example e = grid(1); // four triangles around vertex 4
  std::vector<double> u, v(e.s.corner.size(), 0.5);
  for (const std::uint32_t c : e.s.corner) u.push_back(c);
  u.front() += 10; // a seam
  const auto file = [&](std::string_view extension,
                        const std::vector<IT::Subdivision_field>& fields) {
    std::ostringstream out;
    IT::write_common_subdivision(out, extension, e.s, e.points, fields,
                                 IT::parameters::use_binary_mode(false));
    return out.str();
  };
  constexpr auto corners = IT::Subdivision_field::Place::corners;
  const std::vector<IT::Subdivision_field> fields{{"u", u, corners}, {"v", v, corners}};
  const std::string obj = file("obj", fields), ply = file("ply", fields);
  std::size_t places = 0;
  for (std::size_t i = obj.find("\nvt "); i != std::string::npos; i = obj.find("\nvt ", i + 1))
    ++places;
  EXPECT_EQ(places, e.points.size() + 1);
  EXPECT_NE(obj.find("\nvt " + std::to_string(e.s.corner[0] + 10) + " 0.5\n"), std::string::npos)
      << obj;
  EXPECT_NE(obj.find("/1 "), std::string::npos);
  EXPECT_NE(ply.find("property list uchar double u\nproperty list uchar double v\n"
                     "property list uchar float texcoord\n"),
            std::string::npos)
      << ply;
  EXPECT_EQ(file("vtp", fields), file("vtp", {}));
  u.pop_back();
  EXPECT_THROW(file("obj", {{"u", u, corners}}), IT::Invalid_input);
  EXPECT_THROW(file("ply", {{"texcoord", v, corners}}), IT::Invalid_input);
}

TEST(Write_common_subdivision, Writes_an_empty_subdivision) {
  for (const std::string_view extension : IT::common_subdivision_extensions)
    EXPECT_FALSE(written(std::string(extension), {}).empty());
}

TEST(Write_common_subdivision, Takes_the_extension_in_any_letter_case_and_with_a_dot) {
  EXPECT_EQ(written(".OFF", grid(2)), written("off", grid(2)));
  EXPECT_THROW(written("idt", grid(2)), IT::Invalid_input);
  EXPECT_THROW(written("", grid(2)), IT::Invalid_input);
}

TEST(Write_common_subdivision, Says_what_to_do_if_there_are_no_positions) {
  for (const std::string_view extension : IT::common_subdivision_extensions)
    EXPECT_NE(refusals::refusal([&] {
                written(std::string(extension), {subdivisions::grid(1), {}});
              }).find("give a position"),
              std::string::npos)
        << extension;
  EXPECT_THROW(written("ply", {subdivisions::grid(1), Points(4)}), IT::Invalid_input);
}

TEST(Write_common_subdivision, Refuses_fields_that_would_spoil_the_file) {
  const Example e = grid(1);
  const std::vector<double> values(e.points.size(), 1.5);
  const std::span<const double> all = values;
  const auto refuses = [&](const std::vector<IT::Subdivision_field>& fields) {
    EXPECT_THROW(written("ply", e, IT::parameters::default_values(), fields), IT::Invalid_input);
    EXPECT_THROW(written("vtp", e, IT::parameters::default_values(), fields), IT::Invalid_input);
  };
  refuses({{"u", all.first(4)}});
  refuses({{"two words", all}});
  refuses({{"", all}});
  refuses({{"a\"b", all}});
  refuses({{"kind", all}});
  refuses({{"u", all}, {"u", all}});
  const std::vector<std::array<double, 3>> vectors(e.points.size());
  refuses({{"u", vectors}, {"u", all}});
  refuses({{"u", vectors}, {"u_x", all}}); // a name of PLY
  refuses({{"u", std::span(vectors).first(1)}});
  refuses(
      {{"sheet", std::vector<double>(e.s.number_of_faces()), IT::Subdivision_field::Place::faces}});
}

TEST(Write_common_subdivision, Refuses_coordinates_that_STL_cannot_hold) {
  EXPECT_THROW(written("stl", tetrahedron()), IT::Invalid_input); // 1e300
}

TEST(Write_common_subdivision, Reports_that_the_stream_fails) {
  const Example e = grid(1);
  for (const std::string_view extension : IT::common_subdivision_extensions) {
    std::ostringstream out;
    out.setstate(std::ios::badbit);
    EXPECT_THROW(IT::write_common_subdivision(out, extension, e.s, e.points), std::runtime_error);
  }
}

TEST(Write_common_subdivision, Ignores_the_locale_of_the_stream) {
  struct Comma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  const Example e = grid(20);
  for (const std::string_view extension : IT::common_subdivision_extensions) {
    std::ostringstream out;
    out.imbue(std::locale(std::locale::classic(), new Comma));
    IT::write_common_subdivision(out, extension, e.s, e.points);
    EXPECT_EQ(out.str(), written(std::string(extension), e));
  }
}

TEST(Write_common_subdivision, Writes_files_that_are_read_as_triangle_soups) {
  const Example e = grid(9);
  const auto path = std::filesystem::temp_directory_path() / "test_write_common_subdivision";
  for (const std::string extension : {".ply", ".obj", ".off", ".stl"}) {
    const std::string file = path.string() + extension;
    IT::write_common_subdivision(std::filesystem::path(file), e.s, e.points);
    const auto soup = IT::read_triangle_soup(file);
    EXPECT_EQ(soup.points.size(), e.points.size());
    EXPECT_EQ(soup.triangles.size(), e.s.corner.size() - 2 * e.s.number_of_faces());
    std::filesystem::remove(file);
  }
}

TEST(Write_common_subdivision, Leaves_a_file_as_it_was_if_it_refuses) {
  const auto path = std::filesystem::temp_directory_path() / "test_write_refused.ply";
  std::ofstream(path) << "before";
  EXPECT_THROW(IT::write_common_subdivision(path, subdivisions::grid(1), Points()),
               IT::Invalid_input);
  std::string content;
  std::ifstream(path) >> content;
  EXPECT_EQ(content, "before");
  std::filesystem::remove(path);
}
