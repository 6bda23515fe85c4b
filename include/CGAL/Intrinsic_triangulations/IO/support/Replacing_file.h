// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_INTRINSIC_TRIANGULATIONS_IO_SUPPORT_REPLACING_FILE_H
#define CGAL_INTRINSIC_TRIANGULATIONS_IO_SUPPORT_REPLACING_FILE_H

#include <CGAL/Intrinsic_triangulations/connectivity/Invalid_input.h>

#include <cerrno>
#include <concepts>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <random>
#include <stdexcept>
#include <string>
#include <system_error>

#ifdef __linux__
#include <fcntl.h>
#include <unistd.h>
#endif

namespace CGAL::Intrinsic_triangulations {

/*!
\brief writes a file so that it is complete or what it was before, whatever fails.

The data go to a temporary file in the same directory, which replaces the file on `commit()` and keeps its
permissions. The temporary file has no name before, so that nothing is left even of a process that is killed; where
the file system does not offer that, it has one, and the destructor removes it. A file that may not be written is not
replaced. A symbolic link is followed. A path to what is no regular file, such as a pipe, is written directly.
*/
class Replacing_file {
public:
  /*!
  \brief opens a temporary file for writing.
  \param path the file to be replaced or created
  \throws std::runtime_error naming the file if that is not possible
  */
  explicit Replacing_file(const std::filesystem::path& path) : given_(path), path_(path) {
    std::error_code ignored;
    if (std::filesystem::is_symlink(path, ignored)) {
      const std::filesystem::path target = std::filesystem::weakly_canonical(path, ignored);
      if (!ignored) path_ = target;
    }
    const std::filesystem::file_status status = std::filesystem::status(path_, ignored);
    replaces_ = std::filesystem::is_regular_file(status);
    if (replaces_) expect_writable(status.permissions());
    temporary_ = path_;
    temporary_ += std::to_string(std::random_device()()).insert(0, 1, '.').append(".tmp");
    if (!replaces_ && std::filesystem::exists(status))
      stream_.open(path_, std::ios::binary);
    else if (!open_unnamed()) {
      stream_.open(temporary_, std::ios::binary);
      has_name_ = stream_.is_open();
    }
    if (!stream_) fail("cannot be opened for writing; check the directory and its permissions");
    if (replaces_) std::filesystem::permissions(written(), status.permissions(), ignored);
  }
  Replacing_file(const Replacing_file&) = delete;
  Replacing_file& operator=(const Replacing_file&) = delete;
  /// removes the temporary file unless it was committed.
  ~Replacing_file() {
    stream_.close();
    std::error_code ignored;
    if (has_name_) std::filesystem::remove(temporary_, ignored);
#ifdef O_TMPFILE
    if (unnamed_ >= 0) ::close(unnamed_);
#endif
  }

  /// returns the stream to write to.
  std::ostream& stream() { return stream_; }
  /// returns the path of the temporary file; empty if there is none that has a name.
  std::filesystem::path temporary() const {
    return has_name_ ? temporary_ : std::filesystem::path();
  }

  /*!
  \brief completes the file.
  \throws std::runtime_error naming the file if it could not be written completely
  */
  void commit() {
    stream_.close();
    if (!stream_) fail("cannot be written completely; is the disk full?");
    std::error_code error = give_name();
    if (has_name_) std::filesystem::rename(temporary_, path_, error);
    if (error) fail("cannot be replaced: " + error.message());
    has_name_ = false;
  }

private:
  [[noreturn]] void fail(const std::string& what) const {
    throw std::runtime_error(given_.string() + ": the file " + what);
  }

  // Whoever may do everything is refused files that nobody may write, too.
  void expect_writable(std::filesystem::perms permissions) const {
    using std::filesystem::perms;
    constexpr perms write = perms::owner_write | perms::group_write | perms::others_write;
    if ((permissions & write) == perms::none || !std::ofstream(path_, std::ios::app))
      fail("is read-only; remove it, or write to another");
  }

#ifdef O_TMPFILE
  bool open_unnamed() {
    const std::filesystem::path parent = path_.parent_path();
    unnamed_ = ::open(parent.empty() ? "." : parent.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0666);
    if (unnamed_ < 0) return false;
    stream_.open(written(), std::ios::binary);
    if (stream_.is_open()) return true;
    ::close(unnamed_); // the system does not show it
    unnamed_ = -1;
    return false;
  }
  std::error_code give_name() {
    if (unnamed_ < 0) return {};
    // a name must be free to be given, so that of a file to be replaced is not
    if (::linkat(AT_FDCWD, written().c_str(), AT_FDCWD, temporary_.c_str(), AT_SYMLINK_FOLLOW) != 0)
      return {errno, std::generic_category()};
    has_name_ = true;
    return {};
  }
  // where the system shows the file that has no name
  std::filesystem::path written() const {
    if (unnamed_ < 0) return temporary_;
    return "/proc/self/fd/" + std::to_string(unnamed_);
  }
  int unnamed_ = -1;
#else
  static bool open_unnamed() { return false; }
  static std::error_code give_name() { return {}; }
  const std::filesystem::path& written() const { return temporary_; }
#endif

  std::filesystem::path given_, path_, temporary_; // given, without links, beside it
  bool replaces_ = false, has_name_ = false;
  std::ofstream stream_;
};

/*!
\brief writes a file that is complete or what it was before, whatever fails: see `Replacing_file`.
\param path the file
\param write a functor that writes to a stream
\throws Invalid_input naming the file if `write` throws it
\throws std::runtime_error naming the file if it cannot be written
*/
template <std::invocable<std::ostream&> Write>
void write_file(const std::filesystem::path& path, const Write& write) {
  Replacing_file file(path);
  try {
    write(file.stream());
  } catch (const Invalid_input& e) {
    throw Invalid_input(e.kind(), e.index(), path.string() + ": " + e.what());
  } catch (const std::runtime_error&) {
    throw std::runtime_error(path.string() +
                             ": the file cannot be written completely; is the disk full?");
  }
  file.commit();
}

} // namespace CGAL::Intrinsic_triangulations

#endif // CGAL_INTRINSIC_TRIANGULATIONS_IO_SUPPORT_REPLACING_FILE_H
