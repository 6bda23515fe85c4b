// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_SUPPORT_REPLACING_FILE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_SUPPORT_REPLACING_FILE_H

#include <filesystem>
#include <fstream>
#include <ostream>
#include <random>
#include <stdexcept>
#include <string>
#include <system_error>

namespace CGAL::Intrinsic_triangulations {

/*!
\brief writes a file so that it is complete or what it was before, whatever fails.

The data go to a temporary file in the same directory, which replaces the file on `commit()` and
which the destructor removes otherwise. A symbolic link is followed. A path to what is no regular
file, such as a pipe, is written directly.
*/
class Replacing_file {
public:
  /*!
  \brief opens a temporary file for writing.
  \param path the file to be replaced or created
  \throws std::runtime_error naming the file if that is not possible
  */
  explicit Replacing_file(const std::filesystem::path& path) : path_(path) {
    std::error_code ignored;
    if (std::filesystem::is_symlink(path, ignored)) {
      const std::filesystem::path target = std::filesystem::weakly_canonical(path, ignored);
      if (!ignored) path_ = target;
    }
    written_ = path_;
    is_temporary_ = !std::filesystem::exists(path_, ignored) ||
                    std::filesystem::is_regular_file(path_, ignored);
    if (is_temporary_)
      written_ += std::to_string(std::random_device()()).insert(0, 1, '.').append(".tmp");
    stream_.open(written_, std::ios::binary);
    if (!stream_) {
      is_temporary_ = false;
      fail("cannot be opened for writing; check the directory and its permissions");
    }
  }
  Replacing_file(const Replacing_file&) = delete;
  Replacing_file& operator=(const Replacing_file&) = delete;
  /// removes the temporary file unless it was committed.
  ~Replacing_file() {
    stream_.close();
    std::error_code ignored;
    if (is_temporary_) std::filesystem::remove(written_, ignored);
  }

  /// returns the stream to write to.
  std::ostream& stream() { return stream_; }
  /// returns the path of the temporary file; empty if there is none.
  std::filesystem::path temporary() const {
    return is_temporary_ ? written_ : std::filesystem::path();
  }

  /*!
  \brief completes the file.
  \throws std::runtime_error naming the file if it could not be written completely
  */
  void commit() {
    stream_.close();
    if (!stream_) fail("cannot be written completely; is the disk full?");
    if (!is_temporary_) return;
    std::error_code error;
    std::filesystem::rename(written_, path_, error);
    if (error) fail("cannot be replaced: " + error.message());
    is_temporary_ = false;
  }

private:
  [[noreturn]] void fail(const std::string& what) const {
    throw std::runtime_error(path_.string() + ": the file " + what);
  }

  std::filesystem::path path_, written_;
  bool is_temporary_ = false;
  std::ofstream stream_;
};

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_SUPPORT_REPLACING_FILE_H
