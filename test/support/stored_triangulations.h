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

/// The error message of the reader for a file; empty if it accepts the file.
template <class Triangulation = Exact>
std::string message_of(const std::string& file) {
  try {
    from_text<Triangulation>(file);
  } catch (const IT::Invalid_input& e) {
    return e.what();
  }
  return "";
}

/// Expects equal lines, and shows the first ones that differ.
inline void expect_equal(const std::string& found, const std::string& expected) {
  std::istringstream a(found), b(expected);
  std::string x, y;
  for (int n = 1; found != expected; ++n) {
    const bool more = bool(std::getline(a, x)), also = bool(std::getline(b, y));
    if (more && also && x == y) continue;
    ADD_FAILURE() << "line " << n << ": " << (more ? x : "none")
                  << "\ninstead of: " << (also ? y : "none");
    return;
  }
}

/// The text without squared lengths and areas.
template <class Triangulation>
std::string text_without_values(const Triangulation& t) {
  std::istringstream all(text(t));
  std::string result, section;
  for (std::string line; std::getline(all, line);) {
    std::istringstream words(line);
    std::string word, first;
    while (words >> word) {
      if (first.empty()) first = word;
      if (section != "edges" && section != "faces")
        result += word + " ";
      else if (word.find("0x") == std::string::npos && word != "inf")
        result += word + " ";
    }
    if (first.find_first_not_of("abcdefghijklmnopqrstuvwxyz_") == std::string::npos &&
        first != "face" && first != "edge")
      section = first;
    result += "\n";
  }
  return result;
}

/// Expects equal connectivity and correspondence, and intervals that contain the same values.
template <class Triangulation>
void expect_same_but_for_widths(const Triangulation& a, const Triangulation& b) {
  expect_equal(text_without_values(a), text_without_values(b));
  const auto overlap = [](const auto& x, const auto& y) {
    return x.inf() <= y.sup() && y.inf() <= x.sup();
  };
  for (const auto e : edges(a.mesh())) {
    EXPECT_TRUE(
        overlap(a.metric().squared_length(a.index(e)), b.metric().squared_length(a.index(e))));
    EXPECT_NEAR(a.length(e), b.length(e), 1e-9 * a.length(e));
  }
  for (const auto f : faces(a.mesh()))
    EXPECT_TRUE(
        overlap(a.metric().quadruple_area(a.index(f)), b.metric().quadruple_area(a.index(f))));
}

inline std::string replaced(std::string s, const std::string& from, const std::string& to) {
  const std::size_t i = s.find(from);
  EXPECT_NE(i, std::string::npos) << from;
  return i == std::string::npos ? s : s.replace(i, from.size(), to);
}

} // namespace stored

#endif // TEST_INTRINSIC_TRIANGULATIONS_STORED_TRIANGULATIONS_H
