// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_INPUT_DEFINITION_OF_H
#define CGAL_INTRINSIC_TRIANGULATIONS_INPUT_DEFINITION_OF_H

#include <CGAL/Intrinsic_triangulations/input/Input.h>
#include <CGAL/Intrinsic_triangulations/input/Intrinsic_input.h>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief returns from what a surface was built, in the order of the user's vertices and faces, so that
another surface can be made of it: closed, or cut open.

    Domain closed = make_domain(sheet_of_cover(definition_of(t.input())), Domain_kind::closed);

\param surface the input of a triangulation
\return an input with the same connectivity, points or squared lengths in the units of the user, and
  mollification. On a cover, vertices and faces are those of the cover
\complexity linear
*/
Intrinsic_input definition_of(const Input& surface);

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_INPUT_DEFINITION_OF_H
