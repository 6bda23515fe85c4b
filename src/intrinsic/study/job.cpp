// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "arithmetics.h"
#include "run.h"
#include "sources.h"
#include "study.h"

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/metric/Euclidean_traits.h>

#include <gmp.h>

#include <cmath>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <new>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

namespace program {

namespace {

const Arithmetic& arithmetic_named(const std::string& name) {
  for (const Arithmetic& a : arithmetics())
    if (a.name == name) return a;
  throw std::invalid_argument(name + ": there is no such arithmetic");
}

// GMP aborts if there is no memory, and number types may not survive an exception.
[[noreturn]] void end_out_of_memory() { _exit(exit_out_of_memory); }

extern "C" void* allocate_for_gmp(std::size_t size) {
  void* const p = std::malloc(size);
  if (p == nullptr) end_out_of_memory();
  return p;
}
extern "C" void* reallocate_for_gmp(void* old, std::size_t, std::size_t size) {
  void* const p = std::realloc(old, size);
  if (p == nullptr) end_out_of_memory();
  return p;
}
extern "C" void free_for_gmp(void* p, std::size_t) { std::free(p); }

void limit_this_process(const Study_limits& limits) {
  std::set_new_handler(end_out_of_memory);
  mp_set_memory_functions(allocate_for_gmp, reallocate_for_gmp, free_for_gmp);
  // the parent process limits the time on the clock; this ends jobs that have lost their parent
  const auto seconds = static_cast<rlim_t>(std::ceil(limits.seconds)) + 1;
  const rlimit time{seconds, seconds + 1};
  setrlimit(RLIMIT_CPU, &time);
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
#ifndef __SANITIZE_ADDRESS__ // reserves terabytes
  const rlimit memory{limits.mib << 20U, limits.mib << 20U};
  setrlimit(RLIMIT_AS, &memory);
#endif
}

// The mollification is decided exactly, so that all arithmetics work on the same metric.
void prepare(Study_run& run) {
  const IT::Intrinsic_triangulation<> exact{IT::Intrinsic_input(run.input)};
  run.input.mollification = exact.report().mollification.kind;
  run.findings["vertices"] = num_vertices(exact.mesh());
  run.findings["faces"] = num_faces(exact.mesh());
  run.before =
      conserved(IT::Intrinsic_triangulation<IT::Gluing_map, IT::Euclidean_traits<long double>>(
          IT::Intrinsic_input(run.input)));
}

// What the arithmetic did alone stands, whatever becomes of the comparison.
void end_with(Study_run& run, const char* status, const std::string& message) {
  run.findings[run.findings.contains("status") ? "comparison" : "status"] = status;
  run.findings["message"] = message;
  run.emit();
}

// Messages name files by their path, which must not be in the result.
std::string without_path(std::string message, const Study_source& source) {
  const std::size_t at = message.find(source.location);
  if (at != std::string::npos) message.replace(at, source.location.size(), source.name);
  return message;
}

// filled before main()
std::vector<Arithmetic>& registered_arithmetics() {
  static std::vector<Arithmetic> registered;
  return registered;
}

} // namespace

Registered_arithmetic::Registered_arithmetic(std::string name, void (*study)(Study_run&)) {
  registered_arithmetics().push_back({std::move(name), study});
}

const std::vector<Arithmetic>& arithmetics() {
  static const std::vector<Arithmetic> all = [] {
    std::vector<Arithmetic> sorted;
    for (const auto& kind : {hardware_arithmetics(), interval_arithmetics(), number_types(),
                             certified_arithmetics(), registered_arithmetics()})
      sorted.insert(sorted.end(), kind.begin(), kind.end());
    return sorted;
  }();
  return all;
}

void Study_run::emit() const {
  const std::string line = findings.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
  for (std::size_t done = 0; done < line.size();) {
    const ssize_t n = write(STDOUT_FILENO, line.data() + done, line.size() - done);
    if (n <= 0) throw std::runtime_error("standard output cannot be written");
    done += static_cast<std::size_t>(n);
  }
}

void reset_peak_memory() {
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << "5"; // see proc(5)
}

double peak_memory_mib() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    std::istringstream words(line);
    std::string key;
    double kib = 0;
    if (words >> key >> kib && key == "VmHWM:") return kib / 1024;
  }
  return 0;
}

void run_study_job(const Study_options& job) {
  const Arithmetic& chosen = arithmetic_named(job.arithmetics.at(0));
  const Study_source source = study_source(job.corpus.at(0), job.domain);
  limit_this_process(job.limits);
  Study_run run;
  run.findings = {{"mesh", source.name}, {"family", source.family}, {"arithmetic", chosen.name}};
  try {
    run.input = read_study_source(source);
    prepare(run);
  } catch (const std::exception& e) {
    end_with(run, "refused_input", without_path(e.what(), source));
    return;
  }
  run.emit();
  try {
    chosen.study(run);
  } catch (const IT::Invalid_input& e) { // not so in exact arithmetic
    end_with(run, "not_applicable", e.what());
  } catch (const std::exception& e) {
    end_with(run, "crashed", e.what());
  }
}

} // namespace program
