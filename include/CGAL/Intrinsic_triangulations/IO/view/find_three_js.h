// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_FIND_THREE_JS_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_FIND_THREE_JS_H

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace CGAL::Intrinsic_triangulations {

/// The scripts that pages contain.
struct Three_js {
  std::string three;              ///< text of three.js, revision 111 or near
  std::string trackball_controls; ///< text of its classic script `TrackballControls.js`
};

/*!
\brief finds three.js on this machine.
\param directory a directory with `three.min.js` or `build/three.min.js`, and with
  `TrackballControls.js` or `examples/js/controls/TrackballControls.js`; by default that of Debian's
  package libjs-three
\return the texts of both; empty ones if they are not there
*/
inline Three_js
find_three_js(const std::filesystem::path& directory = "/usr/share/javascript/three") {
  const auto text = [&](const std::filesystem::path& folder, const std::filesystem::path& name) {
    std::ifstream file(directory / name, std::ios::binary);
    if (!file) file = std::ifstream(directory / folder / name, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  return {text("build", "three.min.js"), text("examples/js/controls", "TrackballControls.js")};
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_VIEW_FIND_THREE_JS_H
