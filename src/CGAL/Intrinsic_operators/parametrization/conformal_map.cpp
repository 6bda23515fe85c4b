// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/operators/Face_table.h>
#include <CGAL/Intrinsic_operators/parametrization/Border_spectrum.h>
#include <CGAL/Intrinsic_operators/parametrization/conformal_map.h>
#include <CGAL/Intrinsic_operators/parametrization/disk_border.h>
#include <CGAL/Intrinsic_operators/parametrization/pack_components.h>
#include <CGAL/Intrinsic_operators/solvers/Chosen_factorization.h>
#include <CGAL/Intrinsic_operators/solvers/Linear_solver.h>
#include <CGAL/Intrinsic_operators/solvers/matrix_rows.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {

Complex_matrix conformal_energy(const Eigen::SparseMatrix<double>& laplacian,
                                const std::vector<Disk_border>& borders) {
  Complex_matrix c = (laplacian / 2).cast<std::complex<double>>();
  std::vector<Eigen::Triplet<std::complex<double>>> area;
  for (const Disk_border& border : borders)
    for (std::size_t k = 0; k < border.rows.size(); ++k) { // the area is 1/2 Im(conj(w_i) w_j)
      const auto i = static_cast<int>(border.rows[k]),
                 j = static_cast<int>(border.rows[(k + 1) % border.rows.size()]);
      area.emplace_back(i, j, std::complex<double>(0, -0.25));
      area.emplace_back(j, i, std::complex<double>(0, 0.25));
    }
  c -= matrix_of(c.rows(), c.cols(), area);
  c.makeCompressed();
  return c;
}

// The points, scaled to the area of the surface.
static Eigen::MatrixX2d scaled_to_area(const Face_table& table, const Eigen::VectorXcd& w) {
  double area = 0, of_image = 0;
  for (const Table_face& f : table.faces) {
    const std::complex<double> a = w[f.rows[1]] - w[f.rows[0]], b = w[f.rows[2]] - w[f.rows[0]];
    area += f.area();
    of_image += std::imag(std::conj(a) * b) / 2;
  }
  const double factor = table.unscaled(of_image > 0 ? std::sqrt(area / of_image) : 1);
  Eigen::MatrixX2d result(w.size(), 2);
  result.col(0) = factor * w.real();
  result.col(1) = factor * w.imag();
  return result;
}

// A component alone, with rows of its own.
struct Disk {
  Face_table table;
  Eigen::SparseMatrix<double> laplacian;
  Disk_border border;
  std::vector<Eigen::Index> rows; // that it has in the whole
};

static std::vector<Disk> disks_of(const Face_table& table,
                                  const Eigen::SparseMatrix<double>& laplacian,
                                  const std::vector<Disk_border>& borders,
                                  const std::vector<std::uint32_t>& place) {
  std::vector<Disk> disks(borders.size());
  std::vector<int> local(place.size(), -1);
  for (std::size_t r = 0; r < place.size(); ++r) {
    if (place[r] == Gluing::none) continue;
    std::vector<Eigen::Index>& rows = disks[place[r]].rows;
    local[r] = static_cast<int>(rows.size());
    rows.push_back(static_cast<Eigen::Index>(r));
  }
  for (std::size_t i = 0; i < disks.size(); ++i) {
    disks[i].table.scale_exponent = table.scale_exponent;
    disks[i].border = borders[i];
    for (std::uint32_t& r : disks[i].border.rows) r = static_cast<std::uint32_t>(local[r]);
  }
  for (Table_face face : table.faces) {
    Disk& disk = disks[place[static_cast<std::size_t>(face.rows[0])]];
    for (int& r : face.rows) r = local[static_cast<std::size_t>(r)];
    disk.table.faces.push_back(face);
  }
  for (Disk& disk : disks) {
    std::vector<Eigen::Triplet<double>> entries;
    for (const Eigen::Index column : disk.rows)
      for (Eigen::SparseMatrix<double>::InnerIterator i(laplacian, column); i; ++i)
        entries.emplace_back(local[static_cast<std::size_t>(i.row())],
                             local[static_cast<std::size_t>(column)], i.value());
    const auto n = static_cast<Eigen::Index>(disk.rows.size());
    disk.laplacian = matrix_of(n, n, entries);
  }
  return disks;
}

// Maps each disk by a function of it, and packs them. One disk alone keeps its isolated vertices.
// If the function returns no points, there are none.
template <class Map>
static Eigen::MatrixX2d maps_of_disks(const Face_table& table,
                                      const Eigen::SparseMatrix<double>& laplacian,
                                      const std::vector<Disk_border>& borders, const Map& map) {
  if (borders.size() == 1) return map(table, laplacian, borders.front());
  const std::vector<std::uint32_t> component = table.components();
  std::vector<std::uint32_t> place(component.size(), Gluing::none);
  for (std::uint32_t i = 0; i < borders.size(); ++i) place[component[borders[i].rows[0]]] = i;
  for (std::size_t r = 0; r < place.size(); ++r) place[r] = place[component[r]];
  Eigen::MatrixX2d result = Eigen::MatrixX2d::Zero(laplacian.rows(), 2);
  for (const Disk& disk : disks_of(table, laplacian, borders, place)) {
    const Eigen::MatrixX2d uv = map(disk.table, disk.laplacian, disk.border);
    if (uv.rows() == 0) return uv;
    result(disk.rows, Eigen::all) = uv;
  }
  pack_components(result, place);
  return result;
}

// Counts solutions for a visitor.
class Counted_solutions {
public:
  explicit Counted_solutions(const std::function<bool(std::size_t)>& progress)
      : progress_(progress) {}
  // before a factorization
  bool begins() const { return progress_(solutions_); }
  // after a solution
  bool follows() { return progress_(++solutions_); }

private:
  const std::function<bool(std::size_t)>& progress_;
  std::size_t solutions_ = 0;
};

// The rows of the vertex of a border where its longest edge begins, and of the vertex half the
// border away. They do not depend on the numbers of vertices, unless edges are equally long within
// rounding.
static std::pair<int, int> opposite_rows(const Disk_border& border) {
  const std::size_t n = border.rows.size();
  std::size_t begin = 0, steps = 0;
  for (std::size_t i = 1; i < n; ++i)
    if (border.lengths[i] > (1 + 0x1p-40) * border.lengths[begin]) begin = i;
  const double half = std::accumulate(border.lengths.begin(), border.lengths.end(), 0.0) / 2;
  for (double length = 0; length < half && steps + 1 < n; ++steps)
    length += border.lengths[(begin + steps) % n];
  return {static_cast<int>(border.rows[begin]), static_cast<int>(border.rows[(begin + steps) % n])};
}

static Eigen::MatrixX2d least_squares_map_of_disk(const Face_table& table,
                                                  const Eigen::SparseMatrix<double>& laplacian,
                                                  const Disk_border& border, Linear_solver solver,
                                                  Counted_solutions& solutions) {
  if (!solutions.begins()) return {};
  Complex_matrix c = conformal_energy(laplacian, {border});
  regularise_isolated(c);
  const auto [first, second] = opposite_rows(border);
  std::vector<char> is_fixed(static_cast<std::size_t>(c.rows()), 0);
  is_fixed[static_cast<std::size_t>(first)] = is_fixed[static_cast<std::size_t>(second)] = 1;
  Eigen::VectorXcd w = -c.col(second);
  w[first] = 0;
  w[second] = 1;
  c = with_fixed_rows(std::move(c), is_fixed);
  w = chosen_factorization(std::move(c), solver).solve(w);
  if (!solutions.follows()) return {};
  return scaled_to_area(table, w);
}

static Eigen::MatrixX2d spectral_map_of_disk(const Face_table& table,
                                             const Eigen::SparseMatrix<double>& laplacian,
                                             const Disk_border& border,
                                             Counted_solutions& solutions) {
  if (!solutions.begins()) return {};
  Eigen::VectorXcd w = first_of_border_spectrum(conformal_energy(laplacian, {border}), border,
                                                [&] { return solutions.follows(); });
  if (w.size() == 0) return {};
  const std::complex<double> start = w[border.rows[0]];
  if (std::abs(start) > 0) w *= std::conj(start) / std::abs(start);
  for (Eigen::Index r = 0; r < w.size(); ++r)
    if (laplacian.coeff(static_cast<int>(r), static_cast<int>(r)) == 0) w[r] = 0;
  return scaled_to_area(table, w);
}

Eigen::MatrixX2d least_squares_conformal_map(const Face_table& table,
                                             const Eigen::SparseMatrix<double>& laplacian,
                                             const std::vector<Disk_border>& borders,
                                             Linear_solver solver,
                                             const std::function<bool(std::size_t)>& progress) {
  Counted_solutions solutions(progress);
  return maps_of_disks(table, laplacian, borders, [&](auto&... disk) {
    return least_squares_map_of_disk(disk..., solver, solutions);
  });
}

Eigen::MatrixX2d spectral_conformal_map(const Face_table& table,
                                        const Eigen::SparseMatrix<double>& laplacian,
                                        const std::vector<Disk_border>& borders,
                                        const std::function<bool(std::size_t)>& progress) {
  Counted_solutions solutions(progress);
  return maps_of_disks(table, laplacian, borders,
                       [&](auto&... disk) { return spectral_map_of_disk(disk..., solutions); });
}

} // namespace internal

} // namespace CGAL::Intrinsic_triangulations
