// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only: the place where the namespaces are documented.

/// The namespace of CGAL; the package lives in a namespace of its own inside it.
namespace CGAL {
/*!
\brief Everything in this package: triangulations of a surface that are given by edge lengths alone.

\ref page_reference lists its names by topic. The nested namespace `internal` holds what headers need of each other and may
change at any time.
*/
namespace Intrinsic_triangulations {}
} // namespace CGAL

/// Where CGAL's mesh interface, that of the Boost Graph Library, looks for free functions and traits: those of
/// `CGAL::Intrinsic_triangulations::Gluing_map`.
namespace boost {}
