// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_simplification/embedding/Metric_triangles.h>
#include <CGAL/Intrinsic_simplification/embedding/Precise_points.h>
#include <CGAL/Intrinsic_simplification/embedding/Whole_faces.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/support/cmath.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

// Splits triangles at points on them. A triangle knows the face of the polyhedron that it is on.
class Face_splitter {
public:
  Face_splitter(const Metric_triangles& t, Space_points& points,
                const std::vector<std::uint32_t>& left)
      : points_(points) {
    for (std::uint32_t f = 0; f < t.number_of_faces(); ++f) {
      parts_.push_back({f});
      face_of_part_.push_back(f);
      const auto corner = [&](std::uint32_t k) { return points[left[t.source(3 * f + k)]]; };
      normals_.push_back((corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized());
    }
    for (std::uint32_t h = 0; h < t.number_of_halfedges(); ++h) {
      origin_.push_back(left[t.source(h)]);
      glue_.push_back(t.opposite(h));
    }
  }

  // \param face the face of the polyhedron that the vertex is on
  void insert(std::uint32_t vertex, std::uint32_t face) {
    std::uint32_t best = Gluing::none; // the halfedge, across which the vertex is nearest
    double greatest = 0;
    for (const std::uint32_t part : parts_[face]) {
      const std::uint32_t nearest = nearest_side(part, vertex);
      const double height = height_over(nearest, vertex);
      if (best != Gluing::none && height <= greatest) continue;
      best = nearest;
      greatest = height;
      if (height > 0) break;
    }
    if (greatest <= 1e-9 * (end(best) - start(best)).norm())
      split_edge(best, vertex);
    else
      split_face(best / 3, vertex);
  }

  // Flips edges inside faces until they are Delaunay.
  void improve() {
    std::vector<std::uint32_t> queue;
    for (std::uint32_t h = 0; h < origin_.size(); ++h) queue.push_back(h);
    for (std::size_t left = 20 * queue.size(); !queue.empty() && left > 0; --left) {
      const std::uint32_t h = queue.back(), g = glue_[h];
      queue.pop_back();
      if (face_of_part_[h / 3] != face_of_part_[g / 3]) continue;
      if (angle_across(h) + angle_across(g) <= std::numbers::pi + 1e-9) continue;
      flip(h);
      for (const std::uint32_t n : {Gluing::next(h), Gluing::next(Gluing::next(h)), Gluing::next(g),
                                    Gluing::next(Gluing::next(g))})
        queue.push_back(n);
    }
  }

  std::vector<std::array<std::uint32_t, 3>> faces() const {
    std::vector<std::array<std::uint32_t, 3>> result;
    for (std::size_t h = 0; h < origin_.size(); h += 3)
      result.push_back({origin_[h], origin_[h + 1], origin_[h + 2]});
    return result;
  }

private:
  static std::uint32_t next(std::uint32_t h) { return Gluing::next(h); }
  static std::uint32_t previous(std::uint32_t h) { return next(next(h)); }
  const Eigen::Vector3d& start(std::uint32_t h) const { return points_[origin_[h]]; }
  const Eigen::Vector3d& end(std::uint32_t h) const { return points_[origin_[next(h)]]; }

  double height_over(std::uint32_t h, std::uint32_t vertex) const {
    const Eigen::Vector3d side = end(h) - start(h);
    return normals_[face_of_part_[h / 3]].dot(side.cross(points_[vertex] - start(h))) / side.norm();
  }
  std::uint32_t nearest_side(std::uint32_t part, std::uint32_t vertex) const {
    std::uint32_t best = 3 * part;
    for (std::uint32_t h = best + 1; h < 3 * part + 3; ++h)
      if (height_over(h, vertex) < height_over(best, vertex)) best = h;
    return best;
  }
  double angle_across(std::uint32_t h) const { // opposite h
    const Eigen::Vector3d &apex = start(previous(h)), a = start(h) - apex, b = end(h) - apex;
    return std::atan2(a.cross(b).norm(), a.dot(b));
  }

  void glue(std::uint32_t g, std::uint32_t h) {
    glue_[g] = h;
    glue_[h] = g;
  }
  // adds a part of the face of another part. \return its first halfedge
  std::uint32_t add_part(std::uint32_t beside, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const auto h = static_cast<std::uint32_t>(origin_.size());
    origin_.insert(origin_.end(), {a, b, c});
    glue_.resize(origin_.size(), Gluing::none);
    face_of_part_.push_back(face_of_part_[beside]);
    parts_[face_of_part_[beside]].push_back(h / 3);
    return h;
  }
  void split_face(std::uint32_t part, std::uint32_t p) {
    const std::uint32_t ij = 3 * part, jk = ij + 1, ki = ij + 2;
    const std::uint32_t i = origin_[ij], j = origin_[jk], k = origin_[ki];
    const std::uint32_t beyond_jk = glue_[jk], beyond_ki = glue_[ki];
    const std::uint32_t s = add_part(part, j, k, p), u = add_part(part, k, i, p);
    origin_[ki] = p;
    glue(s, beyond_jk == ki ? u : beyond_jk);
    if (beyond_jk != ki) glue(u, beyond_ki);
    glue(jk, s + 2);
    glue(s + 1, u + 2);
    glue(u + 1, ki);
  }
  void split_edge(std::uint32_t h, std::uint32_t p) {
    const std::uint32_t g = glue_[h], jk = next(h), im = next(g);
    const std::uint32_t j = origin_[jk], k = origin_[previous(h)], i = origin_[im],
                        m = origin_[previous(g)];
    const std::uint32_t beyond_jk = glue_[jk], beyond_im = glue_[im];
    const std::uint32_t s = add_part(h / 3, p, j, k), u = add_part(g / 3, p, i, m);
    origin_[jk] = p; // h = ip, then pk, ki
    origin_[im] = p; // g = jp, then pm, mj
    const auto moved = [&](std::uint32_t x) { return x == jk ? s + 1 : x == im ? u + 1 : x; };
    glue(s + 1, moved(beyond_jk));
    if (beyond_jk != im) glue(u + 1, moved(beyond_im));
    glue(jk, s + 2);
    glue(im, u + 2);
    glue(h, u);
    glue(g, s);
  }
  // turns ij between k and m to mk
  void flip(std::uint32_t h) {
    const std::uint32_t g = glue_[h], jk = next(h), im = next(g);
    const std::uint32_t k = origin_[previous(h)], m = origin_[previous(g)];
    const std::uint32_t beyond_jk = glue_[jk], beyond_im = glue_[im];
    // faces i m k at h, and j k m at g
    origin_[jk] = m;
    origin_[im] = k;
    glue(h, beyond_im);
    glue(g, beyond_jk);
    glue(jk, im);
  }

  Space_points& points_;
  std::vector<Eigen::Vector3d> normals_;          // of the faces of the polyhedron
  std::vector<std::vector<std::uint32_t>> parts_; // of each of them
  std::vector<std::uint32_t> face_of_part_;
  std::vector<std::uint32_t> origin_, glue_;
};

} // namespace

Whole_faces put_back(const Metric_triangles& t, const Space_points& points,
                     const std::vector<std::uint32_t>& left) {
  Whole_faces result;
  result.points.resize(points.size() + t.removed().size(), Eigen::Vector3d::Zero());
  for (std::size_t v = 0; v < left.size(); ++v) result.points[left[v]] = points[v];
  for (const Removed_vertex& r : t.removed())
    for (std::uint32_t k = 0; k < 3; ++k)
      result.points[r.vertex] += r.weights[k].to_double() * points[t.source(3 * r.face + k)];
  Face_splitter splitter(t, result.points, left);
  for (const Removed_vertex& r : t.removed()) splitter.insert(r.vertex, r.face);
  if (!t.removed().empty()) splitter.improve();
  result.faces = splitter.faces();
  return result;
}

} // namespace CGAL::Intrinsic_triangulations::internal
