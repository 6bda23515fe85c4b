// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sources.h"
#include "../support/file_formats.h"

#include <CGAL/Intrinsic_triangulations/IO/soup/read_surface.h>

#include <stress_families.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <stdexcept>
#include <utility>

namespace program {

namespace IT = CGAL::Intrinsic_triangulations;

namespace {

const std::string stress_prefix = "stress:";

bool is_stress_spec(const std::string& location) { return location.starts_with(stress_prefix); }

std::vector<std::string> mesh_files(const std::string& directory) {
  std::vector<std::string> paths;
  for (const auto& entry : std::filesystem::directory_iterator(directory))
    if (is_file_of(Contents::mesh, entry.path().string()) && entry.is_regular_file())
      paths.push_back(entry.path().string());
  std::sort(paths.begin(), paths.end());
  if (paths.empty()) throw std::runtime_error(directory + ": there are no mesh files in it");
  return paths;
}

std::vector<std::string> locations(const std::string& word) {
  if (word == "stress") return stress::standard_specs();
  if (is_stress_spec(word)) {
    stress::make(word); // throws if the spec is wrong
    return {word};
  }
  if (std::filesystem::is_directory(word)) return mesh_files(word);
  if (!std::filesystem::exists(word))
    throw std::runtime_error(word + ": there is no such file or directory; give meshes, "
                                    "directories of meshes, or stress");
  return {word};
}

} // namespace

Study_source study_source(const std::string& location, const std::string& domain) {
  if (!is_stress_spec(location)) {
    const std::string file = std::filesystem::path(location).filename().string();
    return {location, domain == "auto" ? file : file + " (" + domain + ')', "files", domain};
  }
  const std::size_t begin = stress_prefix.size();
  return {location, location, location.substr(begin, location.find(':', begin) - begin),
          "manifold"};
}

std::vector<Study_source> study_sources(const std::vector<std::string>& corpus,
                                        const std::string& domain) {
  std::vector<Study_source> sources;
  std::set<std::string> names;
  for (const std::string& word : corpus)
    for (const std::string& location : locations(word)) {
      Study_source source = study_source(location, domain);
      if (!names.insert(source.name).second)
        throw std::runtime_error(location + ": there is another mesh named " + source.name +
                                 "; names identify results, rename one");
      sources.push_back(std::move(source));
    }
  return sources;
}

IT::Intrinsic_input read_study_source(const Study_source& source) {
  if (is_stress_spec(source.location)) {
    stress::Mesh mesh = stress::make(source.location);
    const IT::Gluing gluing =
        IT::gluing_from_triangles(static_cast<std::uint32_t>(mesh.points.size()), mesh.faces);
    return {IT::Gluing_map(gluing), std::move(mesh.points)};
  }
  return IT::read_surface(source.location, IT::surface_options(source.domain)).input;
}

} // namespace program
