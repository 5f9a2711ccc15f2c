// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "output/atomic_file.h"

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "command/command.h"
#include <rigor/process/descriptor.h>


namespace rigor::tool {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& path, int error) {
  throw UsageError(path + ": cannot be written: " + std::generic_category().message(error));
}

/// Zero, or the error's number.
int write_all(int fd, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(fd, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return 0;
}

void write_directly(const std::string& path, std::string_view bytes) {
  process::Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
  if (file.number() < 0) fail(path, errno);
  if (const int error = write_all(file.number(), bytes)) fail(path, error);
  if (const int error = file.close()) fail(path, error);
}

/// Of the file that is there, or of a new one.
mode_t mode_for(const std::string& path) {
  struct stat status = {};
  if (::stat(path.c_str(), &status) == 0) return status.st_mode & 07777U;
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return 0666U & ~mask;
}

/// Where that is allowed: as root in a container, on somebody's folder.
void keep_owner(int file, const std::string& target) {
  struct stat status = {};
  if (::stat(target.c_str(), &status) != 0) return;
  if (::fchown(file, status.st_uid, status.st_gid) != 0) return;  // it is the caller's then
}

/// The name in the folder is on the disk only then. A folder that cannot be synchronized (no permission to read it,
/// a network's file system) is no failure: after a crash there is the old file or the new one, and both are whole.
void sync_folder_of(const std::string& path) {
  const fs::path parent = fs::path(path).parent_path();
  const std::string folder = parent.empty() ? "." : parent.string();
  const process::Descriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (opened.number() >= 0) ::fsync(opened.number());
}

}  // namespace

void replace_file(const std::string& path, std::string_view bytes) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (fs::is_directory(status)) fail(path, EISDIR);
  if (fs::exists(status) && !fs::is_regular_file(status)) return write_directly(path, bytes);

  const fs::path followed = fs::is_symlink(fs::symlink_status(path, ignored))
                                ? fs::weakly_canonical(path, ignored)
                                : fs::path(path);
  const std::string target = followed.empty() ? path : followed.string();
  std::string temporary = target + ".XXXXXX";
  process::Descriptor file(::mkstemp(temporary.data()));
  if (file.number() < 0) fail(path, errno);
  int error = write_all(file.number(), bytes);
  keep_owner(file.number(), target);
  if (error == 0 && ::fchmod(file.number(), mode_for(target)) != 0) error = errno;
  // The bytes are on the disk before the name is theirs: else a crash can leave an empty file in its place.
  if (error == 0 && ::fsync(file.number()) != 0) error = errno;
  if (const int closed = file.close(); error == 0) error = closed;
  if (error == 0 && ::rename(temporary.c_str(), target.c_str()) != 0) error = errno;
  if (error != 0) {
    ::unlink(temporary.c_str());
    fail(path, error);
  }
  sync_folder_of(target);
}

}  // namespace rigor::tool
