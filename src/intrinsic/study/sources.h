// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_STUDY_SOURCES_H
#define INTRINSIC_STUDY_SOURCES_H

#include <string>
#include <vector>

namespace CGAL::Intrinsic_triangulations {
struct Intrinsic_input;
}

namespace program {

/// A mesh of the study: a file, or one that a generator makes.
struct Study_source {
  std::string location; ///< path or spec
  /// name of the file without directory, and the surface if it is asked for; or spec
  std::string name;
  std::string family;   ///< `files`, or the generator
  std::string domain;   ///< the surface of a file, see `surface_options()`
};

/// returns the mesh of a location, with the named surface.
Study_source study_source(const std::string& location, const std::string& domain);

/*!
\brief lists the meshes of a corpus.
\param corpus mesh files, directories (their mesh files, sorted), specs of generators
  (`stress:FAMILY...`), or `stress` (the standard list of specs)
\param domain the surfaces of files, see `surface_options()`
\throws std::runtime_error naming what is missing, or two meshes of one name
\throws std::invalid_argument if a spec is wrong
*/
std::vector<Study_source> study_sources(const std::vector<std::string>& corpus,
                                        const std::string& domain);

/// reads or makes a mesh. \throws std::exception
CGAL::Intrinsic_triangulations::Intrinsic_input read_study_source(const Study_source& source);

} // namespace program

#endif // INTRINSIC_STUDY_SOURCES_H
