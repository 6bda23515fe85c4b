// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/parametrization/pack_components.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace {

using Box = Eigen::AlignedBox2d;

// Where the lower left corner of each box is on the shelves.
std::vector<Eigen::Vector2d> places_on_shelves(const std::vector<Box>& boxes, double margin) {
  double area = 0, longest = 0, widest = 0;
  for (const Box& b : boxes) {
    area += b.volume();
    longest = std::max(longest, b.sizes().maxCoeff());
    widest = std::max(widest, b.sizes().x());
  }
  const double unit = std::max(std::sqrt(area), longest), gap = margin * (unit > 0 ? unit : 1);
  double with_gaps = 0;
  for (const Box& b : boxes) with_gaps += (b.sizes().x() + gap) * (b.sizes().y() + gap);
  const double width = std::max(widest, std::sqrt(with_gaps));
  std::vector<std::size_t> order(boxes.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return boxes[i].sizes().y() > boxes[j].sizes().y();
  });
  std::vector<Eigen::Vector2d> result(boxes.size());
  Eigen::Vector2d next(0, 0);
  double top = 0; // of the shelf
  for (const std::size_t i : order) {
    const Eigen::Vector2d size = boxes[i].sizes();
    if (next.x() > 0 && next.x() + size.x() > width) next = {0, top + gap};
    if (next.x() == 0) top = next.y() + size.y();
    result[i] = next;
    next.x() += size.x() + gap;
  }
  return result;
}

} // namespace

void pack_components(Eigen::MatrixX2d& uv, std::span<const std::uint32_t> component,
                     double margin) {
  if (component.size() != static_cast<std::size_t>(uv.rows()))
    throw Invalid_input(Element_kind::none, 0,
                        "there are " + std::to_string(component.size()) +
                            " numbers of components, but " + std::to_string(uv.rows()) +
                            " points; give one for each");
  std::map<std::uint32_t, std::size_t> number;
  std::vector<std::size_t> of_row(component.size());
  std::vector<Box> boxes;
  for (std::size_t r = 0; r < of_row.size(); ++r) {
    if (component[r] == Gluing::none) continue;
    const Eigen::Vector2d point = uv.row(static_cast<Eigen::Index>(r)).transpose();
    if (!point.allFinite())
      throw Invalid_input::about(Element_kind::vertex, r,
                                 " has coordinates that are not finite; leave it out");
    of_row[r] = number.insert({component[r], boxes.size()}).first->second;
    if (of_row[r] == boxes.size()) boxes.emplace_back();
    boxes[of_row[r]].extend(point);
  }
  if (boxes.size() < 2) return;
  const std::vector<Eigen::Vector2d> places = places_on_shelves(boxes, margin);
  for (std::size_t r = 0; r < of_row.size(); ++r)
    if (component[r] != Gluing::none)
      uv.row(static_cast<Eigen::Index>(r)) +=
          (places[of_row[r]] - boxes[of_row[r]].min()).transpose();
}

} // namespace CGAL::Intrinsic_triangulations
