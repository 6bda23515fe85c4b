// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Read by doxygen only: the place where the namespaces are documented.

/// The namespace of CGAL; the package lives in a namespace of its own inside it.
namespace CGAL {
/*!
\brief Everything in this package: triangulations of a surface that are given by edge lengths alone.

This page lists all names by kind. \ref page_reference lists them by topic, and is the place to start. The nested namespace
`internal` holds what headers need of each other and may change at any time. Concepts have two pages
each: their meaning is on that of the class with their name in the global namespace, which doxygen needs, their syntax on that of the
C++20 concept in this namespace.
*/
namespace Intrinsic_triangulations {}
} // namespace CGAL

/// Where CGAL's mesh interface, that of the Boost Graph Library, looks for free functions and traits: those of
/// `CGAL::Intrinsic_triangulations::Gluing_map`.
namespace boost {}
