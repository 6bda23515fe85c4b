// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_APPLICATION_CUT_H
#define INTRINSIC_APPLICATION_CUT_H

#include "../constraints.h"
#include "../delaunay.h"
#include "../options.h"

#include <CGAL/Intrinsic_triangulations/IO/subdivision/Subdivision_field.h>
#include <CGAL/Intrinsic_triangulations/correspondence/subdivision/Common_subdivision.h>

#include <cstdint>
#include <vector>

namespace program {

/// takes the triangles of a file in place of a cover of them; they need not be orientable.
void take_sheet(IT::Read_surface& file);

/*!
\brief cuts a mesh open to disks, as `--cut` says, and edges that are kept with it.

Disks stay as they are. A cloud of points is not cut.
\param file becomes the surface that is cut open
\param constraints edges of it
\param options says how
\return what was cut
\pre there is no cover, see `take_sheet()`
\throws std::runtime_error if edges of a file do not cut the mesh to disks
*/
Cut cut_to_disk(IT::Read_surface& file, Constraints& constraints, const Options& options);

/// makes of numbers at the vertices of a common subdivision numbers at the corners of its faces.
void take_to_corners(const IT::Common_subdivision& s, std::vector<IT::Subdivision_field>& fields);

/*!
\brief glues the faces that are drawn together where they were cut open: there is one vertex for all
copies of a vertex of the file.
\param drawn the faces; vertices and faces of the input have the numbers of the file afterwards
\param fields numbers at vertices become numbers at corners
\param cut what was cut
*/
void close_seams(Drawn_subdivision& drawn, std::vector<IT::Subdivision_field>& fields,
                 const Cut& cut);

} // namespace program

#endif // INTRINSIC_APPLICATION_CUT_H
