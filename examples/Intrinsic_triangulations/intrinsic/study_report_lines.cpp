// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "study_report_lines.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <set>
#include <stdexcept>
#include <system_error>
#include <tuple>
#include <utility>

namespace program {

namespace {

using Json = nlohmann::ordered_json;

const char* const known_arithmetics[] = {
    "double",         "double-1e-12", "double-1e-6",  "double-1e-5", "long-double",
    "interval",       "boost-100",    "boost-200",    "gmpq",        "core-expr",
    "lazy-core-expr", "exact",        "exact-integer"};

const char* const amount_key = ":amount="; // in specs of stress meshes

// Unknown ones come last.
std::ptrdiff_t rank(const std::string& arithmetic) {
  return std::find(std::begin(known_arithmetics), std::end(known_arithmetics), arithmetic) -
         std::begin(known_arithmetics);
}

std::optional<double> finite_number(const Json& object, const char* key) {
  const auto i = object.find(key);
  if (i == object.end() || !i->is_number()) return std::nullopt;
  const double x = i->get<double>();
  return std::isfinite(x) ? std::optional<double>(x) : std::nullopt;
}

} // namespace

Study_line::Study_line(Json json) : json_(std::move(json)) {
  for (const char* const key : {"mesh", "arithmetic", "status"})
    if (text(key).empty())
      throw std::invalid_argument(std::string("a line of the study has no `") + key +
                                  "`: " + json_.dump().substr(0, 120) +
                                  "; give JSON lines that `intrinsic study` has written");
}

std::string Study_line::text(const char* key) const {
  const auto i = json_.find(key);
  return i != json_.end() && i->is_string() ? i->get<std::string>() : "";
}

std::uint64_t Study_line::count(const char* key) const {
  const auto i = json_.find(key);
  return i != json_.end() && i->is_number_integer() && *i >= 0 ? i->get<std::uint64_t>() : 0;
}

std::optional<double> Study_line::number(const char* key) const {
  return finite_number(json_, key);
}

std::optional<double> Study_line::number(const char* object, const char* key) const {
  const auto i = json_.find(object);
  return i == json_.end() ? std::nullopt : finite_number(*i, key);
}

std::map<unsigned, std::uint64_t> Study_line::escalations() const {
  std::map<unsigned, std::uint64_t> result;
  const auto all = json_.find("escalations");
  if (all == json_.end() || !all->is_object()) return result;
  for (const auto& [bits, n] : all->items()) {
    unsigned b = 0;
    std::from_chars(bits.data(), bits.data() + bits.size(), b);
    if (n.is_number_integer()) result[b] += n.get<std::uint64_t>();
  }
  return result;
}

std::optional<double> Study_line::seconds() const {
  const auto build = number("seconds", "build"), flip = number("seconds", "flip");
  if (!build || !flip) return std::nullopt;
  return *build + *flip;
}

const Study_line* Study_mesh::line(const std::string& arithmetic) const {
  const auto i = lines.find(arithmetic);
  return i == lines.end() ? nullptr : &i->second;
}

const Study_line* Study_mesh::done(const std::string& arithmetic) const {
  const Study_line* const l = line(arithmetic);
  return l != nullptr && l->is_done() ? l : nullptr;
}

std::uint64_t Study_mesh::faces() const {
  for (const auto& [arithmetic, l] : lines)
    if (const std::uint64_t n = l.count("faces"); n > 0) return n;
  return 0;
}

std::optional<double> Study_mesh::amount() const {
  const std::string key = amount_key;
  const std::size_t at = name.find(key);
  if (at == std::string::npos) return std::nullopt;
  double x = 0;
  const auto end = name.data() + name.size();
  const auto result = std::from_chars(name.data() + at + key.size(), end, x);
  return result.ec == std::errc() ? std::optional<double>(x) : std::nullopt;
}

std::string Study_mesh::name_without_amount() const {
  const std::size_t at = name.find(amount_key);
  if (at == std::string::npos) return name;
  return name.substr(0, at) + name.substr(std::min(name.size(), name.find(':', at + 1)));
}

Study_results::Study_results(const std::vector<Json>& lines) {
  std::map<std::string, Study_mesh> meshes;
  std::set<std::pair<std::ptrdiff_t, std::string>> arithmetics;
  for (const Json& json : lines) {
    Study_line line(json);
    const std::string name = line.text("mesh"), arithmetic = line.text("arithmetic");
    meshes[name].lines.insert_or_assign(arithmetic, std::move(line));
    arithmetics.emplace(rank(arithmetic), arithmetic);
  }
  for (auto& [name, mesh] : meshes) {
    mesh.name = name;
    mesh.family = mesh.lines.begin()->second.text("family");
    meshes_.push_back(std::move(mesh));
  }
  const auto key = [](const Study_mesh& m) {
    return std::make_tuple(m.family != "files", m.family, m.name);
  };
  std::sort(meshes_.begin(), meshes_.end(),
            [&key](const Study_mesh& a, const Study_mesh& b) { return key(a) < key(b); });
  for (const auto& [r, arithmetic] : arithmetics) arithmetics_.push_back(arithmetic);
}

bool Study_results::has(const std::string& arithmetic) const {
  return std::find(arithmetics_.begin(), arithmetics_.end(), arithmetic) != arithmetics_.end();
}

Study_results Study_results::only_files(bool files) const {
  Study_results result;
  result.arithmetics_ = arithmetics_;
  for (const Study_mesh& m : meshes_)
    if ((m.family == "files") == files) result.meshes_.push_back(m);
  return result;
}

bool is_certified(const std::string& arithmetic) {
  return arithmetic == "exact" || arithmetic == "exact-integer";
}

bool is_naive_exact(const std::string& arithmetic) {
  return arithmetic == "gmpq" || arithmetic == "core-expr" || arithmetic == "lazy-core-expr";
}

} // namespace program
