// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// How long does `conformal_metric()` take on closed surfaces with cones, exactly and with doubles,
// compared with a plain Newton's method in long doubles that uses the same triangles and steps?
// Usage: conformal_speed [DIRECTORY [REPETITIONS [MODEL...]]] > conformal_speed.json

#include "measure_models.h"
#include "plain_conformal.h"

#include <CGAL/Intrinsic_conformal/angles/flat_angles.h>
#include <CGAL/Intrinsic_conformal/angles/ideal_start.h>
#include <CGAL/Intrinsic_conformal/metric/conformal_metric.h>
#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_euclidean_traits.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_ideal_hyperbolic_traits.h>
#include <CGAL/Intrinsic_triangulations/metric/Ideal_hyperbolic_traits.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/flip_to_delaunay.h>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
using namespace IT::benchmark;

namespace {

template <class Traits>
using Triangulation = IT::Intrinsic_triangulation<IT::Gluing_map, Traits, IT::Integer_coordinates>;

constexpr double tolerance = 1e-10; // of angles, in radians

template <class Traits>
nlohmann::json run_ours(const IT::Intrinsic_input& start, const IT::Prescribed_angles& angles,
                        std::vector<double>& times) {
  const double begin = processor_time();
  Triangulation<Traits> t(start);
  const IT::Conformal_metric m =
      IT::conformal_metric(t, angles, IT::parameters::tolerance(tolerance));
  times.push_back(processor_time() - begin);
  return {{"steps", m.iterations}, {"residual", m.residual}, {"flips", m.flips}};
}

nlohmann::json run_plain(const IT::Intrinsic_input& start, const IT::Prescribed_angles& angles,
                         std::vector<double>& times) {
  const double begin = processor_time();
  Plain_newton<long double> newton = plain_newton<long double>(start, angles);
  newton.solve(100, tolerance);
  times.push_back(processor_time() - begin);
  return {{"steps", newton.steps()}, {"residual", double(newton.residual())}};
}

nlohmann::json measure_cones(const IT::Intrinsic_input& start, std::size_t cones,
                             std::size_t repetitions) {
  Triangulation<IT::Ideal_hyperbolic_traits<double>> t(start);
  const IT::Prescribed_angles angles = IT::place_cones(t, cones);
  std::vector<double> plain, exact, doubles;
  nlohmann::json result;
  for (std::size_t i = 0; i < repetitions; ++i) {
    result["plain"] = run_plain(start, angles, plain);
    result["exact"] = run_ours<IT::Exact_ideal_hyperbolic_traits>(start, angles, exact);
    result["double"] = run_ours<IT::Ideal_hyperbolic_traits<double>>(start, angles, doubles);
  }
  result["plain"]["milliseconds"] = median(plain);
  result["exact"]["milliseconds"] = median(exact);
  result["double"]["milliseconds"] = median(doubles);
  result["times_faster"] = median(plain) / median(exact);
  return result;
}

nlohmann::json measure(const Surface_mesh& mesh, std::size_t repetitions) {
  Triangulation<IT::Exact_euclidean_traits> t(mesh);
  IT::flip_to_delaunay(t);
  const IT::Intrinsic_input start = IT::ideal_start(t);
  nlohmann::json result = {{"faces", num_faces(mesh)}};
  for (const std::size_t cones : {8U, 100U})
    result[std::to_string(cones) + " cones"] = measure_cones(start, cones, repetitions);
  return result;
}

} // namespace

int main(int argc, char** argv) {
  return measure_models(argc, argv, "conformal_speed", 5,
                        {"elephant", "camel", "armadillo", "refined_elephant"}, measure);
}
