// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/input/Planar_polygons.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace CGAL::Intrinsic_triangulations {

std::size_t Planar_polygons::Polygon::corner(std::uint32_t vertex) const {
  const auto found =
      std::lower_bound(sorted.begin(), sorted.end(), vertex,
                       [this](std::uint32_t c, std::uint32_t v) { return vertices[c] < v; });
  return found != sorted.end() && vertices[*found] == vertex ? *found : sorted.size();
}

void Planar_polygons::add(std::uint32_t face, std::span<const std::uint32_t> vertices,
                          std::span<const Point> points) {
  face_.push_back(face);
  first_.push_back(vertices_.size());
  vertices_.insert(vertices_.end(), vertices.begin(), vertices.end());
  points_.insert(points_.end(), points.begin(), points.end());
  const std::size_t first = sorted_.size();
  for (std::uint32_t c = 0; c < vertices.size(); ++c) sorted_.push_back(c);
  std::sort(sorted_.begin() + static_cast<std::ptrdiff_t>(first), sorted_.end(),
            [&](std::uint32_t a, std::uint32_t b) { return vertices[a] < vertices[b]; });
}

Planar_polygons::Polygon Planar_polygons::operator()(std::uint32_t face) const {
  const auto found = std::lower_bound(face_.begin(), face_.end(), face);
  if (found == face_.end() || *found != face) return {};
  const auto i = static_cast<std::size_t>(found - face_.begin());
  const std::size_t count = (i + 1 < size() ? first_[i + 1] : vertices_.size()) - first_[i];
  return {{vertices_.data() + first_[i], count},
          {points_.data() + first_[i], count},
          {sorted_.data() + first_[i], count}};
}

} // namespace CGAL::Intrinsic_triangulations
