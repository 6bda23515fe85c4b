// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Maps a disk of slivers to a round one, proves that the map is injective, and gives its vertices and those of the common subdivision
// coordinates, which a file in OBJ format has as texture coordinates. Then maps that keep angles.
// Usage: parametrization [OUT.obj]

#include <CGAL/Intrinsic_operators/operators/transfer.h>
#include <CGAL/Intrinsic_operators/parametrization/certify_map.h>
#include <CGAL/Intrinsic_operators/parametrization/conformal_map.h>
#include <CGAL/Intrinsic_operators/parametrization/harmonic_map.h>
#include <CGAL/Intrinsic_operators/parametrization/measure_distortion.h>
#include <CGAL/Intrinsic_triangulations.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <filesystem>
#include <iostream>

namespace IT = CGAL::Intrinsic_triangulations;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

int main(int argc, char* argv[]) {
  const std::filesystem::path file =
      argc > 1 ? argv[1] : std::filesystem::temp_directory_path() / "parametrization.obj";
  Mesh mesh;
  const auto wave = [](std::size_t i, std::size_t j) {
    const double x = double(i) / 8, y = double(j) / 64 + x / 2;
    return Mesh::Point(x, y, 0.2 * std::sin(7 * x) * std::cos(4 * y));
  };
  CGAL::make_grid(8, 64, mesh, wave, true);
  IT::Corresponding_triangulation t(mesh);
  const bool is_injective_as_is = IT::certify_map(t, IT::harmonic_map(t)).is_injective();

  //! [harmonic]
  IT::delaunay_refine(t, IT::parameters::minimum_angle(25));
  const Eigen::MatrixX2d uv = IT::harmonic_map(t); // to the unit circle
  const IT::Map_certificate certificate = IT::certify_map(t, uv);
  //! [harmonic]
  //! [corners]
  const Eigen::MatrixX2d of_mesh = IT::copy_to_input(t, uv); // a row per vertex of the mesh
  const IT::Common_subdivision s = IT::common_subdivision(t);
  const Eigen::MatrixX2d of_subdivision =
      IT::interpolation_from_intrinsic(s) * uv; // s.corner[c] is a row
  //! [corners]
  //! [file]
  // fields with the names u and v are texture coordinates in OBJ
  const Eigen::VectorXd u = of_subdivision.col(0), v = of_subdivision.col(1);
  IT::write_common_subdivision(
      file, s, IT::positions(s, mesh),
      std::array{IT::Subdivision_field("u", u), IT::Subdivision_field("v", v)});
  //! [file]
  //! [conformal]
  const IT::Map_distortion harmonic = IT::measure_distortion(t, uv),
                           least_squares =
                               IT::measure_distortion(t, IT::least_squares_conformal_map(t)),
                           spectral = IT::measure_distortion(t, IT::spectral_conformal_map(t));
  //! [conformal]
  std::cout << "injective as is: " << is_injective_as_is
            << ", refined: " << certificate.is_injective() << "; " << of_mesh.rows()
            << " vertices, " << of_subdivision.rows()
            << " of the subdivision\nquasi-conformal: harmonic " << harmonic.mean_quasi_conformal
            << ", least squares " << least_squares.mean_quasi_conformal << ", spectral "
            << spectral.mean_quasi_conformal << '\n';
  const bool is_written = std::filesystem::file_size(file) > 0;
  if (argc <= 1) std::filesystem::remove(file); // the test leaves nothing behind
  return is_written && certificate.is_injective() &&
                 spectral.mean_quasi_conformal < harmonic.mean_quasi_conformal
             ? 0
             : 1;
}
