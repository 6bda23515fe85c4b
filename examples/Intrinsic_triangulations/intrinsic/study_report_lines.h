// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef INTRINSIC_STUDY_REPORT_LINES_H
#define INTRINSIC_STUDY_REPORT_LINES_H

#include <nlohmann/json.hpp>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace program {

/// What a study found for one mesh and arithmetic. Values that make no sense for it are absent.
class Study_line {
public:
  /// takes a line. \throws std::invalid_argument if it has no mesh, arithmetic or status
  explicit Study_line(nlohmann::ordered_json json);

  /// returns a text; empty if there is none.
  std::string text(const char* key) const;
  /// returns a count; 0 if there is none.
  std::uint64_t count(const char* key) const;
  /// returns a number, if it is there and finite.
  std::optional<double> number(const char* key) const;
  /// returns a number in an object, if it is there and finite.
  std::optional<double> number(const char* object, const char* key) const;
  /// returns how many predicates so many bits have decided.
  std::map<unsigned, std::uint64_t> escalations() const;
  /// returns the time of building and flipping, if known.
  std::optional<double> seconds() const;
  /// returns how the job ended.
  std::string status() const { return text("status"); }
  /// tells whether the job has finished.
  bool is_done() const { return status() == "done"; }

private:
  nlohmann::ordered_json json_;
};

/// What a study found for one mesh.
struct Study_mesh {
  std::string name;
  std::string family;                      ///< `files`, or the family of a stress mesh
  std::map<std::string, Study_line> lines; ///< by arithmetic

  /// returns the line of an arithmetic, or null.
  const Study_line* line(const std::string& arithmetic) const;
  /// returns the line of an arithmetic if it has finished, or null.
  const Study_line* done(const std::string& arithmetic) const;
  /// returns the number of faces, or 0 if no line has it.
  std::uint64_t faces() const;
  /// returns `amount` of a stress spec, if it has one.
  std::optional<double> amount() const;
  /// returns the name without `amount`: meshes that share it differ in nothing else.
  std::string name_without_amount() const;
};

/*!
\brief holds the lines of a study, sorted: they come in the order in which jobs end.
*/
class Study_results {
public:
  /*!
  \brief sorts lines; of lines with the same mesh and arithmetic, the last counts.
  \throws std::invalid_argument if a line has no mesh, arithmetic or status
  */
  explicit Study_results(const std::vector<nlohmann::ordered_json>& lines);

  /// Meshes: files first, then by family, and by name.
  const std::vector<Study_mesh>& meshes() const { return meshes_; }
  /// Arithmetics that have lines, from the simplest to exact ones.
  const std::vector<std::string>& arithmetics() const { return arithmetics_; }
  /// tells whether an arithmetic has lines.
  bool has(const std::string& arithmetic) const;
  /// returns the part whose family is `files`, or the one whose family is not.
  Study_results only_files(bool files) const;

private:
  Study_results() = default;
  std::vector<Study_mesh> meshes_;
  std::vector<std::string> arithmetics_;
};

/// tells whether a name is that of an arithmetic whose predicates are certified.
bool is_certified(const std::string& arithmetic);
/// tells whether a name is that of an exact number type without filter and history of our own.
bool is_naive_exact(const std::string& arithmetic);

} // namespace program

#endif // INTRINSIC_STUDY_REPORT_LINES_H
