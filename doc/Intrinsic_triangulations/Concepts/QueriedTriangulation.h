// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only.

/*!
\class QueriedTriangulation CorrespondingTriangulation.h <CGAL/Intrinsic_triangulations/correspondence/queries/CorrespondingTriangulation.h>
\cgalConcept

The concept `QueriedTriangulation` has the requirements of \ref ::CorrespondingTriangulation, and no
others. For a triangulation without correspondence the compiler says first what to do. All queries
use it.

\cgalRefines{\ref ::CorrespondingTriangulation}

\cgalHasModel{\itc{Intrinsic_triangulation} with any correspondence but \itc{No_correspondence}}
*/
class QueriedTriangulation {};
