// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_SIMPLIFIER_H
#define CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_SIMPLIFIER_H

#include <CGAL/Intrinsic_simplification/simplification/Candidates.h>
#include <CGAL/Intrinsic_simplification/simplification/Coarse_mesh.h>
#include <CGAL/Intrinsic_simplification/simplification/Coming_stars.h>
#include <CGAL/Intrinsic_simplification/simplification/Fine_surface.h>
#include <CGAL/Intrinsic_simplification/simplification/Removal_queue.h>
#include <CGAL/Intrinsic_simplification/simplification/Simplification.h>
#include <CGAL/Intrinsic_simplification/simplification/Star_removal.h>
#include <CGAL/Intrinsic_simplification/simplification/Vertex_star.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Removes vertices, one after another, the cheapest first. On a cover, the copies of a vertex are
// removed together: the first one stands for all in the queue.
class Simplifier {
public:
  // \param may_go nonzero for each vertex that may be removed; empty: all of them
  Simplifier(const Fine_surface& fine, const std::vector<char>& may_go,
             const Simplify_options& options, Asked_cost& cost);

  // Removes vertices until so many are left; goes on where it has stopped before.
  void run(std::size_t wanted);
  // Vertices with faces.
  std::size_t number_left() const { return number_left_; }

  // What has been found.
  Simplification take_result() const;

private:
  enum class Fate : std::uint8_t { open, removed, stays, blocked, failed, bound };
  struct Counts {
    std::size_t newton_steps = 0, ptolemy_flips = 0, flips = 0;
    double spread = 0; // the greatest one of the faces that have changed
  };

  struct Vertex {
    std::uint32_t first_copy = 0;
    std::uint32_t component = 0; // by its number
    std::uint32_t loop = 0;      // of the border, by its number
    Fate fate = Fate::open;
    bool is_on_border = false;
    bool is_alone = false;    // it has no other copies
    bool is_cost_old = false; // it is in the queue, and its star has changed
  };

  void find_copies();
  std::span<const std::uint32_t> copies(std::uint32_t v) const {
    if (vertices_[v].is_alone) return {&vertices_[v].first_copy, 1};
    const std::uint32_t row = fine_.row[mesh_.number(v)];
    return std::span(copies_).subspan(begin_[row], begin_[row + 1] - begin_[row]);
  }
  std::uint32_t first_copy(std::uint32_t v) const { return vertices_[v].first_copy; }
  void mark_kept(const std::vector<char>& may_go);
  void keep_copies();
  void count_components();
  static std::ptrdiff_t weight(const Vertex& v) { return v.is_on_border ? 1 : 2; }
  bool is_last(std::uint32_t v) const;
  void add_to_counts(std::uint32_t v, int sign);
  bool find_cost(std::uint32_t v, double& cost);
  void push(std::uint32_t v);
  Removal_entry pop();
  Fate remove(std::uint32_t v, double expected);
  Fate remove_copies(std::uint32_t v);
  Fate replace_star(std::uint32_t v);
  Fate flatten(std::uint32_t v);
  bool bend_straight_face(const Vertex_star::Bound& bound, bool grows);
  bool is_reached(const Vertex_star::Bound& bound, bool grows) const;
  double factor_within(const Vertex_star::Bound& bound, bool grows, double slope, double& rest);
  bool has_fixed_loop(std::uint32_t v) const;
  bool lower_degree(std::uint32_t v);
  bool lower_degree_in_two(std::uint32_t v);
  bool open_loops(std::uint32_t v);
  void restore_delaunay();
  bool is_within_bounds();
  void renew_costs();
  void write_surface(Simplification& s, const std::vector<std::uint32_t>& vertex,
                     const std::vector<std::uint32_t>& face) const;
  void write_places(Simplification& s, const std::vector<std::uint32_t>& vertex,
                    const std::vector<std::uint32_t>& face) const;

  const Fine_surface& fine_;
  const Simplify_options& options_;
  Coarse_mesh mesh_;
  std::vector<Vertex> vertices_;
  std::vector<std::uint32_t> copies_, begin_;         // vertices by rows, where each row begins
  std::vector<std::ptrdiff_t> weight_, least_weight_; // of the vertices of each component
  std::vector<std::size_t> left_on_loop_;             // vertices of each loop of the border
  Removal_queue queue_;
  Coming_stars coming_;
  Vertex_star star_, neighbour_;
  Star_removal removal_;
  Candidates candidates_;
  std::vector<std::uint32_t> stack_, touched_;
  std::size_t number_left_ = 0, number_removed_ = 0, number_tried_ = 0;
  Counts counts_, step_;
  unsigned most_newton_steps_ = 0;
  Status status_ = Status::done;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_SIMPLIFICATION_SIMPLIFICATION_SIMPLIFIER_H
