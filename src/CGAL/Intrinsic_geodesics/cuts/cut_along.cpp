// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_geodesics/cuts/Cut_surface.h>
#include <CGAL/Intrinsic_geodesics/cuts/Face_pieces.h>
#include <CGAL/Intrinsic_geodesics/cuts/cut_along.h>
#include <CGAL/Intrinsic_geodesics/cuts/cut_open.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/topology.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/input/position_on_face.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>
#include <CGAL/Intrinsic_triangulations/tracing/geodesic_face.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations {

namespace internal {
namespace {

// Divides the faces of the input along the marked edges of a common subdivision.
class Subdivision_cutter {
public:
  Subdivision_cutter(const Common_subdivision& s, const Input& input,
                     const std::vector<std::uint32_t>& label)
      : s_(s), input_(input), label_(label), is_needed_(s.number_of_vertices(), 0),
        number_(s.number_of_vertices(), none), edge_at_(s.number_of_vertices(), none),
        first_piece_(input.number_of_halfedges(), none) {}

  Cut_surface run() {
    mark_needed_vertices();
    number_vertices();
    collect_cells();
    for (std::uint32_t f = 0; f < input_.number_of_faces(); ++f)
      if (is_entered(f))
        divide(f);
      else
        keep(f);
    for (std::uint32_t e = 0; e < input_.number_of_edges(); ++e) glue_across(e);
    open();
    return std::move(result_);
  }

private:
  using Triangle = Face_pieces::Triangle;
  static constexpr std::uint32_t none = Gluing::none;

  bool is_of_input(std::uint32_t v) const { return s_.kind(v) == Subdivision_vertex_kind::input; }
  std::uint32_t curve(std::size_t corner) const {
    const std::uint32_t e = s_.side[corner].intrinsic_edge;
    return e < label_.size() ? label_[e] : 0;
  }
  std::uint32_t next_corner(std::size_t cell, std::uint32_t corner) const {
    return corner + 1 == s_.face_begin[cell + 1] ? s_.face_begin[cell] : corner + 1;
  }
  // the face and corners of a function of a cell's number and a corner
  template <class Function>
  void for_each_corner(std::span<const std::uint32_t> cells, const Function& f) const {
    for (const std::uint32_t cell : cells)
      for (std::uint32_t c = s_.face_begin[cell]; c < s_.face_begin[cell + 1]; ++c) f(cell, c);
  }

  // Vertices of the input stay, and those on curves.
  void mark_needed_vertices() {
    for (std::uint32_t v = 0; v < is_needed_.size(); ++v) is_needed_[v] = is_of_input(v) ? 1 : 0;
    for (std::uint32_t cell = 0; cell < s_.number_of_faces(); ++cell)
      for_each_corner(std::span(&cell, 1), [&](std::size_t, std::uint32_t c) {
        if (curve(c) == 0) return;
        is_needed_[s_.corner[c]] = 1;
        is_needed_[s_.corner[next_corner(cell, c)]] = 1;
      });
  }

  void number_vertices() {
    gluing_.number_of_vertices = s_.number_of_input_vertices;
    for (std::uint32_t v = 0; v < number_.size(); ++v)
      if (is_of_input(v))
        number_[v] = s_.vertices[v].intrinsic;
      else if (is_needed_[v] != 0)
        number_[v] = gluing_.number_of_vertices++;
  }

  // The cells in each face of the input.
  void collect_cells() {
    const auto face = [this](std::size_t cell) {
      return input_.face(s_.input_halfedge[s_.face_begin[cell]]);
    };
    first_cell_.assign(input_.number_of_faces() + std::size_t{1}, 0);
    for (std::size_t cell = 0; cell < s_.number_of_faces(); ++cell) ++first_cell_[face(cell) + 1];
    for (std::size_t f = 1; f < first_cell_.size(); ++f) first_cell_[f] += first_cell_[f - 1];
    cells_.resize(s_.number_of_faces());
    std::vector<std::uint32_t> end = first_cell_;
    for (std::uint32_t cell = 0; cell < cells_.size(); ++cell) cells_[end[face(cell)]++] = cell;
  }
  std::span<const std::uint32_t> cells(std::uint32_t f) const {
    return {cells_.data() + first_cell_[f], cells_.data() + first_cell_[f + 1]};
  }

  // Whether a vertex of a curve lies in a face or on its sides, besides its corners.
  bool is_entered(std::uint32_t f) const {
    bool found = false;
    for_each_corner(cells(f), [&](std::size_t, std::uint32_t c) {
      found = found || (is_needed_[s_.corner[c]] != 0 && !is_of_input(s_.corner[c]));
    });
    return found;
  }

  static unsigned place_among(const std::array<std::uint32_t, 3>& sides, std::uint32_t h) {
    return h == sides[0] ? 0 : h == sides[1] ? 1 : 2;
  }

  // Adds a triangle, and returns its first side.
  std::uint32_t add_triangle(std::uint32_t f, const Triangle& vertices,
                             const std::array<std::array<double, 3>, 3>& weights) {
    const auto side = static_cast<std::uint32_t>(gluing_.origin.size());
    gluing_.origin.insert(gluing_.origin.end(), vertices.begin(), vertices.end());
    gluing_.glue.resize(side + std::size_t{3}, none);
    next_piece_.resize(side + std::size_t{3}, none);
    result_.sides.resize(side + std::size_t{3});
    result_.weights.insert(result_.weights.end(), weights.begin(), weights.end());
    result_.input_triangle.push_back(input_.names().faces.user(f));
    result_.input_face.push_back(input_.names().polygon(f));
    return side;
  }

  // A face that no curve enters is a triangle; curves may run along its sides.
  void keep(std::uint32_t f) {
    const auto sides = sides_of_face(input_, input_.halfedge_of_face(f));
    Triangle vertices;
    for (std::size_t k = 0; k < 3; ++k) vertices[k] = input_.names().row(input_.source(sides[k]));
    const std::uint32_t first = add_triangle(f, vertices, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}});
    for (unsigned k = 0; k < 3; ++k) first_piece_[sides[k]] = first + k;
    for_each_corner(cells(f), [&](std::size_t, std::uint32_t c) {
      if (s_.side[c].input_edge != none && curve(c) != 0)
        result_.sides[first + place_among(sides, s_.input_halfedge[c])].curve = curve(c);
    });
  }

  // ---- One face that a curve enters ----

  // The number of the vertex at a corner among the pieces. At a corner of the face, or on a side, a
  // vertex may occur again at another one.
  std::uint32_t piece_vertex(std::uint32_t c) {
    const unsigned k = place_among(sides_, s_.input_halfedge[c]);
    const std::uint32_t v = s_.corner[c];
    const auto [found, is_new] = place_.try_emplace({v, k}, 0);
    if (!is_new) return found->second;
    Piece_vertex p;
    p.vertex = v;
    p.is_needed = is_needed_[v] != 0;
    p.weights = corner_in_input_face(input_, s_, sides_[0], c);
    p.place = layout_->position(p.weights);
    if (s_.kind(v) == Subdivision_vertex_kind::crossing) p.sides = 1U << k;
    if (is_of_input(v)) p.sides = (1U << k) | (1U << (k + 2) % 3);
    found->second = pieces_.add_vertex(p);
    if (is_of_input(v)) corners_[k] = found->second;
    return found->second;
  }

  // Puts the cells of a face into `pieces_`.
  void read_cells(std::uint32_t f) {
    sides_ = sides_of_face(input_, input_.halfedge_of_face(f));
    layout_.emplace(input_, sides_[0]);
    pieces_.clear();
    place_.clear();
    curve_of_.clear();
    std::vector<std::vector<std::uint32_t>> polygons;
    for (const std::uint32_t cell : cells(f)) {
      polygons.emplace_back();
      for (std::uint32_t c = s_.face_begin[cell]; c < s_.face_begin[cell + 1]; ++c)
        polygons.back().push_back(piece_vertex(c));
    }
    for_each_corner(cells(f), [&](std::size_t cell, std::uint32_t c) {
      const std::uint32_t p = piece_vertex(c), q = piece_vertex(next_corner(cell, c));
      if (curve(c) != 0) curve_of_[std::minmax(p, q)] = curve(c);
      if (s_.side[c].input_edge == none) return;
      for (const std::uint32_t end : {p, q}) { // inserted on the edge, too
        pieces_.vertex(end).sides |= 1U << place_among(sides_, s_.input_halfedge[c]);
        edge_at_[pieces_.vertex(end).vertex] = s_.side[c].input_edge;
      }
    });
    for (const std::vector<std::uint32_t>& polygon : polygons) pieces_.add_polygon(polygon);
  }

  using Side_map = std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t>;

  // Adds the triangles of a face, and returns the side from each vertex to each other one.
  Side_map add_pieces(std::uint32_t f) {
    Side_map side_from;
    pieces_.for_each_triangle([&](const Triangle& t) {
      Triangle vertices;
      std::array<std::array<double, 3>, 3> weights;
      for (std::size_t k = 0; k < 3; ++k) {
        vertices[k] = number_[pieces_.vertex(t[k]).vertex];
        weights[k] = pieces_.vertex(t[k]).weights;
      }
      const std::uint32_t first = add_triangle(f, vertices, weights);
      for (std::uint32_t k = 0; k < 3; ++k) {
        side_from[{t[k], t[(k + 1) % 3]}] = first + k;
        const auto curve = curve_of_.find(std::minmax(t[k], t[(k + 1) % 3]));
        if (curve != curve_of_.end()) result_.sides[first + k].curve = curve->second;
      }
    });
    return side_from;
  }

  void divide(std::uint32_t f) {
    read_cells(f);
    pieces_.remove_unneeded_vertices();
    const Side_map side_from = add_pieces(f);
    std::map<std::pair<unsigned, std::uint32_t>, std::pair<std::uint32_t, std::uint32_t>> border;
    for (const auto& [ends, side] : side_from) {
      const auto& [a, b] = ends;
      if (const auto other = side_from.find({b, a}); other != side_from.end()) {
        gluing_.glue[side] = other->second;
        continue;
      }
      const unsigned common = pieces_.vertex(a).sides & pieces_.vertex(b).sides;
      border[{common == 1 ? 0 : common == 2 ? 1 : 2, a}] = {side, b};
    }
    for (unsigned k = 0; k < 3; ++k) {
      std::uint32_t* last = &first_piece_[sides_[k]];
      for (std::uint32_t v = corners_[k]; v != corners_[(k + 1) % 3];) {
        const auto piece = border.find({k, v});
        if (piece == border.end())
          throw std::logic_error("the pieces of face " + std::to_string(f) +
                                 " of the input do not fit together");
        *last = piece->second.first;
        last = &next_piece_[*last];
        v = piece->second.second;
      }
    }
  }

  // ---- All faces ----

  std::vector<std::uint32_t> pieces_along(std::uint32_t h) const {
    std::vector<std::uint32_t> result;
    for (std::uint32_t side = first_piece_[h]; side != none; side = next_piece_[side])
      result.push_back(side);
    return result;
  }

  void glue_across(std::uint32_t e) {
    const std::vector<std::uint32_t> left = pieces_along(2 * e), right = pieces_along(2 * e + 1);
    const std::uint32_t name = input_.names().edges.user(e);
    for (const auto* const all : {&left, &right})
      for (const std::uint32_t side : *all) result_.sides[side].input_edge = name;
    if (left.empty() || right.empty()) return; // the border
    if (left.size() != right.size())
      throw std::logic_error("the pieces at edge " + std::to_string(e) +
                             " of the input do not fit together");
    for (std::size_t i = 0; i < left.size(); ++i) {
      const std::uint32_t other = right[right.size() - 1 - i];
      gluing_.glue[left[i]] = other;
      gluing_.glue[other] = left[i];
    }
  }

  Cut_surface::Vertex origin(std::uint32_t v) const {
    Cut_surface::Vertex r;
    r.on_input = s_.on_input(v);
    const bool is_crossing = s_.kind(v) == Subdivision_vertex_kind::crossing;
    const std::uint32_t e =
        is_crossing ? s_.crossings[v - s_.vertices.size()].on_input.edge : edge_at_[v];
    r.input_halfedge = is_crossing ? 2 * e : s_.vertices[v].input_halfedge;
    if (input_.is_border(r.input_halfedge)) r.input_halfedge ^= 1U;
    if (e != none) r.input_edge = input_.names().edges.user(e);
    if (r.input_edge == none) r.input_face = input_.names().polygon(input_.face(r.input_halfedge));
    return r;
  }

  void open() {
    std::vector<char> is_cut;
    for (const Cut_surface::Side& side : result_.sides) is_cut.push_back(side.curve != 0 ? 1 : 0);
    static_cast<Opened_surface&>(result_) = cut_open(gluing_, is_cut);
    for (std::uint32_t v = 0; v < s_.number_of_input_vertices; ++v) {
      result_.vertices.emplace_back();
      result_.vertices.back().input_vertex = v;
      result_.vertices.back().on_input = {1, {v, none, none}, {1, 0, 0}};
    }
    for (std::uint32_t v = 0; v < number_.size(); ++v)
      if (is_needed_[v] != 0 && !is_of_input(v)) result_.vertices.push_back(origin(v));
    for (std::size_t i = result_.vertices.size(); i < result_.original_vertex.size(); ++i)
      result_.vertices.push_back(Cut_surface::Vertex(result_.vertices[result_.original_vertex[i]]));
    Face_components all = connected_components(Gluing_map::from_valid(result_.gluing));
    result_.component = std::move(all.of_face);
    result_.number_of_components = all.count;
  }

  const Common_subdivision& s_;
  const Input& input_;
  const std::vector<std::uint32_t>& label_;
  std::vector<char> is_needed_;
  std::vector<std::uint32_t> number_;  // in the result, of each vertex of the subdivision
  std::vector<std::uint32_t> edge_at_; // edge of the input that an inserted vertex is on
  std::vector<std::uint32_t> first_cell_, cells_;
  // the pieces of each halfedge of the input, as lists of sides
  std::vector<std::uint32_t> first_piece_, next_piece_;
  Gluing gluing_;
  Cut_surface result_;
  // of the face that is being divided
  std::array<std::uint32_t, 3> sides_{};
  std::array<std::uint32_t, 3> corners_{};
  std::optional<Geodesic_face> layout_;
  Face_pieces pieces_;
  std::map<std::pair<std::uint32_t, unsigned>, std::uint32_t> place_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> curve_of_;
};

} // namespace

Cut_surface cut_subdivision(const Common_subdivision& s, const Input& input,
                            const std::vector<std::uint32_t>& label) {
  expect_one_sheet(input);
  return Subdivision_cutter(s, input, label).run();
}

} // namespace internal

void expect_one_sheet(const Input& surface) {
  if (!surface.names().is_cover()) return;
  throw Invalid_input(
      Element_kind::none, 0,
      surface.names().is_cloud()
          ? "a cloud of points has no faces that could be cut; start from a mesh"
          : "the surface is a cover of the faces, as they are no oriented manifold, and "
            "cannot be cut along curves; start from a mesh where each edge has one or two "
            "faces, and all faces are oriented alike");
}

std::vector<std::array<double, 3>> positions(const Cut_surface& s,
                                             std::span<const std::array<double, 3>> points) {
  std::vector<std::array<double, 3>> result;
  for (const Cut_surface::Vertex& v : s.vertices) result.push_back(position(v.on_input, points));
  return result;
}

std::vector<std::array<double, 3>>
positions(const Cut_surface& s, std::span<const std::array<double, 3>> points, const Input& input) {
  std::vector<std::array<double, 3>> result = positions(s, points);
  if (input.planar_polygons().empty()) return result;
  for (std::size_t i = 0; i < result.size(); ++i) {
    const Cut_surface::Vertex& v = s.vertices[i];
    if (v.input_vertex == Gluing::none)
      result[i] = internal::position_on_face(input, input.face(v.input_halfedge),
                                             std::span(v.on_input.vertices).first(v.on_input.size),
                                             v.on_input.weights,
                                             [&points](std::uint32_t u) { return points[u]; });
  }
  return result;
}

namespace {

void expect_cut_values(std::size_t given, std::size_t expected, const std::string& elements) {
  if (given != expected)
    throw Invalid_input(Element_kind::none, 0,
                        "there are " + std::to_string(given) +
                            " values; give one for each of the " + std::to_string(expected) + " " +
                            elements);
}

} // namespace

std::vector<double> values_at_vertices(const Cut_surface& s, std::span<const double> values) {
  std::size_t n = 0;
  while (n < s.vertices.size() && s.vertices[n].input_vertex == n) ++n;
  expect_cut_values(values.size(), n, "vertices of the mesh");
  std::vector<double> result;
  for (const Cut_surface::Vertex& v : s.vertices) {
    double sum = 0;
    for (std::size_t i = 0; i < v.on_input.size; ++i)
      sum += v.on_input.weights[i] * values[v.on_input.vertices[i]];
    result.push_back(sum);
  }
  return result;
}

std::vector<double> values_at_corners(const Cut_surface& s, std::span<const double> values) {
  const std::size_t n =
      s.input_triangle.empty() ? 0 : *std::ranges::max_element(s.input_triangle) + std::size_t{1};
  expect_cut_values(values.size(), 3 * n, "corners of triangles of the mesh");
  std::vector<double> result;
  for (std::size_t c = 0; c < s.weights.size(); ++c) {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k)
      sum += s.weights[c][k] * values[3 * std::size_t{s.input_triangle[c / 3]} + k];
    result.push_back(sum);
  }
  return result;
}

} // namespace CGAL::Intrinsic_triangulations
