// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only.

/*!
\class RestorableCorrespondence Vertex_places.h <CGAL/Intrinsic_triangulations/correspondence/models/Vertex_places.h>
\cgalConcept

The concept `RestorableCorrespondence` describes an observer that can start from integer coordinates
in place of the input: triangulations that have it are read from files.

\cgalRefines{\ref ::IntrinsicCorrespondence}

\cgalHasModel{\itc{No_correspondence}\, and whatever derives from it\, \itc{Integer_coordinates}\,
\itc{Explicit_crossings}}

\cgalHeading{Which operation needs what}

| operation | needs |
|---|---|
| \itf{read_intrinsic_triangulation}, constructors of \itc{Intrinsic_triangulation} with coordinates | `restore`, which they call in place of `start` |

\cgalHeading{Invariants and complexity}

Those of \ref ::IntrinsicCorrespondence. The C++20 concept does not require the observer of moves;
the triangulation that owns the model does.
*/
class RestorableCorrespondence {
public:
  /*!
  \brief starts to observe `t`, whose edges run on the input as the coordinates say.
  \tparam Triangulation an `Intrinsic_triangulation`
  */
  template <class Triangulation>
  void restore(const Triangulation& t,
               const CGAL::Intrinsic_triangulations::Integer_coordinates& coordinates);
};
