// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "atomic_file.h"

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <rigor/process/descriptor.h>

#include "command.h"

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
  const process::Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
  if (file.number() < 0) fail(path, errno);
  if (const int error = write_all(file.number(), bytes)) fail(path, error);
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
  const process::Descriptor file(::mkstemp(temporary.data()));
  if (file.number() < 0) fail(path, errno);
  int error = write_all(file.number(), bytes);
  keep_owner(file.number(), target);
  if (error == 0 && ::fchmod(file.number(), mode_for(target)) != 0) error = errno;
  if (error == 0 && ::rename(temporary.c_str(), target.c_str()) != 0) error = errno;
  if (error != 0) {
    ::unlink(temporary.c_str());
    fail(path, error);
  }
}

}  // namespace rigor::tool
