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

namespace {

// Calls that several threads share. The thread that has asked for them makes some of them and all
// reports: a visitor may need the locks that this thread holds.
class Shared_calls {
public:
  using Make_worker = std::function<std::function<void(std::size_t)>()>;
  using Progress = std::function<bool(std::size_t)>;

  Shared_calls(std::size_t size, const Make_worker& make_worker, const Progress& progress)
      : size_(size), make_worker_(make_worker), progress_(progress) {}

  // Makes calls in the thread that has asked, and in so many others. Returns whether all were made.
  bool run(std::size_t others) {
    working_ = others;
    {
      std::vector<std::jthread> threads;
      for (std::size_t i = 0; i < others; ++i) threads.emplace_back([this] { work_elsewhere(); });
      if (size_ > 0) guard([this] { work([this] { report(); }); });
      for (bool is_last = false; !is_last;) {
        const std::size_t seen = changes_;
        is_last = working_ == 0;
        guard([this] { report(); });
        if (!is_last) changes_.wait(seen);
      }
    } // joins
    if (thrown_) std::rethrow_exception(thrown_);
    return reported_ == size_;
  }

private:
  template <class Function>
  void guard(const Function& function) {
    try {
      function();
    } catch (...) {
      const std::scoped_lock lock(mutex_);
      if (!thrown_) thrown_ = std::current_exception();
      goes_on_ = false;
    }
  }

  template <class Function>
  void work(const Function& after_call) {
    const std::function<void(std::size_t)> call = make_worker_();
    for (std::size_t i = next_++; i < size_ && goes_on_; i = next_++) {
      call(i);
      ++done_;
      after_call();
    }
  }

  void work_elsewhere() {
    guard([this] { work([this] { tell(); }); });
    --working_;
    tell();
  }

  void tell() {
    ++changes_;
    changes_.notify_one();
  }

  void report() {
    while (goes_on_ && reported_ < done_)
      if (!progress_(++reported_)) goes_on_ = false;
  }

  std::size_t size_, reported_ = 0;
  const Make_worker& make_worker_;
  const Progress& progress_;
  std::atomic<std::size_t> next_{0}, done_{0}, working_{0}, changes_{0};
  std::atomic<bool> goes_on_{true};
  std::mutex mutex_; // of what follows
  std::exception_ptr thrown_;
};

} // namespace

bool for_each_in_threads(std::size_t size, std::size_t threads,
                         const std::function<std::function<void(std::size_t)>()>& make_worker,
                         const std::function<bool(std::size_t)>& progress) {
  if (threads == 0) threads = std::max(1U, std::thread::hardware_concurrency());
  const std::size_t used = std::max(std::min(threads, size), std::size_t{1});
  return Shared_calls(size, make_worker, progress).run(used - 1);
}

void expect_columns(std::size_t rows, std::size_t columns, std::size_t places) {
  if (places != rows * columns)
    throw std::invalid_argument("distances of " + std::to_string(rows) + " vertices from " +
                                std::to_string(columns) + " sets of sources need place for " +
                                std::to_string(rows * columns) + " numbers, not " +
                                std::to_string(places));
}

} // namespace CGAL::Intrinsic_triangulations::internal
