// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_operators/vectors/Point_cloud_vectors.h>
#include <CGAL/Intrinsic_operators/vectors/Vector_options.h>
#include <CGAL/Intrinsic_operators/vectors/Vectors.h>
#include <CGAL/Intrinsic_triangulations/correspondence/places/Place.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>

#include <Eigen/Core>

#include <complex>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

std::size_t point_of_cloud(const Place& p) {
  if (!p.is_vertex())
    throw Invalid_input(Element_kind::none, 0,
                        "a cloud of points has no faces; give the number of a point");
  return p.vertex;
}

std::vector<std::pair<std::size_t, std::complex<double>>>
in_planes_of_points(const Point_cloud_vectors& cloud, const Given_vectors& given) {
  std::vector<std::pair<std::size_t, std::complex<double>>> result;
  for (std::size_t i = 0; i < given.places.size(); ++i) {
    const std::size_t p = point_of_cloud(given.places[i]);
    std::complex<double> z = 0;
    if (!given.in_planes.empty())
      z = given.in_planes.at(i);
    else if (p < cloud.size()) {
      const auto v = Eigen::Vector3d::Map(given.in_space.at(i).data());
      const auto& [x, y] = cloud.axes(p);
      z = {Eigen::Vector3d::Map(x.data()).dot(v), Eigen::Vector3d::Map(y.data()).dot(v)};
    }
    result.push_back({p, z});
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal
