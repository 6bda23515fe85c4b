// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "standard_input.h"
#include "output_files.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

#include <unistd.h>

namespace program {

namespace {

// Binary STL has no word to know it by, but its size follows from its number of triangles.
bool is_binary_stl(const std::string& data) {
  constexpr std::size_t head = 80, triangle = 50;
  std::uint32_t triangles = 0;
  if (data.size() < head + sizeof triangles) return false;
  std::memcpy(&triangles, data.data() + head, sizeof triangles);
  return data.size() == head + sizeof triangles + triangle * triangles;
}

// The first line that is neither empty nor a comment.
std::string first_line(const std::string& data) {
  std::istringstream lines(data.substr(0, 100'000));
  for (std::string line, word; std::getline(lines, line);)
    if (std::istringstream(line) >> word && word.front() != '#') return line;
  return {};
}

// An extension; empty if no format is known by this beginning.
std::string guessed_format(const std::string& data) {
  if (is_binary_stl(data)) return "stl";
  std::istringstream line(first_line(data));
  std::string word;
  line >> word;
  static constexpr std::array<std::pair<std::string_view, const char*>, 10> words{
      {{"IDT", "idt"},
       {"ply", "ply"},
       {"solid", "stl"},
       {"GOCAD", "ts"},
       {"v", "obj"},
       {"o", "obj"},
       {"g", "obj"},
       {"vn", "obj"},
       {"vt", "obj"},
       {"mtllib", "obj"}}};
  for (const auto& [begin, format] : words)
    if (word == begin) return format;
  if (word.ends_with("OFF")) return "off"; // with all its prefixes
  double x = 0, y = 0, z = 0;
  line = std::istringstream(first_line(data));
  return line >> x >> y >> z ? "xyz" : "";
}

} // namespace

Standard_input::Standard_input(const std::string& format) {
  std::string data(std::istreambuf_iterator<char>(std::cin), {});
  if (data.empty()) throw std::runtime_error("standard input is empty; pipe a mesh to it");
  const std::string extension = format.empty() ? guessed_format(data) : format;
  if (extension.empty())
    throw std::runtime_error("the format of standard input is unknown; name it with "
                             "--input-format, such as --input-format off");
  std::string name = (std::filesystem::temp_directory_path() / "intrinsic-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr)
    throw std::runtime_error(name + ": the folder cannot be made; name another one with TMPDIR");
  folder_ = name;
  path_ = (folder_ / ("standard-input." + extension)).string();
  remove_on_signals(path_);
  remove_on_signals(folder_.string());
  if (std::ofstream file(path_, std::ios::binary); !(file << data << std::flush)) {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
    throw std::runtime_error(path_ + ": the file cannot be written completely; is the disk full?");
  }
}

Standard_input::~Standard_input() {
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

} // namespace program
