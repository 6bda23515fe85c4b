// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_APPLICATION_DISTANCE_COLUMNS_H
#define INTRINSIC_APPLICATION_DISTANCE_COLUMNS_H

#include "../options.h"
#include "../support/progress.h"
#include "Computed.h"

#include <CGAL/Intrinsic_geodesics/distance/batches.h>
#include <CGAL/Intrinsic_operators/distance/Heat_distance.h>
#include <CGAL/Intrinsic_operators/distance/heat_distances.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Twin_points.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <vector>

namespace program {

/// Vertices of a set.
using Vertices = std::vector<IT::Gluing_map::Vertex>;

/// Shows how many parts of a batch are done, which may be a part of a larger one.
struct Batch_progress {
  Progress& line;
  std::size_t before = 0, after = 0; // parts that are not in this batch

  /// is called after each part.
  bool progress(std::size_t done, std::size_t all) {
    line.show("solving",
              std::to_string(before + done) + " of " + std::to_string(before + all + after));
    return true;
  }
};

/// Distances from sources to all vertices, by their rows.
template <class Triangulation>
class Distance_columns {
public:
  /// prepares searches in a triangulation, which must outlive this object.
  Distance_columns(const Triangulation& t, const Application_options& o, Progress& progress)
      : t_(t), options_(o), progress_(progress), twins_(t) {
    if (o.distance == "heat") heat_.emplace(t, IT::parameters::time_factor(o.time_factor));
  }

  /// finds a column for each set, many at a time, and calls a function with its number and it, one
  /// after another; returns whether all searches arrived.
  template <class Take>
  IT::Status for_each(std::span<const Vertices> sets, const Take& take) const {
    constexpr std::size_t most_numbers = std::size_t{1} << 25; // 256 MiB in memory at a time
    const std::size_t rows = t_.number_of_vertices();
    const std::size_t threads = std::max(1U, std::thread::hardware_concurrency());
    const std::size_t step = std::max(most_numbers / rows, threads);
    std::vector<double> block;
    IT::Status status = IT::Status::done;
    for (std::size_t i = 0; i < sets.size(); i += step) {
      const auto part = sets.subspan(i, std::min(step, sets.size() - i));
      block.resize(part.size() * rows);
      const Batch_progress progress{progress_, i, sets.size() - i - part.size()};
      if (const IT::Status s = find(part, block, progress); s != IT::Status::done) status = s;
      for (std::size_t k = 0; k < part.size(); ++k) {
        const auto column = std::span(block).subspan(k * rows, rows);
        twins_.copy(column);
        take(i + k, std::span<const double>(column));
      }
    }
    return status;
  }

  /// adds the time of the flow.
  void report(Json& json) const {
    if (heat_) json["time"] = heat_->time();
  }

private:
  IT::Status find(std::span<const Vertices> sets, std::span<double> out,
                  const Batch_progress& progress) const {
    if (heat_) return IT::heat_distances(*heat_, sets, out, IT::parameters::visitor(progress));
    return IT::polyhedral_distances(
        t_, sets, out,
        IT::parameters::maximum_distance(
            options_.maximum_distance.value_or(std::numeric_limits<double>::infinity()))
            .visitor(progress));
  }

  const Triangulation& t_;
  const Application_options& options_;
  Progress& progress_;
  IT::Twin_points twins_;
  std::optional<IT::Heat_distance<Triangulation>> heat_;
};

} // namespace program

#endif // INTRINSIC_APPLICATION_DISTANCE_COLUMNS_H
