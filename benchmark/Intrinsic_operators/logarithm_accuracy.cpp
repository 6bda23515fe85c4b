// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How far are logarithms by heat from those along exact shortest paths, and how long do all
// methods take?
//
//   logarithm_accuracy MESH... > table.md
//
// On the Delaunay triangulation of each mesh, from the vertex in the middle of the file. Errors
// are means over vertices, of lengths and of vectors, by the
// greatest length; times are of the processor.

#include <CGAL/Intrinsic_operators/vectors/Vector_heat_method.h>
#include <CGAL/Intrinsic_operators/vectors/logarithmic_map.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/IO/soup/read_triangle_soup.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/domains/Domain.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <ctime>
#include <exception>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace IT = CGAL::Intrinsic_triangulations;
using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits,
                                                  IT::Integer_coordinates>;
using Map = std::vector<std::complex<double>>;

double seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Calls a function and returns what it returns, with the time that it takes.
template <class Function>
Map timed(const Function& function, double& time) {
  const double start = seconds();
  Map map = function();
  time = seconds() - start;
  return map;
}

/// In percent of a length, of lengths and of vectors up to a distance.
std::string errors(const Map& found, const Map& exact, double distance, double unit) {
  double lengths = 0, vectors = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    if (!(std::abs(exact[i]) <= distance) || std::isnan(found[i].real())) continue;
    ++count;
    lengths += std::abs(std::abs(found[i]) - std::abs(exact[i]));
    vectors += std::abs(found[i] - exact[i]);
  }
  std::ostringstream text;
  const double scale = 100 / (unit * static_cast<double>(count));
  text << std::setprecision(2) << scale * lengths << " / " << scale * vectors << " %";
  return text.str();
}

void measure(const std::string& file) {
  Triangulation t(IT::make_domain(IT::read_triangle_soup(file)).input);
  IT::flip_to_delaunay(t);
  auto source = t.numbers().vertex_at(0);
  for (const auto v : vertices(t.mesh()))
    if (t.input_vertex(v) == t.number_of_vertices() / 2) source = v;
  const IT::Vector_heat_method<Triangulation> heat(t);
  const auto by_heat = [&] { return heat.logarithmic_map(source, IT::Logarithm_method::affine); };
  double time = 0, first = 0, then = 0;
  const Map exact = timed([&] { return IT::logarithmic_map(t, source); }, time),
            affine = timed(by_heat, first), again = timed(by_heat, then),
            polar = heat.logarithmic_map(source, IT::Logarithm_method::polar);
  double radius = 0;
  for (const auto& z : exact)
    if (std::abs(z) > radius) radius = std::abs(z);
  std::cout << "| " << std::filesystem::path(file).stem().string() << " | "
            << t.number_of_vertices();
  for (const double part : {1., 0.2})
    for (const Map* map : {&affine, &polar})
      std::cout << " | " << errors(*map, exact, part * radius, radius);
  std::cout << std::setprecision(2) << " | " << time << " | " << first << " | " << then << " |\n";
}

} // namespace

int main(int argc, char** argv) {
  try {
    for (int i = 1; i < argc; ++i) measure(argv[i]);
  } catch (const std::exception& e) {
    std::cerr << "logarithm_accuracy: " << e.what() << '\n';
    return 1;
  }
}
