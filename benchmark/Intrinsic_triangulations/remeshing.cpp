// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// What is remeshing in space paid with, and intrinsic refinement not? The comparison of Fig. 27 of
// the course: CGAL's isotropic remeshing beside intrinsic Delaunay refinement, by vertices, angles,
// distance to the surface, and the error of a Poisson problem. Usage: remeshing [DIRECTORY
// [MODEL...]] > result.json

#include "benchmark_support.h"

#include <CGAL/Corresponding_triangulation.h>
#include <CGAL/Intrinsic_operators/operators/cotangent_laplacian.h>
#include <CGAL/Intrinsic_operators/operators/mass_matrix.h>
#include <CGAL/Intrinsic_operators/operators/transfer.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/delaunay/measure_quality.h>
#include <CGAL/Intrinsic_triangulations/retriangulation/refinement/delaunay_refine.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>

#include <Eigen/SparseCholesky>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

namespace IT = CGAL::Intrinsic_triangulations;
namespace PMP = CGAL::Polygon_mesh_processing;
using namespace IT::benchmark;

namespace {

using Robust_kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Robust_kernel::Point_3>;
using Tree = CGAL::AABB_tree<
    CGAL::AABB_traits<Robust_kernel, CGAL::AABB_face_graph_triangle_primitive<Mesh>>>;
using Matrix = Eigen::SparseMatrix<double>;

Mesh read(const std::string& directory, const std::string& name) {
  Mesh mesh;
  if (!PMP::IO::read_polygon_mesh(directory + "/" + name + ".off", mesh) ||
      !CGAL::is_triangle_mesh(mesh))
    throw std::runtime_error("cannot read " + name + " as a triangle mesh");
  return mesh;
}

Eigen::MatrixX3d coordinates(const Mesh& mesh) {
  Eigen::MatrixX3d result(mesh.number_of_vertices(), 3);
  Eigen::Index i = 0;
  for (const auto v : mesh.vertices()) {
    const auto& p = mesh.point(v);
    result.row(i++) << p.x(), p.y(), p.z();
  }
  return result;
}

// a smooth function in space, some waves over the mesh
Eigen::VectorXd right_side(const Eigen::MatrixX3d& points, double size) {
  const Eigen::ArrayX3d x = points.array() * (12 / size);
  return x.col(0).sin() * x.col(1).cos() + x.col(2).sin();
}

// (-Laplace + 144 / size^2) u = f: about as many waves in the operator as in the right side, no
// kernel
Eigen::VectorXd solve(const Matrix& laplacian, const Matrix& mass, const Eigen::VectorXd& f,
                      double size) {
  const Matrix a = laplacian + (144 / (size * size)) * mass;
  return Eigen::SimplicialLDLT<Matrix>(a).solve(mass * f);
}

template <class Triangulation>
Eigen::VectorXd solve(Triangulation& t, const Eigen::MatrixX3d& points, double size) {
  return solve(IT::cotangent_laplacian(t), IT::galerkin_mass_matrix(t),
               right_side(IT::copy_to_intrinsic(t, points), size), size);
}

double mean_edge(const Mesh& mesh) {
  double sum = 0;
  for (const auto e : mesh.edges()) sum += PMP::edge_length(mesh.halfedge(e), mesh);
  return sum / static_cast<double>(mesh.number_of_edges());
}

// One model with its reference: the solution on a fine refinement, at the vertices of the mesh.
class Model {
public:
  Model(const std::string& directory, const std::string& name)
      : mesh_(read(directory, name)), points_(coordinates(mesh_)),
        tree_(faces(mesh_).begin(), faces(mesh_).end(), mesh_),
        size_((points_.colwise().maxCoeff() - points_.colwise().minCoeff()).maxCoeff()) {
    IT::Corresponding_triangulation t(mesh_);
    IT::delaunay_refine(
        t, IT::parameters::minimum_angle(25).maximum_edge_length(std::min(size_ / 150, length(1))));
    reference_ = IT::copy_to_input(t, solve(t, points_, size_));
    weights_ = IT::lumped_mass_matrix(IT::Corresponding_triangulation(mesh_)).diagonal();
  }

  const Mesh& mesh() const { return mesh_; }
  double length(double factor) const { return factor * mean_edge(mesh_); }

  nlohmann::json refined(double edge) const {
    const Stopwatch watch;
    IT::Corresponding_triangulation t(mesh_);
    IT::delaunay_refine(t, IT::parameters::minimum_angle(25).maximum_edge_length(edge));
    const double milliseconds = watch.milliseconds();
    return {{"method", "refined"},
            {"vertices", t.number_of_vertices()},
            {"min_angle_deg", IT::measure_quality(t).minimum_angle},
            {"error", error(IT::copy_to_input(t, solve(t, points_, size_)))},
            {"hausdorff", 0},
            {"milliseconds", milliseconds}};
  }

  nlohmann::json remeshed(double edge) const {
    Mesh m = mesh_;
    const Stopwatch watch;
    PMP::isotropic_remeshing(
        faces(m), edge, m, PMP::parameters::number_of_iterations(5).number_of_relaxation_steps(3));
    m.collect_garbage();
    const double milliseconds = watch.milliseconds();
    IT::Corresponding_triangulation t(m);
    const double angle = IT::measure_quality(t).minimum_angle;
    const Eigen::VectorXd u = solve(t, coordinates(m), size_);
    return {{"method", "remeshed"},
            {"vertices", m.number_of_vertices()},
            {"min_angle_deg", angle},
            {"error", error(at_input_vertices(m, u))},
            {"hausdorff", distance_to_input(m) / size_},
            {"milliseconds", milliseconds}};
  }

private:
  // the solution on the remeshed surface at its points nearest to the vertices
  Eigen::VectorXd at_input_vertices(const Mesh& m, const Eigen::VectorXd& u) const {
    const Tree tree(faces(m).begin(), faces(m).end(), m);
    Eigen::VectorXd result(points_.rows());
    Eigen::Index i = 0;
    for (const auto v : mesh_.vertices()) {
      const auto [face, weights] = PMP::locate_with_AABB_tree(mesh_.point(v), tree, m);
      double sum = 0;
      auto h = m.halfedge(face);
      for (const double w : weights) {
        sum += w * u[static_cast<Eigen::Index>(m.source(h).idx())];
        h = m.next(h);
      }
      result[i++] = sum;
    }
    return result;
  }

  // between vertices and centroids of each and the other surface
  double distance_to_input(const Mesh& m) const {
    const Tree tree(faces(m).begin(), faces(m).end(), m);
    return std::sqrt(
        std::max(greatest_squared_distance(m, tree_), greatest_squared_distance(mesh_, tree)));
  }
  static double greatest_squared_distance(const Mesh& m, const Tree& tree) {
    double worst = 0;
    for (const auto v : m.vertices()) worst = std::max(worst, tree.squared_distance(m.point(v)));
    for (const auto f : m.faces()) {
      const auto h = m.halfedge(f);
      const auto c =
          CGAL::centroid(m.point(m.source(h)), m.point(m.target(h)), m.point(m.target(m.next(h))));
      worst = std::max(worst, tree.squared_distance(c));
    }
    return worst;
  }

  // in the L2 norm, relative
  double error(const Eigen::VectorXd& u) const {
    const Eigen::ArrayXd d = u - reference_;
    return std::sqrt((weights_.array() * d * d).sum() /
                     (weights_.array() * reference_.array().square()).sum());
  }

  Mesh mesh_;
  Eigen::MatrixX3d points_;
  Tree tree_;
  double size_;
  Eigen::VectorXd reference_, weights_;
};

} // namespace

int main(int argc, char* argv[]) try {
  const std::string directory = mesh_directory(argc, argv);
  std::vector<std::string> names(argv + std::min(argc, 2), argv + argc);
  if (names.empty()) names = {"anchor", "fandisk", "joint", "elephant", "pinion_small"};
  nlohmann::json result = nlohmann::json::array();
  for (const std::string& name : names) {
    const Model model(directory, name);
    nlohmann::json runs = nlohmann::json::array();
    for (const double factor : {2., 1., 0.5}) {
      runs.push_back(model.refined(model.length(factor)));
      runs.push_back(model.remeshed(model.length(factor)));
    }
    result.push_back(
        {{"mesh", name}, {"vertices", model.mesh().number_of_vertices()}, {"runs", runs}});
    std::cerr << result.back().dump(1) << '\n';
  }
  std::cout << result.dump(2) << '\n';
} catch (const std::exception& e) {
  std::cerr << e.what() << '\n';
  return 1;
}
