// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gallery.h"
#include "mesh_types.h"
#include "meshes.h"
#include "stored_triangulations.h"
#include "subdivision_oracle.h"

#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Explicit_crossings.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Signposts.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/locate.h>
#include <CGAL/Intrinsic_triangulations/correspondence/queries/trace_edge.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/certify_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// The file format with inserted vertices: after reading, a triangulation works as before writing.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Move_status;
using stored::delaunay_signs;
using stored::Double;
using stored::Exact;
using stored::expect_equal;
using stored::from_text;
using stored::message_of;
using stored::replaced;
using stored::text;

/// Makes moves of all kinds, with simple weights now and then, which make ties; returns how many insertions, flips,
/// removals and repositions were done.
template <class T>
std::array<int, 4> move_at_random(T& t, unsigned seed, int moves) {
  subdivision_oracle::Mover<T> mover(t, seed);
  for (int i = 0; i < moves; ++i) {
    mover.is_simple = i % 2 == 0;
    mover.move(false);
  }
  return mover.done;
}

/// New numbers of elements, without gaps.
template <class Range, class Index>
std::map<std::uint32_t, std::uint32_t> ranks(const Range& elements, const Index& index) {
  std::map<std::uint32_t, std::uint32_t> result;
  for (const auto e : elements) result[index(e)] = 0;
  std::uint32_t n = 0;
  for (auto& [number, rank] : result) rank = n++;
  return result;
}

/// Expects that `back` is `t` with numbers without gaps, bit by bit.
template <class T>
void expect_same(const T& t, const T& back) {
  const auto index = [&t](auto e) { return t.index(e); };
  const auto vertex = ranks(vertices(t.mesh()), index), edge_ = ranks(edges(t.mesh()), index),
             face_ = ranks(faces(t.mesh()), index);
  const auto side = [&](IT::Gluing_map::Halfedge h) {
    return IT::Gluing_map::Halfedge{2 * edge_.at(h.index / 2) + h.index % 2};
  };
  ASSERT_EQ(back.mesh().number_of_vertices(), vertex.size());
  ASSERT_EQ(back.mesh().number_of_edges(), edge_.size());
  ASSERT_EQ(back.mesh().number_of_faces(), face_.size());
  EXPECT_EQ(back.input().number_of_vertices(), t.input().number_of_vertices());
  for (const auto v : vertices(t.mesh())) {
    const IT::Gluing_map::Vertex w{vertex.at(v.index)};
    EXPECT_EQ(back.is_inserted(w), t.is_inserted(v));
    if (!t.is_inserted(v)) {
      EXPECT_EQ(back.input_vertex(w), t.input_vertex(v));
    }
    const auto h = halfedge(v, t.mesh());
    EXPECT_EQ(halfedge(w, back.mesh()), h.index == IT::Gluing::none ? h : side(h));
  }
  for (const auto h : halfedges(t.mesh())) {
    EXPECT_EQ(next(side(h), back.mesh()), side(next(h, t.mesh())));
    EXPECT_EQ(target(side(h), back.mesh()).index, vertex.at(target(h, t.mesh()).index));
    const auto f = face(h, t.mesh()).index;
    EXPECT_EQ(face(side(h), back.mesh()).index, f == IT::Gluing::none ? f : face_.at(f));
  }
  const auto &m = t.metric(), &n = back.metric();
  for (const auto& [i, j] : edge_) {
    EXPECT_EQ(n.approximate_squared_length(j), m.approximate_squared_length(i));
    if constexpr (T::Metric::is_exact) {
      EXPECT_EQ(n.squared_length(j).inf(), m.squared_length(i).inf());
      EXPECT_EQ(n.squared_length(j).sup(), m.squared_length(i).sup());
    }
  }
  for (const auto& [i, j] : face_) {
    EXPECT_EQ(n.approximate_quadruple_area(j), m.approximate_quadruple_area(i));
    if constexpr (T::Metric::is_exact) {
      EXPECT_EQ(n.quadruple_area(j).inf(), m.quadruple_area(i).inf());
      EXPECT_EQ(n.quadruple_area(j).sup(), m.quadruple_area(i).sup());
    }
  }
  expect_equal(text(back), text(t));
}

/// Expects equal cotangent Laplacians bit by bit, except for empty rows of removed vertices.
template <class T>
void expect_same_laplacian(T& t, T& back) {
  const auto vertex = ranks(vertices(t.mesh()), [&t](auto v) { return t.input_vertex(v); });
  const Eigen::SparseMatrix<double> a = IT::cotangent_laplacian(t);
  const Eigen::SparseMatrix<double> b = IT::cotangent_laplacian(back);
  using Entries = std::map<std::pair<std::uint32_t, std::uint32_t>, double>;
  Entries expected, found;
  for (int c = 0; c < a.cols(); ++c)
    for (Eigen::SparseMatrix<double>::InnerIterator i(a, c); i; ++i) {
      const auto row = vertex.find(std::uint32_t(i.row())), col = vertex.find(std::uint32_t(c));
      if (row != vertex.end() && col != vertex.end())
        expected[{row->second, col->second}] = i.value();
      else
        EXPECT_EQ(i.value(), 0);
    }
  for (int c = 0; c < b.cols(); ++c)
    for (Eigen::SparseMatrix<double>::InnerIterator i(b, c); i; ++i)
      found[{std::uint32_t(i.row()), std::uint32_t(c)}] = i.value();
  EXPECT_EQ(b.rows(), int(vertex.size()));
  EXPECT_EQ(found, expected);
}

/// All values, independent of the numbers of the elements.
template <class T>
std::vector<double> sorted_values(const T& t) {
  std::vector<double> values;
  for (const auto e : edges(t.mesh())) values.push_back(t.squared_length(e));
  for (const auto f : faces(t.mesh())) values.push_back(-t.area(f));
  std::sort(values.begin(), values.end());
  return values;
}

template <class T>
class Stored_places : public testing::Test {};
using Triangulations = testing::Types<Exact, Double>;
TYPED_TEST_SUITE(Stored_places, Triangulations);

TYPED_TEST(Stored_places, Come_back_on_small_complexes) {
  std::array<int, 3> counts{};
  unsigned seed = 5;
  bool has_gaps = false;
  for (const gallery::Surface& surface : gallery::oriented()) {
    SCOPED_TRACE(surface.name);
    TypeParam t(gallery::input(surface));
    const auto done = move_at_random(t, seed++, 80);
    for (std::size_t k = 0; k < 3; ++k) counts[k] += done[k];
    has_gaps = has_gaps || t.mesh().has_garbage();
    TypeParam back = from_text<TypeParam>(text(t));
    expect_same(t, back);
    EXPECT_EQ(delaunay_signs(back), delaunay_signs(t));
    expect_same(t, back); // what predicates sharpened is the same too
    IT::flip_to_delaunay(t);
    IT::flip_to_delaunay(back);
    expect_same(t, back);
    expect_same_laplacian(t, back);
  }
  EXPECT_GT(counts[0], 100);
  EXPECT_GT(counts[1], 100);
  EXPECT_GT(counts[2], 20);
  EXPECT_TRUE(has_gaps);
}

// midpoints of squares and of their sides: many cocircular faces
TYPED_TEST(Stored_places, Keep_exact_ties) {
  TypeParam t(meshes::grid(3, 3).input());
  std::mt19937 random(3);
  for (int i = 0; i < 20; ++i) {
    const auto e =
        *std::next(edges(t.mesh()).begin(), std::ptrdiff_t(random() % num_edges(t.mesh())));
    t.split_edge(halfedge(e, t.mesh()), 0.5);
    IT::flip_to_delaunay(t);
  }
  TypeParam back = from_text<TypeParam>(text(t));
  const std::vector<CGAL::Sign> signs = delaunay_signs(t);
  EXPECT_GT(std::count(signs.begin(), signs.end(), CGAL::ZERO), 3);
  EXPECT_EQ(delaunay_signs(back), signs);
  expect_same_laplacian(t, back);
}

std::vector<meshes::Mesh> refined_meshes() {
  return {meshes::rough_grid(5, 3), meshes::potato(1, 5), meshes::grid(2, 12, 1, 0.05),
          meshes::integer_terrain(20, 30, 7)};
}

template <class T>
IT::Refinement_counts refine(T& t, double angle, double circumradius) {
  constexpr double any = std::numeric_limits<double>::infinity();
  const auto result =
      IT::delaunay_refine(t, IT::parameters::minimum_angle(angle).maximum_circumradius(
                                 circumradius > 0 ? circumradius : any));
  EXPECT_EQ(result.status, IT::Status::done);
  return result.counts;
}

TYPED_TEST(Stored_places, Go_on_after_refinement_as_if_not_stored) {
  std::uint64_t removals = 0, splits = 0;
  for (const meshes::Mesh& m : refined_meshes()) {
    TypeParam t(m.input());
    const IT::Refinement_counts counts = refine(t, 25, 0);
    removals += counts.removals;
    splits += counts.segment_splits;
    TypeParam back = from_text<TypeParam>(text(t));
    expect_same(t, back);
    EXPECT_EQ(delaunay_signs(back), delaunay_signs(t));
    expect_same_laplacian(t, back);
    const IT::Refinement_counts a = refine(t, 30, 0), b = refine(back, 30, 0);
    EXPECT_EQ(b.inserted_vertices(), a.inserted_vertices());
    EXPECT_EQ(b.flips, a.flips);
    EXPECT_EQ(b.removals, a.removals);
    EXPECT_EQ(sorted_values(back), sorted_values(t));
    EXPECT_EQ(IT::check_delaunay(back).non_delaunay_edges, 0U);
    // once more, where elements may be in another order
    TypeParam again = from_text<TypeParam>(text(back));
    expect_same(back, again);
  }
  EXPECT_GT(removals, 0U);
  EXPECT_GT(splits, 0U);
}

TYPED_TEST(Stored_places, Every_inserted_vertex_can_be_removed_from_what_is_read) {
  TypeParam t(meshes::rough_grid(4, 2).input());
  move_at_random(t, 8, 60);
  TypeParam back = from_text<TypeParam>(text(t));
  std::vector<typename TypeParam::vertex_descriptor> inserted;
  for (const auto v : vertices(back.mesh()))
    if (back.is_inserted(v)) inserted.push_back(v);
  ASSERT_GT(inserted.size(), 5U);
  for (const auto v : inserted) EXPECT_EQ(back.remove_vertex(v), Move_status::done);
  IT::flip_to_delaunay(back);
  TypeParam original(meshes::rough_grid(4, 2).input());
  IT::flip_to_delaunay(original);
  const auto a = sorted_values(back), b = sorted_values(original);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 1e-9);
}

template <class Mesh>
class Stored_places_on : public testing::Test {};
TYPED_TEST_SUITE(Stored_places_on, All_meshes);

TYPED_TEST(Stored_places_on, Any_mesh_type_come_back) {
  using T = IT::Intrinsic_triangulation<TypeParam, IT::Euclidean_traits<double>>;
  T t(meshes::rough_grid(3, 3).input());
  ASSERT_GT(move_at_random(t, 5, 60)[2], 0);
  T back = from_text<T>(text(t));
  expect_equal(text(back), text(t));
  Double other = from_text<Double>(text(t));
  expect_equal(text(other), text(t));
  EXPECT_EQ(delaunay_signs(back), delaunay_signs(other));
  IT::flip_to_delaunay(back);
  IT::flip_to_delaunay(other);
  expect_equal(text(back), text(other));
}

// ---- correspondence

template <class Traits, class Correspondence>
using Traced = IT::Intrinsic_triangulation<IT::Gluing_map, Traits, Correspondence>;
using Integer_exact = Traced<IT::Exact_euclidean_traits, IT::Integer_coordinates>;
using Integer_double = Traced<IT::Euclidean_traits<double>, IT::Integer_coordinates>;

template <class T>
class Stored_correspondence : public testing::Test {};
using All_traced = testing::Types<Integer_exact, Integer_double,
                                  Traced<IT::Exact_euclidean_traits, IT::Explicit_crossings>>;
TYPED_TEST_SUITE(Stored_correspondence, All_traced);

/// Expects the same paths, halfedge by halfedge and bit by bit. \pre numbers have no gaps
template <class T>
void expect_same_paths(const T& t, const T& back) {
  for (const auto e : edges(t.mesh())) {
    const IT::Edge_path a = IT::trace_edge(t, e), b = IT::trace_edge(back, e);
    EXPECT_EQ(a.along, b.along);
    ASSERT_EQ(a.points.size(), b.points.size());
    for (std::size_t i = 0; i < a.points.size(); ++i) {
      EXPECT_EQ(a.points[i].on_input.halfedge, b.points[i].on_input.halfedge);
      EXPECT_EQ(a.points[i].on_input.weights, b.points[i].on_input.weights);
      EXPECT_EQ(a.points[i].parameter, b.points[i].parameter);
    }
  }
}

template <class T>
void expect_same_subdivision(const T& t, const T& back) {
  const IT::Common_subdivision a = IT::common_subdivision(t), b = IT::common_subdivision(back);
  EXPECT_EQ(a.corner, b.corner);
  EXPECT_EQ(a.input_face, b.input_face);
  EXPECT_EQ(a.intrinsic_face, b.intrinsic_face);
  ASSERT_EQ(a.crossings.size(), b.crossings.size());
  for (std::size_t i = 0; i < a.crossings.size(); ++i) {
    EXPECT_EQ(a.crossings[i].on_input.edge, b.crossings[i].on_input.edge);
    EXPECT_EQ(a.crossings[i].on_input.parameter, b.crossings[i].on_input.parameter);
    EXPECT_EQ(a.crossings[i].on_intrinsic.parameter, b.crossings[i].on_intrinsic.parameter);
  }
  for (std::size_t v = 0; v < a.vertices.size(); ++v)
    EXPECT_EQ(a.vertices[v].input_face, b.vertices[v].input_face);
}

TYPED_TEST(Stored_correspondence, Comes_back_with_the_input) {
  for (const meshes::Mesh& m : refined_meshes()) {
    TypeParam t(m.input());
    refine(t, 25, 0);
    const TypeParam back = from_text<TypeParam>(text(t));
    expect_same(t, back);
    ASSERT_NE(back.input().surface(), nullptr);
    EXPECT_TRUE(back.input().is_defined_by_metric());
    ASSERT_EQ(back.input().number_of_halfedges(), t.input().number_of_halfedges());
    for (std::uint32_t h = 0; h < t.input().number_of_halfedges(); ++h) {
      EXPECT_EQ(back.input().next(h), t.input().next(h));
      EXPECT_EQ(back.input().target(h), t.input().target(h));
      EXPECT_EQ(back.input().face(h), t.input().face(h));
      EXPECT_EQ(back.input().squared_length(h / 2), t.input().squared_length(h / 2));
    }
    for (std::uint32_t f = 0; f < t.input().number_of_faces(); ++f) {
      EXPECT_EQ(back.input().halfedge_of_face(f), t.input().halfedge_of_face(f));
      EXPECT_EQ(back.input().quadruple_area(f), t.input().quadruple_area(f));
    }
  }
}

// a read triangulation has numbers without gaps, also after a second reading
TYPED_TEST(Stored_correspondence, Traces_subdivides_and_goes_on_as_if_not_stored) {
  for (const meshes::Mesh& m : refined_meshes()) {
    TypeParam unstored(m.input());
    refine(unstored, 25, 0);
    TypeParam t = from_text<TypeParam>(text(unstored)), back = from_text<TypeParam>(text(t));
    expect_same_paths(t, back);
    expect_same_subdivision(t, back);
    for (const auto f : faces(t.mesh())) {
      const IT::Surface_point p{t.numbers().halfedge(halfedge(f, t.mesh())), {0.25, 0.25, 0.5}};
      const auto a = IT::locate_on_input(t, p), b = IT::locate_on_input(back, p);
      ASSERT_TRUE(a && b);
      EXPECT_EQ(a->halfedge, b->halfedge);
      EXPECT_EQ(a->weights, b->weights);
    }
    const IT::Refinement_counts a = refine(t, 29, 0), b = refine(back, 29, 0),
                                c = refine(unstored, 29, 0);
    EXPECT_EQ(b.inserted_vertices(), a.inserted_vertices());
    EXPECT_EQ(b.flips, a.flips);
    expect_equal(text(back), text(t));
    EXPECT_EQ(c.inserted_vertices(), a.inserted_vertices());
    EXPECT_EQ(c.flips, a.flips);
    const auto x = sorted_values(unstored), y = sorted_values(t);
    ASSERT_EQ(x.size(), y.size());
    for (std::size_t i = 0; i < x.size(); ++i) // gaps change the order of what ties
      EXPECT_NEAR(x[i], y[i], 1e-11 * std::abs(x[i]));
    expect_same_subdivision(t, back);
  }
}

TYPED_TEST(Stored_correspondence, Comes_back_on_small_complexes) {
  for (const gallery::Surface& surface : gallery::oriented()) {
    SCOPED_TRACE(surface.name);
    TypeParam t(gallery::input(surface));
    move_at_random(t, 5, 40);
    TypeParam back = from_text<TypeParam>(text(t));
    expect_same(t, back);
    EXPECT_EQ(delaunay_signs(back), delaunay_signs(t));
    expect_same_laplacian(t, back);
    move_at_random(back, 6, 20);
    expect_same(back, from_text<TypeParam>(text(back)));
  }
}

TEST(Stored_correspondence, certificate_after_reading) {
  for (const meshes::Mesh& m : refined_meshes()) {
    Integer_exact t(m.input());
    refine(t, 25, 0);
    for (const auto& back : {t, from_text<Integer_exact>(text(t))}) {
      const IT::Delaunay_certificate c = IT::certify_delaunay(back);
      EXPECT_TRUE(c.is_delaunay());
      EXPECT_EQ(c.ties, IT::certify_delaunay(t).ties);
    }
  }
}

// with exact traits what was made without correspondence has one when it is read
TEST(Stored_correspondence, may_be_another_one_than_that_of_the_triangulation_that_was_written) {
  using Crossings_exact = Traced<IT::Exact_euclidean_traits, IT::Explicit_crossings>;
  using Signposts_exact = Traced<IT::Exact_euclidean_traits, IT::Signposts>;
  const auto flipped_and_refined = [](auto& t, bool insert) {
    IT::flip_to_delaunay(t);
    if (insert) refine(t, 25, 0);
    return text(t);
  };
  for (const meshes::Mesh& m : refined_meshes())
    for (const bool insert : {false, true}) {
      Exact none(m.input());
      Integer_exact integer(m.input());
      Signposts_exact signposts(m.input());
      const std::string s = flipped_and_refined(none, insert);
      expect_equal(flipped_and_refined(integer, insert), s);
      expect_equal(flipped_and_refined(signposts, insert), s);
      const Integer_exact back = from_text<Integer_exact>(s);
      expect_equal(text(back), s);
      expect_equal(text(from_text<Crossings_exact>(s)), s);
      expect_same_paths(back, from_text<Integer_exact>(text(integer)));
      EXPECT_TRUE(IT::certify_delaunay(back).is_delaunay());
    }
}

TEST(Stored_correspondence, is_not_there_where_doubles_were_written_without) {
  Double t(meshes::rough_grid(2, 3).input());
  IT::flip_to_delaunay(t);
  EXPECT_NE(message_of<Integer_double>(text(t)).find("No_correspondence"), std::string::npos);
  Integer_double traced(meshes::rough_grid(2, 3).input());
  IT::flip_to_delaunay(traced);
  expect_equal(text(from_text<Double>(text(traced))), text(t));
}

// ---- damage

/// A small file in which there are places of every kind: in a face, on an inner edge, on the border.
template <class T>
std::string file_with_all_places() {
  T t(meshes::rough_grid(2, 3).input());
  const auto side = [&t](bool is_on_border) {
    for (const auto h : halfedges(t.mesh()))
      if (face(h, t.mesh()).index != IT::Gluing::none &&
          (face(opposite(h, t.mesh()), t.mesh()).index == IT::Gluing::none) == is_on_border)
        return h;
    return typename T::halfedge_descriptor();
  };
  const auto first =
      t.insert_vertex(halfedge(*faces(t.mesh()).begin(), t.mesh()), {0.25, 0.25, 0.5});
  EXPECT_EQ(t.split_edge(side(true), 0.375).status, Move_status::done);
  EXPECT_EQ(t.insert_vertex(halfedge(*faces(t.mesh()).begin(), t.mesh()), {0.5, 0.25, 0.25}).status,
            Move_status::done);
  EXPECT_EQ(t.remove_vertex(first.vertex), Move_status::done);
  EXPECT_EQ(t.split_edge(side(false), 0.75).status, Move_status::done);
  IT::flip_to_delaunay(t);
  return text(t);
}

/// Expects that what is left of a file after a word of a line of a section has been replaced is refused, with that line
/// or, if `is_late`, another one; returns the message.
template <class T = Exact>
std::string refusal(const std::string& s, const std::string& section, std::size_t line,
                    std::size_t word, const std::string& by, bool is_late = false) {
  std::size_t begin = s.find("\n" + section + " ") + 1;
  EXPECT_NE(begin, 0U) << section;
  for (std::size_t i = 0; i < line; ++i) begin = s.find('\n', begin) + 1;
  const std::size_t end = s.find('\n', begin);
  std::istringstream old(s.substr(begin, end - begin));
  std::string result, w;
  for (std::size_t i = 0; old >> w; ++i) result += (i == 0 ? "" : " ") + (i == word ? by : w);
  EXPECT_NE(result, s.substr(begin, end - begin));
  const auto number = std::count(s.begin(), s.begin() + std::ptrdiff_t(begin), '\n') + 1;
  const std::string message = message_of<T>(s.substr(0, begin) + result + s.substr(end)),
                    place = "file.idt:" + (is_late ? "" : std::to_string(number) + ": ");
  EXPECT_EQ(message.rfind(place, 0), 0U) << result << "\n" << message;
  EXPECT_NE(message.find("write it again"), std::string::npos) << message;
  return message;
}

template <class T>
void expect_damaged_places_are_refused() {
  const std::string s = file_with_all_places<T>();
  ASSERT_EQ(message_of<T>(s), "");
  std::istringstream places(s.substr(s.find("\nplaces 3\n") + 10));
  std::array<std::size_t, 2> seen{}; // of kinds
  std::string line;
  for (std::size_t i = 1; i <= 3; ++i) {
    std::getline(places, line);
    const bool on_edge = line.rfind("edge ", 0) == 0;
    ++seen[on_edge ? 1 : 0];
    const auto damaged = [&](std::size_t word, const std::string& by, bool is_late = false) {
      return refusal<T>(s, "places", i, word, by, is_late);
    };
    EXPECT_NE(damaged(0, "corner").find("corner"), std::string::npos);
    damaged(0, on_edge ? "face" : "edge");
    EXPECT_NE(damaged(1, "4000000").find("does not exist"), std::string::npos);
    damaged(1, "-1");
    EXPECT_NE(damaged(2, "nan").find("weight"), std::string::npos);
    EXPECT_NE(damaged(2, "-0x1p-2").find("negative"), std::string::npos);
    EXPECT_NE(damaged(2, "0x1p+0").find("weights"), std::string::npos);
    EXPECT_NE(damaged(2, "0x1.0000000000001p-2").find("weights"), std::string::npos);
    // another halfedge of the input: of another edge or face, which edges of the triangulation do not start from
    std::istringstream words(line);
    std::string kind;
    std::uint32_t h = 0;
    words >> kind >> h;
    for (std::uint32_t x = 0; x < 16; ++x)
      if (x / 2 != h / 2 && (on_edge || x > h + 5 || x + 5 < h))
        damaged(1, std::to_string(x), true);
  }
  EXPECT_EQ(seen[0], 1U);
  EXPECT_EQ(seen[1], 2U);
  refusal<T>(s, "places", 0, 1, "2", true);
  refusal<T>(s, "places", 0, 1, "4", true);
}

TEST(Damaged_places, are_refused) {
  expect_damaged_places_are_refused<Exact>();
  expect_damaged_places_are_refused<Integer_double>();
}

template <class T>
void expect_damaged_coordinates_are_refused() {
  const std::string s = file_with_all_places<T>();
  const std::size_t normal = T::Metric::is_exact ? 3 : 1; // after the value
  std::istringstream all(s.substr(s.find("\nedges ") + 7));
  std::size_t count = 0;
  all >> count;
  std::string line;
  std::getline(all, line);
  for (std::size_t i = 1; i <= count; ++i) {
    std::getline(all, line);
    std::istringstream in(line);
    std::vector<std::string> words;
    for (std::string w; in >> w;) words.push_back(w);
    const std::string n = words[normal];
    for (const std::string other : {"-1", "0", "1", "2", "3", "7", "100000"})
      if (other != n) refusal<T>(s, "edges", i, normal, other, true);
    for (const std::string other : {"-2", "x", "134217729", "4000000000"})
      refusal<T>(s, "edges", i, normal, other);
    for (const std::size_t k : {normal + 1, normal + 2}) {
      for (std::uint32_t x = 0; x < 32; ++x)
        if (const std::string other = std::to_string(x); other != words[k])
          refusal<T>(s, "edges", i, k, other, true);
      if (words[k] != "-") refusal<T>(s, "edges", i, k, "-", true);
      refusal<T>(s, "edges", i, k, "32");
    }
  }
}

TEST(Damaged_coordinates, are_refused) {
  expect_damaged_coordinates_are_refused<Exact>();
  expect_damaged_coordinates_are_refused<Integer_double>();
}

TEST(Damaged_values, are_refused_where_places_contradict_them) {
  const std::string s = file_with_all_places<Exact>();
  Exact t = from_text<Exact>(s);
  // narrow intervals about wrong values
  const auto expect_refused = [&s](const auto& x, double approximate, double wrong,
                                   const std::string& what) {
    std::ostringstream line, other;
    line << std::hexfloat << x.inf() << " " << x.sup() << " " << approximate;
    other << std::hexfloat << wrong << " " << wrong << " " << wrong;
    EXPECT_NE(message_of(replaced(s, line.str(), other.str())).find(what), std::string::npos);
  };
  for (const auto e : edges(t.mesh())) {
    const auto x = t.metric().squared_length(e.index);
    expect_refused(x, t.metric().approximate_squared_length(e.index), 1.0001 * x.sup(),
                   "squared length of edge");
  }
  for (const auto f : faces(t.mesh())) {
    const auto x = t.metric().quadruple_area(f.index);
    expect_refused(x, t.metric().approximate_quadruple_area(f.index), 0.9999 * x.inf(),
                   "area of face");
  }
  // a coordinate of the input
  for (std::size_t v = 1; v <= 9; ++v) refusal(s, "input_vertices", v, 2 + v % 2, "0x1.8p+3", true);
  refusal(s, "delta", 0, 1, "0x1p-4", true);
}

TEST(Damaged_sections, are_refused) {
  const std::string s = file_with_all_places<Exact>();
  const auto expect_refused = [](const std::string& file, const std::string& what) {
    const std::string message = message_of(file);
    EXPECT_EQ(message.rfind("file.idt:", 0), 0U) << message;
    EXPECT_NE(message.find(what), std::string::npos) << message;
  };
  expect_refused(replaced(s, "scale ", "scale 2000000000"), "exponent");
  expect_refused(replaced(s, "input points", "input squared_lengths"), "");
  expect_refused(replaced(s, "input points", "input none"), "");
  expect_refused(replaced(s, "\npolygons 0\n", "\npolygons 1\n0\n"), "every face");
  expect_refused(replaced(s, "\nrows 0\n", "\nrows 1\n0\n"), "every vertex");
  expect_refused(replaced(s, "\nrows 0\n", "\nrows 2\n1\n0\n"), "row 1");
  expect_refused(replaced(s, "\nsheets 1\n", "\nsheets 0\n"), "sheets");
  for (const std::string count : {"input_vertices", "input_edges", "input_faces", "input_border",
                                  "vertices", "edges", "faces", "border", "places"}) {
    const std::size_t at = s.find("\n" + count + " ") + count.size() + 2;
    const std::size_t number = std::stoul(s.substr(at));
    for (const std::size_t other : {number - 1, number + 1, std::size_t(4000000000U)})
      expect_refused(s.substr(0, at) + std::to_string(other) + s.substr(s.find('\n', at)), "");
  }
  // names are given once, in their order unless renumbered
  for (const std::string element : {"vertices", "edges", "faces"})
    EXPECT_NE(refusal(s, "input_" + element, 1, 0, "1", true).find("name 1"), std::string::npos);
}

TEST(Damaged_sections, are_refused_where_halfedges_of_vertices_are_wrong) {
  const Exact t(meshes::rough_grid(2, 3).input());
  const std::string s = text(t);
  const std::uint32_t inner = [&t] { // of the first vertex, which is on the border
    for (const auto h : halfedges(t.mesh()))
      if (target(h, t.mesh()).index == 0 && face(h, t.mesh()).index != IT::Gluing::none)
        return h.index;
    return IT::Gluing::none;
  }();
  for (const std::string section : {"input_vertices", "vertices"}) {
    const std::size_t word = section == "vertices" ? 0 : 1;
    const auto damaged = [&](const std::string& by) {
      return refusal(s, section, 1, word, by, true);
    };
    EXPECT_NE(damaged("-").find("needs a halfedge"), std::string::npos);
    EXPECT_NE(damaged(std::to_string(inner)).find("not on the border"), std::string::npos);
    damaged("4000000");
  }
}

template <class T>
void expect_every_truncation_is_noticed() {
  const std::string s = file_with_all_places<T>();
  for (std::size_t length = 0; length + 1 < s.size(); ++length)
    ASSERT_NE(message_of<T>(s.substr(0, length)), "") << length;
}

TEST(Damaged_sections, are_refused_if_truncated) {
  expect_every_truncation_is_noticed<Exact>();
  expect_every_truncation_is_noticed<Double>();
  expect_every_truncation_is_noticed<Integer_double>();
}

template <class T>
unsigned refused_mutations(unsigned count) {
  const std::string s = file_with_all_places<T>();
  std::mt19937 random(20261);
  unsigned refused = 0;
  for (unsigned i = 0; i < count; ++i) {
    std::string changed = s;
    for (unsigned k = random() % 2; k < 2; ++k)
      changed[random() % changed.size()] = "0123456789abcdef -x\n"[random() % 20];
    try { // either it is refused, or what it says can be used
      T t = from_text<T>(changed);
      IT::flip_to_delaunay(t);
      text(t);
    } catch (const IT::Invalid_input&) {
      ++refused;
    }
  }
  return refused;
}

TEST(Damaged_sections, are_refused_or_usable_if_digits_change) {
  EXPECT_GT(refused_mutations<Exact>(1500), 500U);
  EXPECT_GT(refused_mutations<Double>(1500), 200U);
  EXPECT_GT(refused_mutations<Integer_exact>(1500), 500U);
  EXPECT_GT(refused_mutations<Integer_double>(1500), 200U);
}

} // namespace
