// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/simplification/flat_vertices.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/graph_traits_Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/input/initial_values.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <CGAL/Gmpz.h>
#include <CGAL/Gmpzf.h>
#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <numbers>
#include <optional>
#include <unordered_map>
#include <utility>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

// ---- Intervals

// A sum of angles, and a bound of its error.
struct Enclosed_angle {
  double sum = 0, error = 0;

  bool may_be(double angle) const { return std::abs(sum - angle) <= error; }
};

// Adds the angles of a face to the sums of its corners.
void add_angles(const Input_metric& metric, std::uint32_t f,
                std::span<const std::uint32_t, 3> corners, std::vector<Enclosed_angle>& angles) {
  struct Middle {
    double value, radius;
  };
  const auto middle_of = [](const Interval_nt<false>& i) {
    return Middle{(i.inf() + i.sup()) / 2, i.sup() - i.inf()};
  };
  std::array<Middle, 3> p{};
  Middle area{};
  {
    const Protect_FPU_rounding<true> up;
    std::array<Interval_nt<false>, 3> l;
    for (unsigned k = 0; k < 3; ++k) l[k] = metric.squared_length<Interval_nt<false>>(f, k);
    for (unsigned k = 0; k < 3; ++k) p[k] = middle_of(l[k] + l[(k + 2) % 3] - l[(k + 1) % 3]);
    area = middle_of(quadruple_area<Interval_nt<false>>(metric, f));
  }
  for (std::size_t k = 0; k < 3; ++k) {
    Enclosed_angle& angle = angles[corners[k]];
    const double radius = p[k].radius + area.radius, size = std::hypot(p[k].value, area.value);
    angle.sum += std::atan2(area.value, p[k].value);
    // an error of z by r turns it by asin(r / |z|) at most; rounding of the angle and of a sum near
    // 2 pi are below 2^-50 each
    angle.error += radius < size / 2 ? 2 * radius / size + 0x1p-49 : std::numbers::pi;
  }
}

// ---- Integers

// The angle of p + i sqrt(d).
struct Exact_corner {
  Gmpz p, d;
};

Gmpz shifted(const Gmpzf& x, long exponent) { // the number divided by 2^exponent
  Gmpz result;
  if (mpz_sgn(x.man()) != 0)
    mpz_mul_2exp(result.mpz(), x.man(), static_cast<mp_bitcnt_t>(x.exp() - exponent));
  return result;
}

// Squared lengths and the squared quadruple area of faces: a face has three corners.
class Exact_faces {
public:
  struct Face {
    std::array<Gmpzf, 3> length;
    Gmpzf d;
  };

  explicit Exact_faces(const Input_metric& metric) : metric_(metric) {}

  const Face& operator()(std::uint32_t f) {
    const auto [known, is_new] = faces_.try_emplace(f);
    Face& face = known->second;
    if (!is_new) return face;
    for (unsigned k = 0; k < 3; ++k) face.length[k] = metric_.squared_length<Gmpzf>(f, k);
    face.d = squared_quadruple_area(face.length[0], face.length[1], face.length[2]);
    return face;
  }

private:
  const Input_metric& metric_;
  std::unordered_map<std::uint32_t, Face> faces_;
};

Exact_corner exact_corner(Exact_faces& faces, std::uint32_t h) {
  const auto& [length, d] = faces(h / 3);
  const Gmpzf p = length[h % 3] + length[(h + 2) % 3] - length[(h + 1) % 3];
  // a power of two that divides p, and the square of which divides d
  const long of_d = d.exp() >= 0 ? d.exp() / 2 : (d.exp() - 1) / 2;
  const long exponent = p.is_zero() ? of_d : d.is_zero() ? p.exp() : std::min(p.exp(), of_d);
  return {shifted(p, exponent), shifted(d, 2 * exponent)};
}

// To a few units, whatever the sizes of p and d.
double angle_of(const Exact_corner& z) {
  long p_exponent = 0, d_exponent = 0;
  const double p = mpz_get_d_2exp(&p_exponent, z.p.mpz());
  double d = mpz_get_d_2exp(&d_exponent, z.d.mpz());
  if (d_exponent % 2 != 0) {
    d *= 2;
    --d_exponent;
  }
  constexpr long far = 4000; // beyond doubles
  const long difference = std::clamp(d_exponent / 2 - p_exponent, -far, far);
  const double y = std::sqrt(d);
  return difference > 0 ? std::atan2(y, std::ldexp(p, static_cast<int>(-difference)))
                        : std::atan2(std::ldexp(y, static_cast<int>(difference)), p);
}

std::optional<Gmpz> exact_root(const Gmpz& n) {
  if (mpz_perfect_square_p(n.mpz()) == 0) return std::nullopt;
  Gmpz root;
  mpz_sqrt(root.mpz(), n.mpz());
  return root;
}

// The corners of one class: numbers x + y sqrt(-d).
class Corners_of_class {
public:
  explicit Corners_of_class(Gmpz d) : d_(std::move(d)) {}

  // \return whether the corner is in the class
  bool add(const Exact_corner& z) {
    const bool is_rational = d_ == Gmpz(1);
    const std::optional<Gmpz> root = exact_root(is_rational ? z.d : z.d * d_);
    if (!root) return false;
    numbers_.push_back({is_rational ? z.p : z.p * d_, *root});
    return true;
  }
  // Whether the angles sum to a multiple of pi / 2, or of pi / 4 if d = 1.
  bool is_root_of_unity() {
    if (numbers_.empty()) return true;
    for (; numbers_.size() > 1; multiply_pairs()) {
    }
    const auto& [x, y] = numbers_.front();
    return x.sign() == ZERO || y.sign() == ZERO ||
           (d_ == Gmpz(1) && mpz_cmpabs(x.mpz(), y.mpz()) == 0);
  }

private:
  struct Number {
    Gmpz x, y;
  };

  // Numbers of one size are multiplied, which is fast where they are long.
  void multiply_pairs() {
    std::size_t n = 0;
    for (std::size_t i = 0; i < numbers_.size(); i += 2, ++n) {
      if (i + 1 == numbers_.size()) {
        numbers_[n] = numbers_[i];
        continue;
      }
      const Number a = numbers_[i], b = numbers_[i + 1];
      numbers_[n] = {a.x * b.x - d_ * (a.y * b.y), a.x * b.y + a.y * b.x};
    }
    numbers_.resize(n);
  }

  Gmpz d_;
  std::vector<Number> numbers_;
};

// See the header. \param sides those that begin at the vertex
bool is_flat(Exact_faces& faces, std::span<const std::uint32_t> sides, unsigned half_turns) {
  const std::size_t most_others = 2 * half_turns;
  std::vector<Corners_of_class> classes(1, Corners_of_class(Gmpz(1)));
  double sum = 0;
  for (const std::uint32_t h : sides) {
    const Exact_corner z = exact_corner(faces, h);
    if (z.d.sign() == NEGATIVE) return false; // no triangle
    sum += angle_of(z);
    if (z.d.sign() == ZERO) continue;
    if (std::ranges::any_of(classes, [&](Corners_of_class& c) { return c.add(z); })) continue;
    if (classes.size() > most_others) return false;
    classes.emplace_back(z.d).add(z);
  }
  return std::abs(sum - half_turns * std::numbers::pi) < std::numbers::pi / 8 &&
         std::ranges::all_of(classes, [](Corners_of_class& c) { return c.is_root_of_unity(); });
}

// Answers for vertices, by the lengths of their faces if these are doubles: on grids, most vertices
// have the same lengths.
class Known_vertices {
public:
  explicit Known_vertices(const Input_metric& metric) : metric_(metric) {}

  // The answer of a function for this vertex, or for one with the same corners.
  template <class Decide>
  bool operator()(std::span<const std::uint32_t> sides, unsigned half_turns, const Decide& decide) {
    if (!find_key(sides, half_turns)) return decide();
    if (const auto known = known_.find(key_); known != known_.end()) return known->second;
    const bool result = decide();
    if (known_.size() < most_known) known_.emplace(key_, result);
    return result;
  }

private:
  // Of a corner: the squared lengths of both sides, and of the opposite one.
  using Corner = std::array<double, 3>;
  // Where all vertices differ, no key is found again: only few are kept.
  static constexpr std::size_t most_known = 256;

  // \return whether all lengths are doubles
  bool find_key(std::span<const std::uint32_t> sides, unsigned half_turns) {
    const Protect_FPU_rounding<true> up;
    key_.clear();
    for (const std::uint32_t h : sides) {
      Corner c{};
      for (const std::uint32_t k : {0U, 1U, 2U}) {
        const Interval_nt<false> l = metric_.squared_length<Interval_nt<false>>(h / 3, (h + k) % 3);
        if (l.inf() != l.sup()) return false;
        c[k] = l.inf();
      }
      key_.push_back({std::min(c[0], c[2]), std::max(c[0], c[2]), c[1]});
    }
    std::ranges::sort(key_);
    key_.push_back({static_cast<double>(half_turns), 0, 0});
    return true;
  }

  const Input_metric& metric_;
  std::vector<Corner> key_;
  std::map<std::vector<Corner>, bool> known_;
};

} // namespace

std::vector<char> flat_vertices(const Input_metric& metric, std::span<const std::uint32_t> corners,
                                std::span<const std::uint8_t> half_turns) {
  std::vector<Enclosed_angle> angles(half_turns.size());
  for (std::uint32_t f = 0; f < metric.number_of_faces(); ++f)
    add_angles(metric, f, corners.subspan(3 * std::size_t{f}).first<3>(), angles);
  // the sides that begin at vertices that intervals leave open, by vertex
  std::vector<std::pair<std::uint32_t, std::uint32_t>> open;
  for (std::uint32_t h = 0; h < corners.size(); ++h) {
    const std::uint32_t v = corners[h];
    if (half_turns[v] != 0 && angles[v].may_be(half_turns[v] * std::numbers::pi))
      open.emplace_back(v, h);
  }
  std::ranges::sort(open);
  std::vector<char> result(half_turns.size(), 0);
  std::vector<std::uint32_t> sides;
  Exact_faces faces(metric);
  Known_vertices known(metric);
  for (auto at = open.begin(); at != open.end();) {
    const std::uint32_t v = at->first;
    for (sides.clear(); at != open.end() && at->first == v; ++at) sides.push_back(at->second);
    const auto decide = [&] { return is_flat(faces, sides, half_turns[v]); };
    result[v] = known(sides, half_turns[v], decide) ? 1 : 0;
  }
  return result;
}

std::vector<char> flat_vertices(const Input& surface) {
  const Gluing_map& mesh = surface.mesh();
  std::vector<std::uint32_t> corners;
  corners.reserve(3 * std::size_t{mesh.number_of_faces()});
  for (std::uint32_t f = 0; f < mesh.number_of_faces(); ++f)
    for (const Gluing_map::Halfedge h : mesh.sides({f})) corners.push_back(mesh.source(h).index);
  const std::vector<std::uint32_t> fans = umbrellas(mesh);
  std::vector<std::uint8_t> half_turns(mesh.number_of_vertices(), 0);
  for (std::uint32_t v = 0; v < half_turns.size(); ++v)
    if (fans[v] == 1)
      half_turns[v] = mesh.face(mesh.halfedge(Gluing_map::Vertex{v})).index == Gluing::none ? 1 : 2;
  return flat_vertices(surface.metric(), corners, half_turns);
}

} // namespace CGAL::Intrinsic_triangulations::internal
