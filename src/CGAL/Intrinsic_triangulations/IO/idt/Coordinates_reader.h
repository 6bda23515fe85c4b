// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_COORDINATES_READER_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_COORDINATES_READER_H

#include <CGAL/Intrinsic_triangulations/IO/idt/Connectivity_reader.h>
#include <CGAL/Intrinsic_triangulations/IO/idt/Text_reader.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/adaptors/Mesh_adaptor.h>
#include <CGAL/Intrinsic_triangulations/connectivity/graph_traits_Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/correspondence/Intrinsic_view.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/Vertex_fans.h>
#include <CGAL/Intrinsic_triangulations/correspondence/curves/normal_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Diamond_unfolder.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/Integer_coordinates.h>
#include <CGAL/Intrinsic_triangulations/correspondence/models/check_curves.h>
#include <CGAL/Intrinsic_triangulations/exact/Input_face_intervals.h>
#include <CGAL/Intrinsic_triangulations/formulas/Diamond.h>
#include <CGAL/Intrinsic_triangulations/formulas/Vertex_star.h>
#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/metric/Enclosed_values.h>
#include <CGAL/Intrinsic_triangulations/metric/Exact_euclidean_traits.h>
#include <CGAL/Intrinsic_triangulations/triangulation/Surface_point.h>

#include <CGAL/Interval_nt.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

// Reads how a triangulation lies on its input.
class Coordinates_reader {
public:
  Coordinates_reader(Text_reader& in, std::shared_ptr<const Input> input)
      : in_(in), input_(std::move(input)), fans_(*input_) {}

  // the words of an edge after its value
  void read_edge() {
    const auto n = in_.integer<Normal_coordinate>("normal coordinate");
    if (n < -1 || n > maximal_normal_coordinate) in_.fail("the normal coordinate is out of range");
    normal_.push_back(n);
    for (int k = 0; k < 2; ++k) {
      const std::string_view x = in_.word();
      roundabout_.push_back(Gluing::none);
      if (x != "-" && (!parse_number(x, roundabout_.back()) || roundabout_.back() >= halfedges()))
        in_.fail("\"" + shown(x) + "\" is no halfedge of the input");
    }
  }

  // the places of inserted vertices
  Integer_coordinates run(const Gluing_map& mesh) {
    check_numbers(mesh);
    const std::uint32_t inserted = mesh.number_of_vertices() - input_->number_of_vertices();
    if (read_count(in_, "places", inserted) != inserted)
      in_.fail("every inserted vertex needs its place");
    in_.lines(inserted, [this](std::uint32_t) { read_place(); });
    for (std::uint32_t h = 0; h < roundabout_.size(); ++h) set_slot(mesh, h);
    return Integer_coordinates(input_, std::move(fans_), std::move(normal_), std::move(roundabout_),
                               std::move(location_));
  }

private:
  std::uint32_t halfedges() const { return input_->number_of_halfedges(); }

  void check_numbers(const Gluing_map& mesh) const {
    if (mesh.number_of_vertices() < input_->number_of_vertices())
      in_.fail("there are less vertices than in the input");
    const auto characteristic = [](const auto& surface) {
      return std::int64_t{surface.number_of_vertices()} - surface.number_of_edges() +
             surface.number_of_faces();
    };
    if (characteristic(mesh) != characteristic(*input_))
      in_.fail("the Euler characteristic is not that of the input");
  }

  void read_place() {
    const std::string_view kind = in_.word();
    const bool is_on_edge = kind == on_edge_name;
    if (!is_on_edge && kind != in_face_name)
      in_.fail("\"face\" or \"edge\" is expected, not \"" + shown(kind) + "\"");
    Surface_point p{in_.index(halfedges(), "halfedge of the input"), {0, 0, 0}};
    for (std::size_t k = 0; k < (is_on_edge ? 2U : 3U); ++k)
      in_.nonnegative(p.weights[k], "weight");
    if (input_->is_border(p.halfedge)) in_.fail("the halfedge has no face");
    if (representable_weights(p.weights) != p.weights)
      in_.fail("the weights are no multiples of 2^-52 that sum to 1, or all but one vanish");
    fan_.push_back(is_on_edge ? fans_.add_fan_on_edge(p.halfedge) : Gluing::none);
    location_.push_back(p);
  }

  // from the input halfedge along a curve to the number of its start
  void set_slot(const Gluing_map& mesh, std::uint32_t h) {
    std::uint32_t& x = roundabout_[h];
    const std::uint32_t v = mesh.source(Gluing_map::Halfedge{h}).index,
                        vertices = input_->number_of_vertices();
    std::uint32_t slot = Gluing::none;
    if (v < vertices) {
      if (x != Gluing::none && input_->source(x) == v) slot = fans_.slot(x);
    } else if (fan_[v - vertices] != Gluing::none && x != Gluing::none) {
      const std::uint32_t first = fan_[v - vertices];
      if (x / 2 == fans_.halfedge(first) / 2) slot = first + (x == fans_.halfedge(first) ? 0 : 1);
    } else if (fan_[v - vertices] == Gluing::none && x == Gluing::none)
      return;
    if (slot == Gluing::none)
      in_.fail("edge " + std::to_string(h / 2) + " names a halfedge of the input that does not " +
               "start from its vertex " + std::to_string(v));
    x = slot;
  }

  Text_reader& in_;
  std::shared_ptr<const Input> input_;
  Vertex_fans fans_;
  std::vector<Normal_coordinate> normal_;
  std::vector<std::uint32_t> roundabout_; // input halfedges at first
  std::vector<Surface_point> location_;
  std::vector<std::uint32_t> fan_; // first slot of each inserted vertex; none inside a face
};

// A gluing map without gaps, seen as a triangulation is.
class Numbered_mesh {
public:
  using Mesh = Gluing_map;
  using halfedge_descriptor = Gluing_map::Halfedge;
  using edge_descriptor = Gluing_map::Edge;
  using face_descriptor = Gluing_map::Face;

  explicit Numbered_mesh(const Gluing_map& mesh) : mesh_(mesh), number_(mesh) {}

  const Gluing_map& mesh() const { return mesh_; }
  const Mesh_adaptor<Gluing_map>& numbers() const { return number_; }
  template <class Descriptor>
  std::uint32_t index(Descriptor d) const {
    return d.index;
  }

private:
  const Gluing_map& mesh_;
  Mesh_adaptor<Gluing_map> number_;
};

// Checks that curves are those of the input's edges.
inline void check_curves(const Text_reader& in, const Numbered_mesh& t,
                         const Integer_coordinates& coordinates) {
  const std::uint32_t e = Curve_check(t, coordinates).first_bad_edge();
  if (e != Gluing::none)
    in.fail("the curves on edge " + std::to_string(e) + " are not those of the input's edges");
}

// Checks that stored intervals meet those of unfolded input faces. \pre curves are consistent
class Value_check {
  using FT = Interval_nt<false>;

public:
  Value_check(const Text_reader& in, const Numbered_mesh& t, const Integer_coordinates& coordinates)
      : in_(in), mesh_(t.mesh()), view_(t), coordinates_(coordinates) {}

  void run(const Enclosed_values& values) {
    const Exact_euclidean_metric::Scope scope;
    for (std::uint32_t f = 0; f < mesh_.number_of_faces(); ++f) {
      std::uint32_t h = view_.halfedge_of_face(f);
      const Diamond_values<FT> v =
          unfolder_.face(view_, coordinates_, h)
              .template values<FT>(intervals_.of(coordinates_.input().metric()));
      for (const FT& length : {v.ij, v.jk, v.ki}) {
        check("squared length of edge ", h / 2, values.squared_length(h / 2), length);
        h = view_.next(h);
      }
      check("area of face ", f, values.quadruple_area(f), v.area_f);
    }
  }

private:
  // both contain the exact value; bounds may be not a number
  void check(const std::string& what, std::uint32_t i, const FT& a, const FT& b) const {
    if (a.sup() < b.inf() || b.sup() < a.inf())
      in_.fail("the " + what + std::to_string(i) + " does not agree with the places of vertices");
  }

  const Text_reader& in_;
  const Gluing_map& mesh_;
  Intrinsic_view<Numbered_mesh> view_;
  const Integer_coordinates& coordinates_;
  Diamond_unfolder unfolder_;
  Input_face_intervals<FT> intervals_;
};

} // namespace CGAL::Intrinsic_triangulations::internal

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_IDT_COORDINATES_READER_H
