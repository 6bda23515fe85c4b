// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_BENCHMARK_MEASURE_MODELS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_BENCHMARK_MEASURE_MODELS_H

#include "benchmark_support.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations::benchmark {

/*!
\brief runs a benchmark `NAME [DIRECTORY [REPETITIONS [MODEL...]]]`: measures each model, reports each of them on standard error, and writes an object with an entry per model.
\param measure called with a mesh and the number of repetitions; returns the entry
\return what `main()` returns
*/
template <class Measure>
int measure_models(int argc, char** argv, const char* name, std::size_t repetitions,
                   std::vector<std::string> models, const Measure& measure) {
  try {
    if (argc > 2) repetitions = std::stoul(argv[2]);
    if (argc > 3) models.assign(argv + 3, argv + argc);
    nlohmann::json result;
    for (const std::string& model : models) {
      result[model] = measure(read_mesh(mesh_directory(argc, argv), model), repetitions);
      std::cerr << model << ' ' << result[model].dump() << '\n';
    }
    std::cout << result.dump(2) << '\n';
    return 0;
  } catch (const std::exception& e) {
    std::cerr << name << ": " << e.what() << '\n';
    return 1;
  }
}

} // namespace CGAL::Intrinsic_triangulations::benchmark

#endif // CGAL_INTRINSIC_TRIANGULATIONS_BENCHMARK_MEASURE_MODELS_H
