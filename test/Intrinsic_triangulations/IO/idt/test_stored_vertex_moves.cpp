// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gallery.h"
#include "mesh_types.h"
#include "meshes.h"
#include "stored_triangulations.h"

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/is_delaunay.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
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

// The file format with inserted vertices: what is read goes on as what was written.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Move_status;
using stored::delaunay_signs;
using stored::Double;
using stored::Exact;
using stored::from_text;
using stored::message_of;
using stored::replaced;
using stored::text;

IT::Intrinsic_input input_of(const gallery::Surface& s) {
  return {IT::Gluing_map(s.gluing), gallery::squared_lengths(s), IT::Mollification::none};
}

/// Makes moves of all kinds; weights are multiples of 1/8 now and then, which makes ties.
template <class T>
class Random_moves {
public:
  Random_moves(T& t, unsigned seed) : t_(t), random_(seed) {}

  void run(unsigned moves) {
    for (unsigned i = 0; i < moves; ++i) step();
  }
  /// how many of each kind were done: insertions, removals, flips
  std::array<unsigned, 3> counts{};

private:
  using Halfedge = typename T::halfedge_descriptor;

  void step() {
    const Halfedge h = any_halfedge();
    switch (random_() % 6) {
    case 0:
      add(t_.insert_vertex(h, weights()));
      break;
    case 1:
      add(t_.split_edge(h, weights()[0]));
      break;
    case 2:
      remove();
      break;
    default:
      count(2, t_.flip_edge(h));
    }
  }

  void add(const typename T::Insertion& n) { count(0, n.status); }

  void remove() {
    std::vector<typename T::vertex_descriptor> inserted;
    for (const auto v : vertices(t_.mesh()))
      if (t_.is_inserted(v)) inserted.push_back(v);
    if (!inserted.empty()) count(1, t_.remove_vertex(inserted[random_() % inserted.size()]));
  }

  void count(std::size_t kind, Move_status s) { counts[kind] += s == Move_status::done ? 1 : 0; }

  Halfedge any_halfedge() {
    std::vector<Halfedge> all;
    for (const auto f : faces(t_.mesh())) {
      Halfedge h = halfedge(f, t_.mesh());
      for (int k = 0; k < 3; ++k, h = next(h, t_.mesh())) all.push_back(h);
    }
    return all[random_() % all.size()];
  }

  std::array<double, 3> weights() {
    if (random_() % 2 == 0) return {0.25, 0.25, 0.5};
    std::uniform_real_distribution<double> weight(0.2, 0.4);
    const double a = weight(random_), b = weight(random_);
    return {a, b, 1 - a - b};
  }

  T& t_;
  std::mt19937 random_;
};

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
  EXPECT_EQ(text(back), text(t));
}

/// Expects equal cotangent Laplacians bit by bit, but for empty rows of removed vertices.
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

/// All values, whatever the numbers of the elements.
template <class T>
std::vector<double> sorted_values(const T& t) {
  std::vector<double> values;
  for (const auto e : edges(t.mesh())) values.push_back(t.squared_length(e));
  for (const auto f : faces(t.mesh())) values.push_back(-t.area(f));
  std::sort(values.begin(), values.end());
  return values;
}

template <class T>
class Stored_vertex_moves : public testing::Test {};
using Triangulations = testing::Types<Exact, Double>;
TYPED_TEST_SUITE(Stored_vertex_moves, Triangulations);

TYPED_TEST(Stored_vertex_moves, Come_back_on_small_complexes) {
  std::array<unsigned, 3> counts{};
  bool has_gaps = false;
  for (const gallery::Surface& surface : gallery::oriented()) {
    SCOPED_TRACE(surface.name);
    TypeParam t(input_of(surface));
    Random_moves<TypeParam> moves(t, 5);
    moves.run(40);
    for (std::size_t k = 0; k < 3; ++k) counts[k] += moves.counts[k];
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
  EXPECT_GT(counts[0], 100U);
  EXPECT_GT(counts[1], 20U);
  EXPECT_GT(counts[2], 100U);
  EXPECT_TRUE(has_gaps);
}

// midpoints of squares and of their sides: many cocircular faces
TYPED_TEST(Stored_vertex_moves, Keep_exact_ties) {
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

TYPED_TEST(Stored_vertex_moves, Go_on_after_refinement_as_if_not_stored) {
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

TYPED_TEST(Stored_vertex_moves, Every_inserted_vertex_can_be_removed_from_what_is_read) {
  TypeParam t(meshes::rough_grid(4, 2).input());
  Random_moves<TypeParam>(t, 8).run(60);
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
class Stored_vertex_moves_on : public testing::Test {};
TYPED_TEST_SUITE(Stored_vertex_moves_on, All_meshes);

TYPED_TEST(Stored_vertex_moves_on, Any_mesh_type_come_back) {
  using T = IT::Intrinsic_triangulation<TypeParam, IT::Exact_euclidean_traits>;
  T t(meshes::rough_grid(3, 3).input());
  Random_moves<T> moves(t, 5);
  moves.run(60);
  ASSERT_GT(moves.counts[1], 0U);
  T back = from_text<T>(text(t));
  EXPECT_EQ(text(back), text(t));
  Exact other = from_text<Exact>(text(t));
  EXPECT_EQ(text(other), text(t));
  EXPECT_EQ(delaunay_signs(back), delaunay_signs(other));
  IT::flip_to_delaunay(back);
  IT::flip_to_delaunay(other);
  EXPECT_EQ(text(back), text(other));
}

/// A small file in which there are moves of every kind.
template <class T>
std::string file_with_all_moves() {
  T t(meshes::rough_grid(2, 3).input());
  const auto border = [&t] {
    for (const auto h : halfedges(t.mesh()))
      if (face(h, t.mesh()).index == IT::Gluing::none) return opposite(h, t.mesh());
    return typename T::halfedge_descriptor();
  };
  const auto first =
      t.insert_vertex(halfedge(*faces(t.mesh()).begin(), t.mesh()), {0.25, 0.25, 0.5});
  const auto second = t.split_edge(border(), 0.375);
  EXPECT_EQ(t.insert_vertex(halfedge(*faces(t.mesh()).begin(), t.mesh()), {0.5, 0.25, 0.25}).status,
            Move_status::done);
  EXPECT_EQ(t.remove_vertex(first.vertex), Move_status::done);
  EXPECT_EQ(t.remove_vertex(second.vertex), Move_status::done);
  EXPECT_EQ(t.split_edge(border(), 0.75).status, Move_status::done);
  IT::flip_to_delaunay(t);
  return text(t);
}

TEST(Stored_vertex_moves_in_a_file, are_refused_where_they_are_damaged) {
  const std::string s = file_with_all_moves<Exact>();
  ASSERT_EQ(message_of(s), "");
  // the line of each kind, its words, and what they are replaced by
  const auto damaged = [&s](const std::string& kind, std::size_t word, const std::string& by) {
    const std::size_t begin = s.find("\n" + kind + " ") + 1, end = s.find('\n', begin);
    EXPECT_NE(begin, 0U) << kind;
    std::istringstream line(s.substr(begin, end - begin));
    std::string result, w;
    for (std::size_t i = 0; line >> w; ++i) result += (i == 0 ? "" : " ") + (i == word ? by : w);
    const auto number = std::count(s.begin(), s.begin() + std::ptrdiff_t(begin), '\n') + 1;
    const std::string message = message_of(s.substr(0, begin) + result + s.substr(end));
    EXPECT_EQ(message.rfind("file.idt:" + std::to_string(number) + ": ", 0), 0U) << result << "\n"
                                                                                 << message;
    EXPECT_NE(message.find("write it again"), std::string::npos) << message;
    return message;
  };
  for (const std::string kind : {"flip", "insert", "insert_border", "remove", "remove_border"}) {
    EXPECT_NE(damaged(kind, 0, "glue").find("unknown"), std::string::npos);
    EXPECT_NE(damaged(kind, 1, "4000000").find("does not exist"), std::string::npos);
    EXPECT_NE(damaged(kind, 2, "3").find("slot"), std::string::npos);
    damaged(kind, 1, "-1");
    damaged(kind, 1, "nan");
  }
  EXPECT_NE(damaged("insert", 3, "nan").find("weight"), std::string::npos);
  EXPECT_NE(damaged("insert", 3, "0x1p+0").find("weights"), std::string::npos);
  EXPECT_NE(damaged("insert", 3, "0x1.0000000000001p-2").find("weights"), std::string::npos);
  EXPECT_NE(damaged("insert_border", 4, "-0x1p-1").find("negative"), std::string::npos);
  for (const std::string kind : {"flip", "remove", "remove_border"}) { // a move of other sides
    const std::size_t at = s.find("\n" + kind + " ");
    std::istringstream line(s.substr(at));
    std::string word, version, slot;
    line >> word >> version >> slot;
    const std::string other = slot == "0" ? "1" : "0";
    EXPECT_NE(damaged(kind, 2, other).find("different edges"), std::string::npos) << kind;
  }
}

TEST(Stored_vertex_moves_in_a_file, are_refused_where_counts_or_values_do_not_fit) {
  const std::string s = file_with_all_moves<Exact>();
  const auto expect_refused = [](const std::string& file, const std::string& what) {
    const std::string message = message_of(file);
    EXPECT_EQ(message.rfind("file.idt:", 0), 0U) << message;
    EXPECT_NE(message.find(what), std::string::npos) << message;
  };
  expect_refused(replaced(s, "IDT 2", "IDT 3"), "versions up to 2");
  expect_refused(replaced(s, "scale ", "scale 2000000000"), "exponent");
  // nine vertices are of the input, two were inserted
  expect_refused(replaced(s, "\n- ", "\n9 "), "there must be 10 points");
  expect_refused(replaced(s, "\n0 ", "\n- "), "comes after inserted");
  expect_refused(replaced(s, "input_faces 0\n", "input_faces 1\n0\n"), "so many input_faces");
  expect_refused(replaced(s, "points 9", "points 8"), "there must be 9 points");
  for (const std::string count : {"moves", "versions", "sides", "border", "faces", "edges"}) {
    const std::size_t at = s.find("\n" + count + " ") + count.size() + 2;
    const std::size_t number = std::stoul(s.substr(at));
    for (const std::size_t other : {number - 1, number + 1, std::size_t(4000000000U)})
      expect_refused(s.substr(0, at) + std::to_string(other) + s.substr(s.find('\n', at)), "");
  }
  // halfedges of vertices, from which walks around them start
  const std::size_t vertex = s.find("\n0 ") + 3;
  expect_refused(s.substr(0, vertex) + "-" + s.substr(s.find('\n', vertex)), "needs a halfedge");
  const auto inner = [] { // of the first vertex, which is on the border
    const Exact t(meshes::rough_grid(2, 3).input());
    for (const auto h : halfedges(t.mesh()))
      if (target(h, t.mesh()).index == 0 && face(h, t.mesh()).index != IT::Gluing::none)
        return h.index;
    return IT::Gluing::none;
  }();
  const std::string plain = text(Exact(meshes::rough_grid(2, 3).input()));
  const std::size_t first = plain.find("\n0 ") + 3;
  expect_refused(plain.substr(0, first) + std::to_string(inner) +
                     plain.substr(plain.find('\n', first)),
                 "not on the border");
  // an abstract metric does not say how many vertices the input has, but the moves do
  Exact torus(input_of(gallery::one_vertex_torus()));
  torus.insert_vertex(halfedge(*faces(torus.mesh()).begin(), torus.mesh()), {0.25, 0.25, 0.5});
  ASSERT_EQ(message_of(text(torus)), "");
  expect_refused(replaced(text(torus), "\n- ", "\n1 "), "there are 0");
  // a coordinate of the input that changes the values
  const std::size_t points = s.find("points 9\n") + 9;
  const std::size_t end = s.find(' ', points);
  expect_refused(s.substr(0, points) + "0x1.8p+3" + s.substr(end), "");
}

template <class T>
void expect_every_truncation_is_noticed() {
  const std::string s = file_with_all_moves<T>();
  for (std::size_t length = 0; length + 1 < s.size(); ++length)
    ASSERT_NE(message_of<T>(s.substr(0, length)), "") << length;
}

TEST(Stored_vertex_moves_in_a_file, are_refused_if_truncated) {
  expect_every_truncation_is_noticed<Exact>();
  expect_every_truncation_is_noticed<Double>();
}

template <class T>
unsigned refused_mutations(unsigned count) {
  const std::string s = file_with_all_moves<T>();
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

TEST(Stored_vertex_moves_in_a_file, are_refused_or_usable_if_digits_change) {
  EXPECT_GT(refused_mutations<Exact>(1500), 500U);
  EXPECT_GT(refused_mutations<Double>(1500), 200U);
}

TEST(Stored_vertex_moves_in_a_file, ask_for_a_triangulation_without_correspondence) {
  using Traced = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                             IT::Integer_coordinates>;
  Traced t(meshes::rough_grid(2, 3).input());
  IT::flip_to_delaunay(t);
  EXPECT_EQ(text(from_text<Traced>(text(t))), text(t));
  ASSERT_EQ(t.insert_vertex(halfedge(*faces(t.mesh()).begin(), t.mesh()), {0.25, 0.25, 0.5}).status,
            Move_status::done);
  EXPECT_NE(message_of<Traced>(text(t)).find("No_correspondence"), std::string::npos);
  EXPECT_EQ(text(from_text<Exact>(text(t))), text(t));
}

} // namespace
