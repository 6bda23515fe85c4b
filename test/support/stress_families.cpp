// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "stress_families.h"
#include "meshes.h"
#include "stress_meshes.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

namespace stress {

namespace {

using generators::Parameters;

// The known properties of a family, besides its mesh.
struct Family {
  const char* name;
  Mesh (*mesh)(const Parameters&);
  std::uint64_t size;
  double amount, least, most; // default and range of the amount
  bool is_whole;              // whether the amount is an integer
  bool is_random;             // whether the mesh depends on the seed; else it is shuffled
};

constexpr std::uint64_t largest_size = 10'000'000;
constexpr std::uint64_t largest_seed = 0xffff'ffffU;

constexpr double tiny = 1e-300; // amounts that must not be zero
constexpr Family families[] = {
    {"parabola", generators::parabola, 200, 0.25, tiny, 0.99, false, false},
    {"grid-plane", generators::grid_plane, 512, 0, 0, 1e6, false, false},
    {"grid-cube", generators::grid_cube, 600, 1, tiny, 1e6, false, false},
    {"grid-folded", generators::grid_folded, 512, 0, 0, 1e6, true, false},
    {"grid-cylinder", generators::grid_cylinder, 512, 0, 0, 1e6, true, false},
    {"splits", generators::splits, 1000, 0.1, 0, 0.5, false, true},
    {"needles", generators::needles, 600, 1e-3, tiny, 0.1, false, true},
    {"caps", generators::caps, 600, 1e-3, tiny, 0.1, false, true},
    {"ulps", generators::ulps, 512, 1, 1, 1 << 20, true, true},
    {"offset", generators::offset, 512, 1e9, 0, 1e15, false, true},
    {"stretched", generators::stretched, 512, 100, tiny, 1e12, false, true},
    {"wound-sphere", generators::wound_sphere, 1024, 5, 0, 1e6, true, false},
    {"wound-torus", generators::wound_torus, 1024, 5, 0, 1e6, true, false},
    {"wound-cylinder", generators::wound_cylinder, 1024, 5, 0, 1e6, true, false},
};

[[noreturn]] void fail(const std::string& spec, const std::string& what) {
  throw std::invalid_argument(spec + ": " + what);
}

// Grown, not added up: g++ 12 warns of overflows where a literal comes first.
std::string quoted(std::string_view text) {
  std::string result(1, '`');
  result += text;
  result += '`';
  return result;
}

const Family& family_of(const std::string& spec, std::string_view name) {
  std::string known;
  for (const Family& f : families) {
    if (f.name == name) return f;
    known += std::string(known.empty() ? "" : ", ") + f.name;
  }
  fail(spec, quoted(name) + " is not a family; known are " + known);
}

// The text of a number, without trailing zeros.
std::string text_of(double x) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof(buffer), x).ptr;
  return {buffer, end};
}

template <class Number>
Number number(const std::string& spec, std::string_view key, std::string_view text, Number least,
              Number most) {
  Number x{};
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, x);
  if (error != std::errc() || stop != end || !(least <= x && x <= most))
    fail(spec, quoted(key) + " is " + quoted(text) + "; give a number from " +
                   text_of(static_cast<double>(least)) + " to " +
                   text_of(static_cast<double>(most)));
  return x;
}

void set(Parameters& p, const std::string& spec, const Family& family, std::string_view key,
         std::string_view text) {
  if (key == "size") {
    p.size = number<std::uint64_t>(spec, key, text, 1, largest_size);
  } else if (key == "seed") {
    p.seed = number<std::uint64_t>(spec, key, text, 0, largest_seed);
  } else if (key == "amount") {
    p.amount = number<double>(spec, key, text, family.least, family.most);
    if (family.is_whole && p.amount != std::floor(p.amount))
      fail(spec, quoted(key) + " is " + quoted(text) + "; give an integer");
  } else {
    fail(spec, quoted(key) + " is not a key; known are size, seed, amount");
  }
}

// Removes the part before the next colon from `text`.
std::string_view next_field(std::string_view& text) {
  const std::size_t end = std::min(text.find(':'), text.size());
  const std::string_view field = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return field;
}

} // namespace

Mesh make(const std::string& spec) {
  std::string_view rest = spec;
  if (next_field(rest) != "stress")
    fail(spec, "not a stress spec; give stress:FAMILY[:key=value]...");
  const Family& family = family_of(spec, next_field(rest));
  Parameters p{family.size, family.is_random ? 1U : 0U, family.amount};
  std::string seen;
  while (!rest.empty()) {
    const std::string_view field = next_field(rest);
    const std::size_t equals = field.find('=');
    const std::string_view key = field.substr(0, equals);
    if (equals == std::string_view::npos)
      fail(spec, quoted(field) + " has no value; give key=value");
    if (seen.find(quoted(key)) != std::string::npos) fail(spec, quoted(key) + " is given twice");
    seen += quoted(key);
    set(p, spec, family, key, field.substr(equals + 1));
  }
  Mesh m = family.mesh(p);
  if (family.is_random || p.seed == 0) return m;
  const auto seed = static_cast<unsigned>(p.seed);
  const std::vector<std::uint32_t> order = meshes::permutation(m.points.size(), seed);
  return generators::to_mesh(
      meshes::permuted({std::move(m.points), std::move(m.faces)}, order, seed));
}

std::vector<std::string> standard_specs() {
  std::vector<std::string> specs;
  const auto add = [&specs](const std::string& start, std::initializer_list<const char*> amounts) {
    for (const char* const a : amounts) specs.push_back("stress:" + start + ":amount=" + a);
  };
  for (const char* const n : {"50", "100", "200"}) add("parabola:size=" + std::string(n), {"0.25"});
  add("parabola:size=100", {"1e-12", "0.9"});
  add("grid-plane", {"0", "0.5", "1", "5"});
  add("grid-plane:size=8000", {"0"});
  add("grid-plane:seed=1", {"3"});
  add("grid-cube", {"1", "2", "3.5"});
  add("grid-folded", {"0", "1", "3"});
  add("grid-cylinder", {"0", "3"});
  add("grid-cylinder:size=2000", {"5"});
  add("splits", {"0.5", "0.1", "0.01"});
  add("splits:size=4000:seed=2", {"0.1"});
  const auto down = {"1e-1", "1e-3", "1e-5", "1e-7", "1e-9", "1e-11", "1e-13", "1e-15"};
  add("needles", down);
  add("caps", down);
  add("ulps", {"1", "4", "1024"});
  add("ulps:size=8000:seed=2", {"1"});
  add("offset", {"1e3", "1e6", "1e9", "1e12", "1e15"});
  add("stretched", {"10", "100", "1e3", "1e6"});
  add("wound-sphere", {"2", "5", "10"});
  add("wound-torus", {"2", "5", "10"});
  add("wound-cylinder", {"2", "5", "10"});
  return specs;
}

} // namespace stress
