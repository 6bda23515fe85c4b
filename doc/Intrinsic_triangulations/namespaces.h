// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only: the place where the namespaces are documented.

/// The namespace of CGAL; the package lives in a namespace of its own inside it.
namespace CGAL {
/*!
\brief contains all of this package: triangulations of a surface, defined by edge lengths alone.

\ref page_reference lists its names by topic. The nested namespace `internal` is for the headers of
the package only, and may change at any time.
*/
namespace Intrinsic_triangulations {}
} // namespace CGAL

/// Where CGAL's mesh interface, that of the Boost Graph Library, looks for free functions and
/// traits: those of `CGAL::Intrinsic_triangulations::Gluing_map`.
namespace boost {}
