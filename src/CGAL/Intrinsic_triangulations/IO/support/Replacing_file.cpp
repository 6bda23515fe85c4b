// Copyright (c) 2026 The Intrinsic Triangulations authors
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Intrinsic_triangulations/IO/support/Replacing_file.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <system_error>

#ifdef __linux__
#include <fcntl.h>
#include <unistd.h>
#endif

namespace CGAL::Intrinsic_triangulations {

// What the system said last; streams say nothing else.
static std::error_code last_error() { return {errno, std::generic_category()}; }

Replacing_file::Replacing_file(const std::filesystem::path& path) : given_(path), path_(path) {
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
  if (!stream_)
    fail("cannot be opened for writing; check the directory and its permissions", last_error());
  if (replaces_) std::filesystem::permissions(written(), status.permissions(), ignored);
}

Replacing_file::~Replacing_file() {
  stream_.close();
  std::error_code ignored;
  if (has_name_) std::filesystem::remove(temporary_, ignored);
#ifdef O_TMPFILE
  if (unnamed_ >= 0) ::close(unnamed_);
#endif
}

void Replacing_file::commit() {
  errno = 0;
  stream_.close();
  if (!stream_) fail("cannot be written completely; is the disk full?", last_error());
  std::error_code error = give_name();
  if (has_name_) std::filesystem::rename(temporary_, path_, error);
  if (error) fail("cannot be replaced: " + error.message(), error);
  has_name_ = false;
}

void Replacing_file::fail(const std::string& what, std::error_code code) const {
  throw File_error(given_, what, code);
}

// Files without write permission are refused even if the user may write all files.
void Replacing_file::expect_writable(std::filesystem::perms permissions) const {
  using std::filesystem::perms;
  constexpr perms write = perms::owner_write | perms::group_write | perms::others_write;
  if ((permissions & write) == perms::none || !std::ofstream(path_, std::ios::app))
    fail("is read-only; remove it, or write to another",
         std::make_error_code(std::errc::permission_denied));
}

bool Replacing_file::open_unnamed() {
#ifdef O_TMPFILE
  const std::filesystem::path parent = path_.parent_path();
  unnamed_ = ::open(parent.empty() ? "." : parent.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0666);
  if (unnamed_ < 0) return false;
  stream_.open(written(), std::ios::binary);
  if (stream_.is_open()) return true;
  ::close(unnamed_); // the system does not show it
  unnamed_ = -1;
#endif
  return false;
}

std::error_code Replacing_file::give_name() {
  if (unnamed_ < 0) return {};
#ifdef O_TMPFILE
  // a name must be free to be given, so it cannot be that of the file to be replaced
  if (::linkat(AT_FDCWD, written().c_str(), AT_FDCWD, temporary_.c_str(), AT_SYMLINK_FOLLOW) != 0)
    return last_error();
#endif
  has_name_ = true;
  return {};
}

// Where the system shows the file that has no name.
std::filesystem::path Replacing_file::written() const {
  if (unnamed_ < 0) return temporary_;
  return "/proc/self/fd/" + std::to_string(unnamed_);
}

} // namespace CGAL::Intrinsic_triangulations
