// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_SUPPORT_REPLACING_FILE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_SUPPORT_REPLACING_FILE_H

#include <CGAL/Intrinsic_triangulations/support/Invalid_input.h>

#include <concepts>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <stdexcept>
#include <string>
#include <system_error>

namespace CGAL::Intrinsic_triangulations {

/// Says that a file cannot be written, why, and what to do.
class File_error : public std::runtime_error {
public:
  /// \param path the file \param what what is wrong with it \param code what the system says, if
  /// anything
  File_error(const std::filesystem::path& path, const std::string& what, std::error_code code)
      : std::runtime_error(path.string() + ": the file " + what), path_(path), code_(code) {}

  /// returns the name of the file.
  const std::filesystem::path& path() const { return path_; }
  /// returns what the system says.
  std::error_code code() const { return code_; }

private:
  std::filesystem::path path_;
  std::error_code code_;
};

/*!
\brief writes a file completely, or leaves it unchanged if anything fails.

The data go to a temporary file in the same directory, which replaces the file on `commit()` and
keeps its permissions. The temporary file has no name, so that even a killed process leaves nothing.
If the file system does not support that, it has a name, and the destructor removes it. A read-only
file is not replaced. A symbolic link is followed. A path to something else than a regular file,
such as a pipe, is written directly.
*/
class Replacing_file {
public:
  /*!
  \brief opens a temporary file for writing.
  \param path the file to be replaced or created
  \throws File_error naming the file if that is not possible
  */
  explicit Replacing_file(const std::filesystem::path& path);
  Replacing_file(const Replacing_file&) = delete;
  Replacing_file& operator=(const Replacing_file&) = delete;
  /// removes the temporary file unless it was committed.
  ~Replacing_file();

  /// returns the stream to write to.
  std::ostream& stream() { return stream_; }
  /// returns the path of the temporary file; empty if it has no name.
  std::filesystem::path temporary() const {
    return has_name_ ? temporary_ : std::filesystem::path();
  }

  /*!
  \brief completes the file.
  \throws File_error naming the file if it could not be written completely
  */
  void commit();

private:
  [[noreturn]] void fail(const std::string& what, std::error_code code) const;
  void expect_writable(std::filesystem::perms permissions) const;
  bool open_unnamed();
  std::error_code give_name();
  std::filesystem::path written() const;

  int unnamed_ = -1;                               // descriptor of a file without a name
  std::filesystem::path given_, path_, temporary_; // given, without links, beside it
  bool replaces_ = false, has_name_ = false;
  std::ofstream stream_;
};

/*!
\brief writes a file completely, or leaves it unchanged if anything fails: see `Replacing_file`.
\param path the file
\param write a functor that writes to a stream
\throws Invalid_input naming the file if `write` throws it
\throws File_error naming the file if it cannot be written
*/
template <std::invocable<std::ostream&> Write>
void write_file(const std::filesystem::path& path, const Write& write) {
  Replacing_file file(path);
  try {
    write(file.stream());
  } catch (const Invalid_input& e) {
    throw Invalid_input(e.kind(), e.index(), path.string() + ": " + e.what());
  } catch (const std::runtime_error&) {
    throw File_error(path, "cannot be written completely; is the disk full?",
                     std::make_error_code(std::errc::no_space_on_device));
  }
  file.commit();
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_SUPPORT_REPLACING_FILE_H
