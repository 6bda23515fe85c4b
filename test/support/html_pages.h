// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_TRIANGULATIONS_TEST_HTML_PAGES_H
#define INTRINSIC_TRIANGULATIONS_TEST_HTML_PAGES_H

#include "base64.h"

#include <CGAL/Intrinsic_triangulations/IO/view/write_html_view.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstring>
#include <string>
#include <vector>

/*!
\file
Pages for a browser, without its scripts, and what they contain.
*/

namespace html_pages {

/// returns a view with scripts that do nothing.
inline CGAL::Intrinsic_triangulations::Html_view simple_view() {
  CGAL::Intrinsic_triangulations::Html_view view;
  view.title = "A grid";
  view.three = "var THREE = {};";
  view.trackball_controls = "THREE.TrackballControls = null;";
  return view;
}

/// returns what stands between the tags of the data of a name.
inline std::string encoded(const std::string& html, const std::string& id) {
  const std::size_t tag = html.find(" id=\"" + id + "\"");
  EXPECT_NE(tag, std::string::npos) << id;
  const std::size_t begin = html.find('>', tag) + 1;
  return html.substr(begin, html.find('<', begin) - begin);
}

/// returns the numbers of the data of a name.
template <class T>
std::vector<T> numbers(const std::string& html, const std::string& id) {
  const std::string bytes = base64::decoded(encoded(html, id));
  EXPECT_EQ(bytes.size() % sizeof(T), 0u) << id;
  std::vector<T> result(bytes.size() / sizeof(T));
  if (!result.empty()) std::memcpy(result.data(), bytes.data(), bytes.size());
  return result;
}

} // namespace html_pages

#endif // INTRINSIC_TRIANGULATIONS_TEST_HTML_PAGES_H
