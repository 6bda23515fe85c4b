// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TEST_INTRINSIC_TRIANGULATIONS_STORED_TRIANGULATIONS_H
#define TEST_INTRINSIC_TRIANGULATIONS_STORED_TRIANGULATIONS_H

#include <CGAL/Intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/IO/idt/read_intrinsic_triangulation.h>
#include <CGAL/Intrinsic_triangulations/IO/idt/write_intrinsic_triangulation.h>

#include <boost/graph/graph_traits.hpp>

#include <gtest/gtest.h>

#include <sstream>
#include <string>
#include <vector>

// Intrinsic triangulations as text in the file format.

namespace stored {

namespace IT = CGAL::Intrinsic_triangulations;

using Exact = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Exact_euclidean_traits>;
using Double = IT::Intrinsic_triangulation<IT::Gluing_map, IT::Euclidean_traits<double>>;

template <class Triangulation>
std::string text(const Triangulation& t) {
  std::ostringstream out;
  IT::write_intrinsic_triangulation(out, t);
  return out.str();
}

template <class Triangulation>
Triangulation from_text(const std::string& s) {
  std::istringstream in(s);
  return IT::read_intrinsic_triangulation<Triangulation>(in, "file.idt");
}

/// The signs of all inner edges, in their order.
template <class Triangulation>
std::vector<CGAL::Sign> delaunay_signs(Triangulation& t) {
  const auto null = boost::graph_traits<typename Triangulation::Mesh>::null_face();
  std::vector<CGAL::Sign> signs;
  for (const auto e : edges(t.mesh())) {
    const auto h = halfedge(e, t.mesh());
    if (face(h, t.mesh()) != null && face(opposite(h, t.mesh()), t.mesh()) != null)
      signs.push_back(t.delaunay_sign(h));
  }
  return signs;
}

/// What the reader says about a file, nothing if it accepts it.
template <class Triangulation = Exact>
std::string message_of(const std::string& file) {
  try {
    from_text<Triangulation>(file);
  } catch (const IT::Invalid_input& e) {
    return e.what();
  }
  return "";
}

inline std::string replaced(std::string s, const std::string& from, const std::string& to) {
  const std::size_t i = s.find(from);
  EXPECT_NE(i, std::string::npos) << from;
  return i == std::string::npos ? s : s.replace(i, from.size(), to);
}

} // namespace stored

#endif // TEST_INTRINSIC_TRIANGULATIONS_STORED_TRIANGULATIONS_H
