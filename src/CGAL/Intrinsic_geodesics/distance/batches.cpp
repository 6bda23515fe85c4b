// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_geodesics/distance/batches.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

bool for_each_in_threads(std::size_t size, std::size_t threads,
                         const std::function<std::function<void(std::size_t)>()>& make_worker,
                         const std::function<bool(std::size_t)>& progress) {
  if (threads == 0) threads = std::max(1U, std::thread::hardware_concurrency());
  std::atomic<std::size_t> next{0};
  std::atomic<bool> goes_on{true};
  std::mutex mutex; // of what follows
  std::size_t done = 0;
  std::exception_ptr thrown;
  const auto work = [&] {
    try {
      const std::function<void(std::size_t)> call = make_worker();
      for (std::size_t i = next++; i < size && goes_on; i = next++) {
        call(i);
        const std::scoped_lock lock(mutex);
        if (goes_on && !progress(++done)) goes_on = false;
      }
    } catch (...) {
      const std::scoped_lock lock(mutex);
      if (!thrown) thrown = std::current_exception();
      goes_on = false;
    }
  };
  std::vector<std::jthread> others;
  for (std::size_t i = 1; i < std::min(threads, size); ++i) others.emplace_back(work);
  if (size > 0) work();
  others.clear(); // joins
  if (thrown) std::rethrow_exception(thrown);
  return done == size;
}

void expect_columns(std::size_t rows, std::size_t columns, std::size_t places) {
  if (places != rows * columns)
    throw std::invalid_argument("distances of " + std::to_string(rows) + " vertices from " +
                                std::to_string(columns) + " sets of sources need place for " +
                                std::to_string(rows * columns) + " numbers, not " +
                                std::to_string(places));
}

} // namespace CGAL::Intrinsic_triangulations::internal
