// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/distance/Distances.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

std::vector<std::vector<std::size_t>> equal_places(const std::vector<Place>& places) {
  std::map<std::tuple<std::uint32_t, std::uint32_t, std::array<double, 3>>,
           std::vector<std::size_t>>
      numbers;
  for (std::size_t i = 0; i < places.size(); ++i)
    numbers[{places[i].vertex, places[i].face, places[i].weights}].push_back(i);
  std::vector<std::vector<std::size_t>> result;
  for (auto& [place, members] : numbers) result.push_back(std::move(members));
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal
