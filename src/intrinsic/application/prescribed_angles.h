// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_APPLICATION_PRESCRIBED_ANGLES_H
#define INTRINSIC_APPLICATION_PRESCRIBED_ANGLES_H

#include <CGAL/Intrinsic_conformal/angles/Prescribed_angles.h>

#include <cstddef>
#include <string>

namespace program {

/*!
\brief reads a file with the angle of each vertex on a line of its own: radians, a multiple of pi
such as `3/2pi`, or `free`.
\throws std::runtime_error naming file and line, or if there are more or fewer lines than vertices
*/
CGAL::Intrinsic_triangulations::Prescribed_angles read_angles(const std::string& path,
                                                              std::size_t vertices);

/*!
\brief reads a file with the number of a vertex and its angle on each line, and prescribes these.
\param angles all angles, of which it changes some
\throws std::runtime_error naming file and line
*/
void read_cones(const std::string& path, CGAL::Intrinsic_triangulations::Prescribed_angles& angles);

} // namespace program

#endif // INTRINSIC_APPLICATION_PRESCRIBED_ANGLES_H
