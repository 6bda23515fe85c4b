// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_conformal/layout/Glued_pieces.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing.h>
#include <CGAL/Intrinsic_triangulations/connectivity/Gluing_map.h>
#include <CGAL/Intrinsic_triangulations/connectivity/topology.h>
#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations::internal {

std::vector<std::uint32_t> Glued_pieces::piece_of_corner() const {
  std::vector<std::uint32_t> result(vertex.size());
  for (std::uint32_t i = 0; i < size(); ++i)
    std::fill(result.begin() + begin[i], result.begin() + begin[i + 1], i);
  return result;
}

Glued_pieces pieces_of(const Gluing& g) {
  Glued_pieces p;
  p.number_of_vertices = g.number_of_vertices;
  for (std::uint32_t f = 0; f < g.number_of_faces(); ++f) p.begin.push_back(3 * f + 3);
  p.vertex = g.origin;
  p.glue = g.glue;
  return p;
}

std::vector<std::uint32_t> border_from(const Glued_pieces& pieces) {
  std::vector<std::uint32_t> result(pieces.number_of_vertices, Gluing::none);
  for (std::uint32_t c = 0; c < pieces.glue.size(); ++c)
    if (pieces.glue[c] == Gluing::none) result[pieces.vertex[c]] = c;
  return result;
}

namespace {

class Seam_finder {
public:
  Seam_finder(const Glued_pieces& pieces, const std::vector<std::uint32_t>& partner,
              const std::vector<char>& is_cone)
      : pieces_(pieces), partner_(partner), is_cone_(is_cone), piece_(pieces.piece_of_corner()),
        border_from_(border_from(pieces)) {}

  std::vector<Border_seam> run() {
    std::vector<char> is_done(partner_.size(), 0);
    std::vector<Border_seam> result;
    for (const bool is_last : {false, true}) // closed seams have no first side
      for (std::uint32_t h = 0; h < partner_.size(); ++h) {
        if (partner_[h] == Gluing::none || is_done[h] != 0) continue;
        if (!is_last && continues(next_of_partner(h), h)) continue;
        Border_seam& seam = result.emplace_back();
        for (std::uint32_t i = h;;) {
          seam.sides.push_back(i);
          seam.partners.push_back(partner_[i]);
          is_done[i] = is_done[partner_[i]] = 1;
          const std::uint32_t n = next_on_border(i);
          if (!continues(i, n) || is_done[n] != 0) break;
          i = n;
        }
      }
    return result;
  }

private:
  std::uint32_t end(std::uint32_t h) const { return pieces_.vertex[pieces_.next(piece_[h], h)]; }
  std::uint32_t next_on_border(std::uint32_t h) const { return border_from_[end(h)]; }
  // the side before `h` in its seam, if there is one: its partner follows that of `h`
  std::uint32_t next_of_partner(std::uint32_t h) const {
    return partner_[next_on_border(partner_[h])];
  }
  // Whether two sides are of one seam: partners follow each other, too, and no cone is between.
  bool continues(std::uint32_t h, std::uint32_t n) const {
    return h != Gluing::none && n != Gluing::none && partner_[h] != Gluing::none &&
           partner_[n] != Gluing::none && n != partner_[h] && next_on_border(h) == n &&
           next_on_border(partner_[n]) == partner_[h] && is_cone_[end(h)] == 0;
  }

  const Glued_pieces& pieces_;
  const std::vector<std::uint32_t>& partner_;
  const std::vector<char>& is_cone_;
  std::vector<std::uint32_t> piece_, border_from_;
};

} // namespace

std::vector<Border_seam> find_seams(const Glued_pieces& pieces,
                                    const std::vector<std::uint32_t>& partner,
                                    const std::vector<char>& is_cone) {
  return Seam_finder(pieces, partner, is_cone).run();
}

std::vector<Border_seam> seams_of(const Opened_surface& s, const Glued_pieces& pieces,
                                  const std::vector<char>& is_cone) {
  std::vector<std::uint32_t> partner(pieces.vertex.size(), Gluing::none);
  for (const auto& [h, entry] : s.seams) {
    partner[h] = Gluing::partner(entry);
    partner[Gluing::partner(entry)] = h;
  }
  return find_seams(pieces, partner, is_cone);
}

std::vector<char> copies_of(const Opened_surface& s, std::span<const std::uint32_t> vertices) {
  std::vector<char> result(s.original_vertex.size(), 0);
  for (const std::uint32_t v : vertices) result[v] = 1;
  for (std::size_t v = 0; v < result.size(); ++v) result[v] = result[s.original_vertex[v]];
  return result;
}

void expect_oriented(const Gluing& g) {
  for (std::uint32_t h = 0; h < g.glue.size(); ++h)
    if (Gluing::is_reversed(g.glue[h])) fail_orientation(g, h, {});
}

void expect_closed(const Gluing& g, std::size_t handles, const std::string& name) {
  const auto fail = [&](const std::string& why) {
    throw Invalid_input(Element_kind::none, 0,
                        "only a connected closed surface of genus " + std::to_string(handles) +
                            " is a " + name + ", but " + why);
  };
  if (std::ranges::find(g.glue, Gluing::none) != g.glue.end())
    fail("the surface has a border; fill it, or lay it out in the plane");
  expect_oriented(g);
  const Gluing_map map = Gluing_map::from_valid(g);
  const std::uint32_t components = connected_components(map).count;
  if (components != 1)
    fail("there are " + std::to_string(components) + " components; take them one by one");
  const std::size_t found = *genus(map); // oriented: it has one
  if (found != handles)
    fail("the genus is " + std::to_string(found) + "; lay it out with cones in the plane");
}

} // namespace CGAL::Intrinsic_triangulations::internal
