// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "meshes.h"
#include "places.h"
#include "properties.h"
#include "radical_number.h"

#include <CGAL/Integer_only_triangulation.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/formulas/Face_values.h>
#include <CGAL/Intrinsic_triangulations/formulas/Recorded_expression.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_euclidean_traits.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <random>
#include <span>
#include <utility>
#include <vector>

// Signs of expressions of any kind in the values of a diamond, or of several faces, against numbers that are made
// from the definition: triangles of integer coordinates, laid out in a plane with every flip and insertion.

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using IT::Move_status;
using Number = radical_number::Number;
using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                                  IT::Integer_coordinates>;
using Halfedge = Triangulation::halfedge_descriptor;
using Scope = IT::Exact_euclidean_metric::Scope;

// ---- expressions

/// cos of the difference of the angles at the source: zero iff the corner is a right angle, or both are alike.
struct Right_corner {
  template <class FT>
  constexpr FT operator()(const IT::Diamond_values<FT>& d) const {
    return (d.ij + d.ki - d.jk) * (d.ij + d.im - d.mj) - d.area_f * d.area_g;
  }
};
/// The same value with some parts negated.
struct Negated_corner {
  template <class FT>
  constexpr FT operator()(const IT::Diamond_values<FT>& d) const {
    return -(-(-d.area_f * d.area_g) - (d.ij + d.ki - d.jk) * (d.ij + d.im - d.mj));
  }
};
/// The same value, not as a polynomial: divided by one.
struct Right_corner_over_one : Right_corner {
  template <class FT>
  constexpr FT operator()(const IT::Diamond_values<FT>& d) const {
    return Right_corner::operator()(d) / FT(1);
  }
};

static_assert(IT::DiamondExpression<Right_corner> && !IT::FaceExpression<Right_corner>);

TEST(Expressions, have_a_degree_unless_there_are_constants_or_quotients) {
  const auto delaunay = IT::recorded(IT::Delaunay_expression()).degree();
  ASSERT_TRUE(delaunay);
  EXPECT_EQ(delaunay->total, 2U);
  EXPECT_EQ(delaunay->areas, 1U);
  EXPECT_EQ(delaunay->terms, 6);
  EXPECT_TRUE(delaunay->is_linear_in_areas());
  const auto corner = IT::recorded(Right_corner()).degree();
  ASSERT_TRUE(corner);
  EXPECT_EQ(corner->areas, 2U);
  EXPECT_TRUE(corner->is_uniform);
  EXPECT_FALSE(corner->is_linear_in_areas());
  EXPECT_FALSE(IT::recorded(Right_corner_over_one()).degree());
  EXPECT_FALSE(IT::recorded([](const auto& d) { return d.ij - d.ij * 2; }).degree());
}

/// A straight-line program: each step combines two values so far, or makes a constant.
struct Program {
  struct Step {
    char operation; // + - * c
    std::size_t a, b;
    double constant;
  };
  std::vector<Step> steps;

  template <class FT>
  FT run(std::vector<FT> x) const {
    x.reserve(x.size() + steps.size());
    for (const Step& s : steps) {
      switch (s.operation) {
      case '+':
        x.push_back(x[s.a] + x[s.b]);
        break;
      case '-':
        x.push_back(x[s.a] - x[s.b]);
        break;
      case '*':
        x.push_back(x[s.a] * x[s.b]);
        break;
      default:
        x.push_back(FT(s.constant));
      }
    }
    return x.back();
  }
};

struct Of_diamond : Program {
  template <class FT>
  FT operator()(const IT::Diamond_values<FT>& d) const {
    return run<FT>(std::vector<FT>{d.ij, d.jk, d.ki, d.im, d.mj, d.area_f, d.area_g});
  }
};
/// The same value, not as a polynomial.
struct Of_diamond_over_one : Of_diamond {
  template <class FT>
  FT operator()(const IT::Diamond_values<FT>& d) const {
    return Of_diamond::operator()(d) / FT(1);
  }
};

struct Of_faces : Program {
  template <class FT>
  FT operator()(std::span<const IT::Face_values<FT>> faces) const {
    std::vector<FT> x;
    for (const auto& [l, a] : faces) x.insert(x.end(), {l[0], l[1], l[2], a});
    return run<FT>(x);
  }
};

/// The imaginary part of the product of p + i a over the corners of a fan: zero iff their angles sum to a
/// multiple of pi. With the real part: to an odd multiple of pi / 2.
struct Wedge {
  bool real;
  template <class FT>
  FT operator()(std::span<const IT::Face_values<FT>> faces) const {
    std::array<FT, 2> z{FT(1), FT(0)};
    for (const auto& [l, a] : faces) {
      const FT p = l[0] + l[2] - l[1];
      z = {z[0] * p - z[1] * a, z[0] * a + z[1] * p};
    }
    return real ? z[0] : z[1];
  }
};

/// Makes programs.
class Programs {
public:
  Programs(std::size_t values, unsigned seed) : values_(values), random_(seed) {}

  /// A polynomial of a degree, of one total degree if `is_homogeneous`.
  Program polynomial(unsigned degree, bool is_homogeneous) {
    program_.steps.clear();
    if (is_homogeneous)
      make(degree);
    else
      combine('-', make(degree), make(1 + below(degree)));
    return program_;
  }

  /// A program less a constant.
  static Program minus_constant(Program p, std::size_t values, double c) {
    const std::size_t last = values + p.steps.size() - 1;
    p.steps.push_back({'c', 0, 0, c});
    p.steps.push_back({'-', last, last + 1, 0});
    return p;
  }

private:
  unsigned below(unsigned n) { return static_cast<unsigned>(random_() % n); }

  std::size_t combine(char operation, std::size_t a, std::size_t b) {
    program_.steps.push_back({operation, a, b, 0});
    return values_ + program_.steps.size() - 1;
  }

  // Values coincide on regular meshes, so that differences are often zero, and sums are often of that kind.
  std::size_t make(unsigned degree) {
    if (degree == 1) {
      std::size_t x = random_() % values_;
      for (unsigned terms = 1 + below(3); terms > 0; --terms)
        x = combine(below(2) == 0 ? '+' : '-', x, random_() % values_);
      return x;
    }
    const auto product = [this](unsigned d) {
      const unsigned first = 1 + below(d - 1);
      return combine('*', make(first), make(d - first));
    };
    const std::size_t x = product(degree);
    return below(2) == 0 ? x : combine(below(2) == 0 ? '+' : '-', x, product(degree));
  }

  std::size_t values_;
  std::mt19937 random_;
  Program program_;
};

// ---- triangulations with their exact values

class Known_triangulation {
public:
  explicit Known_triangulation(const meshes::Mesh& m) : t(m.input()) {
    for (const Halfedge h : halfedges(t.mesh())) {
      if (is_border(h)) continue;
      std::array<std::array<CGAL::Gmpz, 3>, 3> p;
      Halfedge x = h;
      for (auto& point : p) {
        for (std::size_t c = 0; c < 3; ++c) point[c] = integer(m.points[input_vertex(x)][c]);
        x = next(x, t.mesh());
      }
      const auto u = difference(p[1], p[0]), v = difference(p[2], p[0]);
      lengths_[edge_number(h)] = unit() * Number(CGAL::Gmpq(norm(u)));
      areas_[face_number(h)] = unit() * Number(2) * Number::sqrt(norm(cross(u, v)));
    }
    for (std::uint32_t f = 0; f < t.input().number_of_faces(); ++f) {
      const std::uint32_t h = t.input().halfedge_of_face(f), n = t.input().next(h);
      input_[f] = {{length(h / 2), length(n / 2), length(t.input().next(n) / 2)}, area(f)};
    }
  }

  Triangulation t;

  std::vector<Halfedge> diamonds() const { return properties::flippable_by_connectivity(t); }

  IT::Diamond_values<Number> values(Halfedge h) const {
    const IT::Diamond d = t.diamond(h);
    return {length(d.ij), length(d.jk), length(d.ki), length(d.im),
            length(d.mj), area(d.f),    area(d.g)};
  }

  IT::Indexed_face face_of(Halfedge h) const {
    const Halfedge n = next(h, t.mesh());
    return {face_number(h), {edge_number(h), edge_number(n), edge_number(next(n, t.mesh()))}};
  }

  IT::Face_values<Number> values(const IT::Indexed_face& f) const {
    return {{length(f.edges[0]), length(f.edges[1]), length(f.edges[2])}, area(f.face)};
  }

  /// The corners about the source of a halfedge, counterclockwise, up to a border.
  std::vector<IT::Indexed_face> fan(Halfedge h, std::size_t most) const {
    std::vector<IT::Indexed_face> result;
    for (Halfedge x = h; !is_border(x) && result.size() < most;) {
      result.push_back(face_of(x));
      x = opposite(next(next(x, t.mesh()), t.mesh()), t.mesh());
      if (x == h) break;
    }
    return result;
  }

  void flip(Halfedge h) {
    const IT::Diamond d = t.diamond(h);
    const IT::Diamond_values<Number> v = values(h);
    if (t.flip_edge(h) != Move_status::done) return;
    const Vector i{0, 0}, j{1, 0}, k = apex(v.ij, v.jk, v.ki, v.area_f),
                                   below = apex(v.ij, v.im, v.mj, v.area_g),
                                   m{Number(1) - below.x, Number(0) - below.y};
    lengths_[d.ij] = v.ij * dot(m - k, m - k);
    areas_[d.f] = Number(2) * v.ij * cross(m - k, j - k);
    areas_[d.g] = Number(2) * v.ij * cross(k - m, i - m);
  }

  void insert(Halfedge h, const std::array<double, 3>& w) {
    const IT::Face_values<Number> v = values(face_of(h));
    const std::array<Halfedge, 3> sides{h, next(h, t.mesh()), next(next(h, t.mesh()), t.mesh())};
    if (t.insert_vertex(h, w).status != Move_status::done) return;
    // the place of the vertex on the input; the moves determine the rest
    places::Unfolded<Triangulation> unfolded(t);
    const auto& [l, a] = v;
    Number rest = a;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto f =
          unfolded.face(t.numbers().halfedge(sides[k])).values<Number>([this](std::uint32_t g) {
            return input_.at(g);
          });
      EXPECT_EQ((f.ij - l[k]).sign(), 0);
      const Number p = f.ij + f.ki - f.jk;
      EXPECT_EQ((Number(4) * f.ij * f.ki - p * p - f.area_f * f.area_f).sign(), 0);
      const Number share = f.area_f - Number(w[(k + 2) % 3]) * a; // near the requested weight
      EXPECT_EQ((Number(0x1p-34) * a - share).sign(), 1);
      EXPECT_EQ((Number(0x1p-34) * a + share).sign(), 1);
      rest = rest - f.area_f;
      lengths_[edge_number(next(sides[k], t.mesh()))] = f.jk;
      areas_[face_number(sides[k])] = f.area_f;
    }
    EXPECT_EQ(rest.sign(), 0);
  }

  void move_at_random(std::mt19937& random, bool may_insert) {
    const auto all = diamonds();
    const Halfedge h = all[random() % all.size()];
    if (may_insert && random() % 4 == 0)
      insert(h, random() % 2 == 0 ? std::array{0.5, 0.25, 0.25} : std::array{0.125, 0.375, 0.5});
    else
      flip(h);
  }

private:
  struct Vector {
    Number x, y;
    friend Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y}; }
  };
  static Number dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y; }
  static Number cross(const Vector& a, const Vector& b) { return a.x * b.y - a.y * b.x; }
  // the corner opposite a side from (0, 0) to (1, 0): by the law of cosines, and height = 2 area / base
  static Vector apex(const Number& side, const Number& next, const Number& last,
                     const Number& quadruple_area) {
    const Number twice = Number(2) * side;
    return {(side + last - next) / twice, quadruple_area / twice};
  }

  using Integers = std::array<CGAL::Gmpz, 3>;
  static constexpr int fraction = 40; // bits of coordinates after the point
  static CGAL::Gmpz integer(double x) { return CGAL::Gmpz(std::ldexp(x, fraction)); }
  static Integers difference(const Integers& a, const Integers& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  }
  static CGAL::Gmpz norm(const Integers& a) { return a[0] * a[0] + a[1] * a[1] + a[2] * a[2]; }
  static Integers cross(const Integers& a, const Integers& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }
  // of squared lengths, from integers to the units of the metric
  Number unit() const { return std::ldexp(1.0, 2 * (t.metric().scale_exponent() - fraction)); }

  bool is_border(Halfedge h) const {
    return face(h, t.mesh()) == boost::graph_traits<IT::Gluing_map>::null_face();
  }
  std::size_t input_vertex(Halfedge h) const { return t.input_vertex(source(h, t.mesh())); }
  std::uint32_t edge_number(Halfedge h) const { return t.index(edge(h, t.mesh())); }
  std::uint32_t face_number(Halfedge h) const { return t.index(face(h, t.mesh())); }
  const Number& length(std::uint32_t e) const { return lengths_.at(e); }
  const Number& area(std::uint32_t f) const { return areas_.at(f); }

  std::map<std::uint32_t, Number> lengths_, areas_;
  std::map<std::uint32_t, std::pair<std::array<Number, 3>, Number>> input_; // faces
};

// ---- comparison

struct Counts {
  int zeros = 0, others = 0;
};

using From_integers = IT::Integer_only_triangulation<>;

// By the metric, and from integer coordinates and the input alone.
template <class Expression>
int expect_sign(Known_triangulation& k, const From_integers& integers, Halfedge h,
                const Expression& e, int expected) {
  const Scope scope;
  EXPECT_EQ(k.t.sign(k.t.diamond(h), e), expected);
  EXPECT_EQ(integers.sign(k.t.diamond(h), e), expected);
  EXPECT_EQ(k.t.metric().statistics().probable_zero, 0U);
  EXPECT_EQ(integers.metric().statistics().probable_zero, 0U);
  return expected;
}

void check_diamonds(Known_triangulation& k, Programs& programs, std::mt19937& random, Counts& n) {
  const From_integers integers(k.t);
  for (const Halfedge h : k.diamonds()) {
    const IT::Diamond_values<Number> values = k.values(h);
    const unsigned degree = 1 + static_cast<unsigned>(random() % 6);
    const Of_diamond e{programs.polynomial(degree, random() % 2 == 0)};
    EXPECT_TRUE(IT::recorded(e).degree());
    const Number value = e(values);
    const int s = expect_sign(k, integers, h, e, value.sign());
    expect_sign(k, integers, h, Of_diamond_over_one{e}, s);
    ++(s == 0 ? n.zeros : n.others);
    const double c = CGAL::to_double(value.rational());
    const Of_diamond constant{Programs::minus_constant(e, 7, c)};
    ++(expect_sign(k, integers, h, constant, constant(values).sign()) == 0 ? n.zeros : n.others);
    expect_sign(k, integers, h, Right_corner(), Right_corner()(values).sign());
    expect_sign(k, integers, h, Negated_corner(), Right_corner()(values).sign());
    expect_sign(k, integers, h, Right_corner_over_one(), Right_corner()(values).sign());
  }
}

template <class Expression>
void check_faces(Known_triangulation& k, const std::vector<IT::Indexed_face>& faces,
                 const Expression& e, Counts& n) {
  std::vector<IT::Face_values<Number>> values;
  for (const IT::Indexed_face& f : faces) values.push_back(k.values(f));
  const int expected = e(std::span<const IT::Face_values<Number>>(values)).sign();
  const Scope scope;
  EXPECT_EQ(k.t.sign(std::span<const IT::Indexed_face>(faces), e), expected);
  ++(expected == 0 ? n.zeros : n.others);
}

void check_fans(Known_triangulation& k, std::mt19937& random, Counts& n) {
  for (const Halfedge h : k.diamonds()) {
    const auto faces = k.fan(h, 1 + random() % 6);
    for (const bool real : {true, false}) check_faces(k, faces, Wedge{real}, n);
    const std::size_t used = std::min<std::size_t>(faces.size(), 3);
    Programs programs(4 * used, static_cast<unsigned>(random()));
    const std::vector<IT::Indexed_face> some(faces.begin(),
                                             faces.begin() + static_cast<std::ptrdiff_t>(used));
    check_faces(
        k, some,
        Of_faces{programs.polynomial(1 + static_cast<unsigned>(random() % 6), random() % 2 == 0)},
        n);
  }
}

std::vector<meshes::Mesh> small_meshes() {
  return {meshes::grid(2, 2),
          meshes::grid(2, 2, 3, 4),
          meshes::random_planar(7, 6, 1),
          meshes::box(1, 1, 1),
          meshes::box(2, 1, 1),
          meshes::folded_lattice(2, 2, 1),
          meshes::prism({{0, 0}, {4, 0}, {1, 3}}, 1),
          meshes::l_shape(1),
          meshes::stairs(2, 1),
          meshes::integer_height_field(2, 2, 1),
          meshes::integer_height_field(2, 5, 2)};
}

template <class Check>
Counts check_after_moves(unsigned rounds, unsigned moves, bool may_insert, const Check& check) {
  Counts n;
  unsigned seed = 20261122;
  for (const meshes::Mesh& m : small_meshes()) {
    std::mt19937 random(++seed);
    Known_triangulation k(m);
    for (unsigned round = 0; round < rounds && !::testing::Test::HasFailure(); ++round) {
      SCOPED_TRACE(::testing::Message() << "seed " << seed << " round " << round);
      check(k, random, n);
      for (unsigned i = 0; i < moves; ++i) k.move_at_random(random, may_insert);
    }
  }
  return n;
}

// ---- tests

TEST(Expressions, tell_a_right_angle_of_two_coplanar_corners_whatever_the_digits) {
  std::mt19937 random(5);
  double a = 0x1.999999p-4, b = 0x1.333331p-2;
  for (int round = 0; round < 50; ++round) {
    Known_triangulation k(meshes::Mesh{{{0, 0, 0}, {a - b, a + b, 0}, {-b, a, 0}, {a, b, 0}},
                                       {{0, 1, 2}, {0, 3, 1}}});
    ASSERT_EQ(k.diamonds().size(), 1U);
    const From_integers integers(k.t);
    for (const Halfedge h : {k.diamonds()[0], opposite(k.diamonds()[0], k.t.mesh())}) {
      EXPECT_EQ(Right_corner()(k.values(h)).sign(), 0);
      expect_sign(k, integers, h, Right_corner(), 0);
      expect_sign(k, integers, h, Right_corner_over_one(), 0);
      expect_sign(
          k, integers, h, [](const auto& d) { return Right_corner()(d); }, 0);
    }
    a = std::ldexp(static_cast<double>(1 + random() % 0x3ffffff), -27);
    b = std::ldexp(static_cast<double>(1 + random() % 0x3ffffff), -27);
  }
}

TEST(Expressions, of_degree_1_to_6_have_the_right_sign_in_diamonds_after_flips_and_insertions) {
  const auto check = [](auto& k, auto& random, Counts& c) {
    Programs programs(7, static_cast<unsigned>(random()));
    check_diamonds(k, programs, random, c);
  };
  for (const bool may_insert : {false, true}) {
    SCOPED_TRACE(may_insert ? "with insertions" : "flips only");
    const Counts n = check_after_moves(may_insert ? 10 : 15, may_insert ? 4 : 3, may_insert, check);
    EXPECT_GT(n.zeros, 100);
    EXPECT_GT(n.others, 100);
  }
}

TEST(Expressions, of_degree_1_to_6_have_the_right_sign_over_several_faces) {
  for (const bool may_insert : {false, true}) {
    const Counts n = check_after_moves(
        3, 4, may_insert, [](auto& k, auto& random, Counts& c) { check_fans(k, random, c); });
    EXPECT_GT(n.zeros, 100);
    EXPECT_GT(n.others, 100);
  }
}

} // namespace
