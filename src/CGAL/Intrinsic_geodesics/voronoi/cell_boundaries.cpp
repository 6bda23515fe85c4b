// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_geodesics/distance/Corner_table.h>
#include <CGAL/Intrinsic_geodesics/distance/Distance_field.h>
#include <CGAL/Intrinsic_geodesics/voronoi/Face_divider.h>
#include <CGAL/Intrinsic_geodesics/voronoi/Weighted_site.h>
#include <CGAL/Intrinsic_geodesics/voronoi/cell_boundaries.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

namespace {

// Finds breaks on all edges, then divides the faces.
class Cell_finder {
public:
  Cell_finder(const Labelled_field& labelled, double tolerance, Cell_partition& out)
      : labelled_(labelled), field_(labelled.field), table_(field_.table), out_(out),
        divider_(labelled, tolerance, out), first_break_(table_.corners.size() + 1, 0) {}

  void run() {
    for (std::uint32_t side = 0; side < table_.corners.size(); ++side) {
      first_break_[side] = out_.breaks.size();
      if (is_first(side)) add_breaks(side);
    }
    first_break_.back() = out_.breaks.size();
    out_.nodes = static_cast<std::uint32_t>(out_.breaks.size());
    for (std::uint32_t face = 0; 3 * face < table_.corners.size(); ++face)
      if (table_.corners[3 * std::size_t{face}].origin != Gluing::none) divide(face);
  }

private:
  // Whether the breaks of the edge are stored with this of its sides.
  bool is_first(std::uint32_t side) const {
    const Face_corner& c = table_.corners[side];
    return c.origin != Gluing::none && (!c.has_one_neighbor() || side < c.opposite);
  }

  // Whether all that is seen on a side comes from the sources of one cell.
  bool has_one_label(std::uint32_t side) const {
    const std::uint32_t label = labelled_.label(table_.corners[side].origin);
    bool is_one = labelled_.label(table_.corners[Corner_table::next(side)].origin) == label;
    for (const std::uint32_t s : {side, table_.corners[side].opposite})
      field_.windows.for_each(s, [&](const Stored_windows::Record& w) {
        is_one = is_one && labelled_.label(w.source) == label;
      });
    return is_one;
  }

  // Labels begin and end with those of the ends of the side: so those around a face fit.
  void add_breaks(std::uint32_t side) {
    const Face_corner& c = table_.corners[side];
    constexpr double rounding = 1e-12; // of distances that are sums of up to 9000 lengths
    const bool is_border = !c.has_one_neighbor(); // or several faces go on
    if (!is_border && has_one_label(side)) return;
    const Plane_point from{0, 0}, to{c.length, 0};
    std::vector<Labelled_piece> pieces;
    if (is_border) {
      const auto turned = [&](Plane_point p) { return field_.turned_to(side - side % 3, p, side); };
      pieces = nearest_on_segment(sites_of_face(labelled_, side / 3), turned(from), turned(to),
                                  rounding * c.length);
    } else {
      pieces = nearest_on_segment(sites_of_edge(labelled_, side), from, to, rounding * c.length);
    }
    std::uint32_t label = labelled_.label(c.origin);
    const auto change_to = [&](std::uint32_t next, double parameter) {
      if (next != label) out_.breaks.push_back({side, parameter, label, next});
      label = next;
    };
    double begin = 0;
    for (const Labelled_piece& piece : pieces) {
      if (piece.label != Gluing::none) change_to(piece.label, begin / c.length);
      begin = piece.end;
    }
    change_to(labelled_.label(table_.corners[Corner_table::next(side)].origin), 1);
  }

  // Adds a side of a face with its breaks to the boundary of the face.
  void append_side(std::uint32_t side, Face_part& part) const {
    const Face_corner& c = table_.corners[side];
    const auto point = [&](double parameter) {
      return field_.turned_to(side - side % 3, {parameter * c.length, 0}, side);
    };
    part.push_back({point(0), labelled_.label(c.origin)});
    const bool is_own = is_first(side);
    const std::uint32_t stored = is_own ? side : c.opposite;
    const std::size_t begin = first_break_[stored], end = first_break_[stored + 1];
    for (std::size_t k = 0; k < end - begin; ++k) {
      const std::size_t i = is_own ? begin + k : end - 1 - k;
      const Side_break& b = out_.breaks[i];
      const double parameter = is_own ? b.parameter : 1 - b.parameter;
      part.push_back({point(parameter), is_own ? b.after : b.before, static_cast<std::uint32_t>(i),
                      side, parameter});
    }
  }

  void divide(std::uint32_t face) {
    Face_part part;
    for (std::uint32_t side = 3 * face; side < 3 * face + 3; ++side) append_side(side, part);
    divider_.divide(face, part);
  }

  const Labelled_field& labelled_;
  const Distance_field& field_;
  const Corner_table& table_;
  Cell_partition& out_;
  Face_divider divider_;
  std::vector<std::size_t> first_break_; // per side
};

// Follows pieces from node to node.
class Segment_joiner {
public:
  explicit Segment_joiner(const Cell_partition& partition)
      : segments_(partition.segments), at_(partition.nodes, {none, none}),
        is_end_(partition.nodes, 0), is_used_(segments_.size(), 0) {
    for (const Boundary_junction& j : partition.junctions) is_end_[j.node] = 1;
    for (std::uint32_t i = 0; i < segments_.size(); ++i)
      for (const std::uint32_t node : segments_[i].nodes) {
        auto& [first, second] = at_[node];
        (first == none ? first : second) = i;
      }
    for (std::uint32_t node = 0; node < partition.nodes; ++node)
      if (at_[node][1] == none) is_end_[node] = 1; // on the border
  }

  std::vector<Boundary_line> lines() {
    std::vector<Boundary_line> result;
    for (const bool is_closed : {false, true})
      for (std::uint32_t i = 0; i < segments_.size(); ++i)
        for (const std::size_t k : {0U, 1U})
          if (is_used_[i] == 0 && (is_closed || is_end_[segments_[i].nodes[k]] != 0))
            result.push_back({follow(i, k), is_closed});
    return result;
  }

private:
  static constexpr std::uint32_t none = Gluing::none;

  // The pieces from one on, which begins with its k-th node.
  std::vector<Boundary_segment> follow(std::uint32_t i, std::size_t k) {
    std::vector<Boundary_segment> line;
    while (i != none && is_used_[i] == 0) {
      is_used_[i] = 1;
      Boundary_segment s = segments_[i];
      if (k == 1) {
        std::swap(s.nodes[0], s.nodes[1]);
        std::swap(s.places[0], s.places[1]);
        std::swap(s.left, s.right);
      }
      line.push_back(s);
      const std::uint32_t node = s.nodes[1];
      if (is_end_[node] != 0) break;
      i = at_[node][0] == i ? at_[node][1] : at_[node][0];
      k = segments_[i].nodes[0] == node ? 0 : 1;
    }
    return line;
  }

  const std::vector<Boundary_segment>& segments_;
  std::vector<std::array<std::uint32_t, 2>> at_; // per node: pieces that begin or end there
  std::vector<char> is_end_;                     // per node
  std::vector<char> is_used_;                    // per piece
};

} // namespace

Cell_partition cell_boundaries(const Distance_field& field,
                               std::span<const std::uint32_t> cell_of_source, double tolerance) {
  Cell_partition result;
  for (const std::uint32_t cell : cell_of_source)
    if (cell >= result.areas.size()) result.areas.resize(cell + std::size_t{1}, 0);
  const Labelled_field labelled{field, cell_of_source};
  Cell_finder(labelled, tolerance, result).run();
  return result;
}

double default_cell_tolerance(const Corner_table& table) {
  constexpr double share = 1e-3; // documented; below a pixel if edges have fewer than a thousand
  double sum = 0;
  std::size_t sides = 0;
  for (const Face_corner& c : table.corners) {
    if (c.origin == Gluing::none) continue; // of a removed face
    sum += c.length;
    ++sides;
  }
  return share * sum / static_cast<double>(sides);
}

std::vector<Boundary_line> joined_lines(const Cell_partition& partition) {
  return Segment_joiner(partition).lines();
}

} // namespace CGAL::Intrinsic_triangulations::internal
