// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "lines.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include <fcntl.h>
#include <unistd.h>

namespace program {

namespace {

// In the order that is documented.
constexpr std::array keys{"mesh",
                          "family",
                          "arithmetic",
                          "status",
                          "message",
                          "vertices",
                          "faces",
                          "flips",
                          "checks",
                          "refused_flips",
                          "filter_failures",
                          "escalations",
                          "integer",
                          "certified_zero",
                          "probable_zero",
                          "undecided",
                          "different_decisions",
                          "nonconvex_flips",
                          "inverted_faces",
                          "bent_edges",
                          "non_delaunay_edges",
                          "cocircular_edges",
                          "cycles",
                          "largest_interval_width",
                          "area_drift",
                          "cone_angle_drift",
                          "result",
                          "comparison",
                          "seconds",
                          "peak_rss_mib",
                          "limits",
                          "version",
                          "machine"};

bool is_result(const Json& line) {
  return line.is_object() && line.value("mesh", Json()).is_string() &&
         line.value("arithmetic", Json()).is_string() && line.value("status", Json()).is_string();
}

} // namespace

std::string study_line(const Json& findings) {
  Json ordered = Json::object();
  for (const char* key : keys)
    if (findings.contains(key)) ordered[key] = findings[key];
  for (const auto& [key, value] : findings.items())
    if (!ordered.contains(key)) ordered[key] = value;
  return ordered.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::vector<Json> read_study_lines(const std::string& path, std::size_t& complete) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error(path + ": cannot be read");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  complete = text.rfind('\n') + 1; // 0 if there is no line
  std::vector<Json> lines;
  for (std::size_t begin = 0, number = 1; begin < complete; ++number) {
    const std::size_t end = text.find('\n', begin);
    Json line = Json::parse(text.substr(begin, end - begin), nullptr, false);
    if (!is_result(line))
      throw std::runtime_error(path + ": line " + std::to_string(number) +
                               " is not a result of the study; remove it");
    lines.push_back(std::move(line));
    begin = end + 1;
  }
  return lines;
}

Study_file::Study_file(const std::string& path, std::size_t complete)
    : path_(path), file_(open(path.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0666)) {
  if (file_ < 0) fail("cannot be opened for writing");
  if (ftruncate(file_, static_cast<off_t>(complete)) != 0) fail("cannot be cut off");
}

Study_file::~Study_file() { close(file_); }

void Study_file::append(const std::string& line) {
  if (write(file_, line.data(), line.size()) != static_cast<ssize_t>(line.size()))
    fail("cannot be written");
}

void Study_file::fail(const char* what) const {
  throw std::runtime_error(path_ + ": " + what + ": " + std::strerror(errno));
}

} // namespace program
