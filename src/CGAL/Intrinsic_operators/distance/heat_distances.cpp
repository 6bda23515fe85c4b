// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_geodesics/distance/batches.h>
#include <CGAL/Intrinsic_operators/distance/heat_distances.h>
#include <CGAL/Intrinsic_operators/solvers/matrix_rows.h>

#include <Eigen/Core>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <thread>

namespace CGAL::Intrinsic_triangulations::internal {

bool for_each_heat_column(const Heat_batch& batch, std::span<const Source_places> sets,
                          std::size_t threads,
                          const std::function<void(std::size_t, std::span<const double>)>& take,
                          const std::function<bool(std::size_t)>& progress) {
  if (threads == 0) threads = std::max(1U, std::thread::hardware_concurrency());
  constexpr std::size_t widest = 8; // wider ones are no faster in measurements
  const std::size_t width =
      std::clamp((sets.size() + threads - 1) / threads, std::size_t{1}, widest);
  std::atomic<std::size_t> solved{0};
  std::size_t reported = 0;
  return for_each_in_threads(
      (sets.size() + width - 1) / width, threads,
      [&] {
        return [&, kept = std::make_shared<Pinned_laplacian::Kept>()](std::size_t i) {
          const std::size_t first = i * width;
          const auto part = sets.subspan(first, std::min(width, sets.size() - first));
          const Eigen::MatrixXd found = batch.solver.columns(part, batch.positions, *kept);
          for (std::size_t c = 0; c < part.size(); ++c)
            take(first + c,
                 {found.col(static_cast<Eigen::Index>(c)).data(), row_number(found.rows())});
          solved += part.size();
        };
      },
      [&](std::size_t) {
        for (const std::size_t now = solved; reported < now;)
          if (!progress(++reported)) return false;
        return true;
      });
}

} // namespace CGAL::Intrinsic_triangulations::internal
