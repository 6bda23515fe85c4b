// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/domains/Delaunay_star.h>
#include <CGAL/Intrinsic_triangulations/domains/Domain.h>
#include <CGAL/Intrinsic_triangulations/domains/Point_cloud.h>
#include <CGAL/Intrinsic_triangulations/domains/Points_at_places.h>
#include <CGAL/Intrinsic_triangulations/domains/Stars.h>
#include <CGAL/Intrinsic_triangulations/domains/check_coordinates.h>
#include <CGAL/Intrinsic_triangulations/domains/domain_of_stars.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>
#include <CGAL/Intrinsic_triangulations/input/polygons/Point_kernel.h>
#include <CGAL/Intrinsic_triangulations/input/renumbering.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <boost/iterator/counting_iterator.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

using Symmetric_matrix_3 = std::array<std::array<double, 3>, 3>;

// Turns axes p and q so that the entry (p, q) becomes zero.
static void rotate(Symmetric_matrix_3& m, Symmetric_matrix_3& axes, unsigned p, unsigned q) {
  const double half = (m[q][q] - m[p][p]) / 2, entry = m[p][q];
  if (entry == 0 || std::abs(entry) <= 1e-20 * (m[p][p] + m[q][q])) return; // far below rounding
  const double tangent = entry / (half + std::copysign(std::hypot(half, entry), half));
  const double c = 1 / std::sqrt(1 + tangent * tangent), s = c * tangent;
  const auto turn = [c, s](double& x, double& y) {
    const double old = x;
    x = c * old - s * y;
    y = s * old + c * y;
  };
  for (unsigned k = 0; k < 3; ++k) turn(m[k][p], m[k][q]);
  for (unsigned k = 0; k < 3; ++k) turn(m[p][k], m[q][k]);
  for (unsigned k = 0; k < 3; ++k) turn(axes[p][k], axes[q][k]);
}

// Two orthonormal vectors in a plane.
struct Tangent_axes {
  std::array<std::array<double, 3>, 2> axes;
  bool is_tie; // whether, up to rounding, another plane fits as well
};

// In the plane that fits points of this covariance best: eigenvectors of the largest eigenvalues,
// by Jacobi's method, which squares the error with every round.
static Tangent_axes tangent_axes(Symmetric_matrix_3 covariance) {
  constexpr double tie = 0x1p-20; // above rounding, if coordinates are 2^20 distances, too
  Symmetric_matrix_3 axes{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (int round = 0; round < 8; ++round)
    for (const auto& [p, q] : {std::pair(0U, 1U), {0U, 2U}, {1U, 2U}})
      rotate(covariance, axes, p, q);
  unsigned normal = 0;
  for (unsigned k = 1; k < 3; ++k)
    if (covariance[k][k] < covariance[normal][normal]) normal = k;
  const unsigned first = (normal + 1) % 3, second = (normal + 2) % 3;
  const double a = covariance[first][first], b = covariance[second][second];
  return {{axes[first], axes[second]},
          std::min(a, b) - covariance[normal][normal] <= tie * std::max(a, b)};
}

// Finds the triangles at points of a cloud, one point at a time.
class Local_triangulator {
public:
  using Kernel = CGAL::Simple_cartesian<double>;
  using Point = Kernel::Point_3;

  // \param points no two of which are at one place, near ones near each other in memory
  // \param names the user's numbers of the points, which decide ties
  Local_triangulator(const std::vector<Point>& points, const std::vector<std::uint32_t>& names,
                     std::size_t neighbours)
      : points_(points), names_(names), wanted_(static_cast<unsigned>(neighbours) + 1),
        traits_(Point_map(points.data())),
        tree_(boost::counting_iterator<std::uint32_t>(0),
              boost::counting_iterator<std::uint32_t>(static_cast<std::uint32_t>(points.size())),
              Tree::Splitter(), traits_) {
    tree_.build();
  }

  // Appends the corners around a point, by names, in either direction.
  Delaunay_star::Extent add(std::uint32_t center, Stars& stars) {
    find_neighbours(center);
    const Delaunay_star::Extent extent = Delaunay_star::find(star_);
    for (const Delaunay_star::Neighbour& a : star_) {
      stars.corners.push_back(a.number);
      stars.is_tied.push_back(a.is_tied() ? 1 : 0);
    }
    return extent;
  }

  // A number that the last point has wherever the axes are and whatever the names, and hardly any
  // other: the logarithm of the sum of the squared distances of its neighbours, up to rounding.
  std::int64_t signature() const {
    double sum = 0;
    for (const auto& [i, squared_distance] : nearest_) sum += squared_distance;
    return sum > 0 ? std::llround(std::ldexp(std::log2(sum), 30)) : 0;
  }

private:
  using Vector = std::array<double, 3>;
  // a reference to what is stored: of a map to copies, CGAL's search allocates one a query
  using Point_map = CGAL::Pointer_property_map<Point>::const_type;
  using Traits =
      CGAL::Search_traits_adapter<std::uint32_t, Point_map, CGAL::Search_traits_3<Kernel>>;
  using Search = CGAL::Orthogonal_k_neighbor_search<Traits>;
  using Tree = Search::Tree;

  // The nearest points, and all that are as far as the last of them up to rounding: which of these
  // come first depends on the axes.
  void search(std::uint32_t center) {
    for (auto most = wanted_ + 1;; most *= 2) {
      const Search found(tree_, points_[center], most, 0, true,
                         typename Search::Distance(traits_.point_property_map()));
      nearest_.assign(found.begin(), found.end()); // by distances
      if (nearest_.size() <= wanted_) return;
      const double farthest = (1 + same) * nearest_[wanted_ - 1].second;
      if (nearest_.size() == most && nearest_.back().second <= farthest) continue;
      std::erase_if(nearest_, [farthest](const auto& p) { return p.second > farthest; });
      return;
    }
  }

  // turned about the center, which is the origin, into the plane that fits them best
  void find_neighbours(std::uint32_t center) {
    search(center);
    star_.clear();
    vectors_.clear();
    for (const auto& [i, squared_distance] : nearest_) {
      if (i == center) continue;
      Vector& v = vectors_.emplace_back();
      for (int k = 0; k < 3; ++k) v[unsigned(k)] = points_[i][k] - points_[center][k];
      star_.push_back({{}, names_[i], v});
    }
    const auto even = [](std::size_t) { return 1.; };
    // weights that depend on names alone choose one of several planes
    const auto uneven = [this](std::size_t i) {
      return 1 + 0x1p-33 * static_cast<double>(star_[i].number * 2654435761U);
    };
    Tangent_axes found = tangent_axes(covariance(even, 0));
    // of planes that fit as well, one perpendicular to the way to the mean, if they differ in that
    if (found.is_tie) found = tangent_axes(covariance(even, 0x1p-10));
    if (found.is_tie) found = tangent_axes(covariance(uneven, 0));
    for (std::size_t i = 0; i < star_.size(); ++i) star_[i].at = turned(vectors_[i], found.axes);
  }

  // A projection would put points of another side of the surface in front of nearer ones: distances
  // from the center are kept.
  static std::array<double, 2> turned(const Vector& v, const std::array<Vector, 2>& axes) {
    std::array<double, 2> at{};
    for (unsigned k = 0; k < 2; ++k)
      at[k] = axes[k][0] * v[0] + axes[k][1] * v[1] + axes[k][2] * v[2];
    double height = 0;
    for (unsigned k = 0; k < 3; ++k) {
      const unsigned i = (k + 1) % 3, j = (k + 2) % 3;
      height += (axes[0][i] * axes[1][j] - axes[0][j] * axes[1][i]) * v[k];
    }
    const double width = std::hypot(at[0], at[1]);
    if (!(width > 0x1p-20 * std::abs(height))) return {0, 0}; // has no direction but by rounding
    const double slope = height / width;
    const double factor = std::sqrt(1 + slope * slope); // 1 in planes, bit by bit
    return {factor * at[0], factor * at[1]};
  }

  // Of the neighbours and the center, in units in which it neither overflows nor underflows.
  // \param less how much less the way from the center to the mean counts
  template <class Weight>
  Symmetric_matrix_3 covariance(const Weight& weight, double less) const {
    double largest = 0, sum = 1; // the center has the weight 1
    for (const Vector& v : vectors_)
      largest = std::max({largest, std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
    Symmetric_matrix_3 m{};
    if (largest == 0) return m;
    Vector mean{};
    for (std::size_t i = 0; i < vectors_.size(); ++i) {
      sum += weight(i);
      for (unsigned k = 0; k < 3; ++k) mean[k] += weight(i) * (vectors_[i][k] / largest);
    }
    for (double& x : mean) x /= sum;
    const auto add = [&](const Vector& v, double w) {
      Vector d{};
      for (unsigned i = 0; i < 3; ++i) d[i] = v[i] / largest - mean[i];
      for (unsigned i = 0; i < 3; ++i)
        for (unsigned j = i; j < 3; ++j) m[i][j] += w * d[i] * d[j];
    };
    add({0, 0, 0}, 1);
    for (std::size_t i = 0; i < vectors_.size(); ++i) add(vectors_[i], weight(i));
    for (unsigned i = 0; i < 3; ++i)
      for (unsigned j = i; j < 3; ++j) m[i][j] -= less * sum * mean[i] * mean[j];
    for (unsigned i = 1; i < 3; ++i)
      for (unsigned j = 0; j < i; ++j) m[i][j] = m[j][i];
    return m;
  }

  static constexpr double same = 0x1p-30; // as ties of `Delaunay_star`, of squared distances

  const std::vector<Point>& points_;
  const std::vector<std::uint32_t>& names_;
  unsigned wanted_;
  Traits traits_;
  Tree tree_;
  std::vector<Search::Point_with_transformed_distance> nearest_;
  std::vector<Delaunay_star::Neighbour> star_;
  std::vector<Vector> vectors_;
};

std::vector<std::uint32_t>
first_points_at_places(const std::vector<std::array<double, 3>>& points) {
  check_coordinates(points); // NaN is at no place: a table full of it is slow
  Points_at_places found;
  std::vector<std::uint32_t> first;
  first.reserve(points.size());
  const auto point_of = [&points](std::uint32_t i) -> const auto& { return points[i]; };
  for (std::uint32_t i = 0; i < points.size(); ++i)
    first.push_back(found.find_or_add(points[i], i, point_of));
  return first;
}

// The first of the points at each place, near ones near each other.
static std::vector<std::uint32_t> distinct_points(const std::vector<std::array<double, 3>>& points,
                                                  const std::vector<std::uint32_t>& first) {
  if (points.empty()) return {};
  std::vector<std::uint32_t> order = morton_order(points);
  std::erase_if(order, [&first](std::uint32_t v) { return first[v] != v; });
  return order;
}

// Some of the points, in units in which fourth powers neither overflow nor vanish: coordinates
// times a power of two.
static std::vector<Local_triangulator::Point>
points_to_triangulate(const std::vector<std::array<double, 3>>& points,
                      const std::vector<std::uint32_t>& members) {
  // Up to there they are left as they are: fourth powers of the largest are from 2^-400 to 2^404.
  constexpr int most = 100;
  double largest = 0;
  for (const std::uint32_t v : members)
    for (const double x : points[v]) largest = std::max(largest, std::abs(x));
  const int exponent = largest > 0 ? std::ilogb(largest) : 0;
  std::vector<Local_triangulator::Point> result;
  result.reserve(members.size());
  for (const std::uint32_t v : members) {
    std::array<double, 3> p = points[v];
    if (std::abs(exponent) > most)
      for (double& x : p) x = std::ldexp(x, -exponent);
    result.emplace_back(p[0], p[1], p[2]);
  }
  return result;
}

[[noreturn]] static void fail_without_triangles(std::size_t points) {
  throw Invalid_input(Element_kind::none, 0,
                      "no three of the " + std::to_string(points) +
                          " points make a triangle; give points near a surface, and at least two "
                          "neighbours");
}

// A border has many points. Noise opens the stars of one or two: they are closed again if that of
// an end is closed.
static void close_lone_stars(const std::vector<Delaunay_star::Extent>& extent, Stars& stars) {
  using Extent = Delaunay_star::Extent;
  const auto is_open = [&](std::size_t i) { return extent[stars.corners[i]] != Extent::closed; };
  for (std::size_t v = 0; v < extent.size(); ++v) {
    const auto [from, to] = stars.range[v];
    const bool stays = extent[v] == Extent::bent && from < to && is_open(from) && is_open(to - 1);
    stars.is_open[v] = extent[v] == Extent::open || stays ? 1 : 0;
  }
}

static Stars find_stars(const std::vector<std::array<double, 3>>& points,
                        const std::vector<std::uint32_t>& members, std::size_t neighbours) {
  const std::vector<Local_triangulator::Point> ordered = points_to_triangulate(points, members);
  Local_triangulator triangulator(ordered, members, neighbours);
  Stars stars{{}, {}, {}, std::vector<char>(points.size(), 0), {}};
  std::vector<Delaunay_star::Extent> extent(points.size(), Delaunay_star::Extent::closed);
  stars.range.assign(points.size(), {0, 0});
  stars.corners.reserve(6 * points.size() + 6); // the usual number
  for (std::uint32_t i = 0; const std::uint32_t center : members) {
    const std::size_t begin = stars.corners.size();
    extent[center] = triangulator.add(i++, stars);
    stars.range[center] = {begin, stars.corners.size()};
    stars.order.emplace_back(triangulator.signature(), center);
  }
  std::ranges::sort(stars.order);
  close_lone_stars(extent, stars);
  Ties(stars).resolve();
  return stars;
}

} // namespace internal

std::vector<std::array<std::uint32_t, 3>>
triangles_at_points(const std::vector<std::array<double, 3>>& points, std::size_t neighbours,
                    Point_cloud_report& report) {
  const std::vector<std::uint32_t> members =
      internal::distinct_points(points, internal::first_points_at_places(points));
  report.duplicated_points = points.size() - members.size();
  report.neighbours = members.empty() ? 0 : std::min(neighbours, members.size() - 1);
  if (members.size() < 3) internal::fail_without_triangles(points.size());
  internal::Stars stars = internal::find_stars(points, members, report.neighbours);
  report.is_on_border = stars.is_open;
  for (const std::uint32_t v : members)
    if (stars.range[v][0] == stars.range[v][1]) ++report.points_without_triangles;
  std::vector<std::array<std::uint32_t, 3>> triangles = internal::triangles_of(std::move(stars));
  report.triangles = triangles.size();
  if (triangles.empty()) internal::fail_without_triangles(points.size());
  return triangles;
}

Point_cloud make_point_cloud(const std::vector<std::array<double, 3>>& points,
                             std::size_t neighbours, Mollification mollification) {
  Point_cloud_report report;
  Triangle_soup soup;
  soup.triangles = triangles_at_points(points, neighbours, report);
  soup.points = points;
  soup.input_faces = soup.triangles.size();
  Point_cloud cloud;
  static_cast<Domain&>(cloud) = internal::domain_of_stars(std::move(soup), mollification);
  cloud.report.sheets = cloud.input.names.sheets *= 3;
  cloud.report.reason =
      "the triangles at every point among its " + std::to_string(report.neighbours) + " neighbours";
  cloud.points = std::move(report);
  return cloud;
}

} // namespace CGAL::Intrinsic_triangulations
