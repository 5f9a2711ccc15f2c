// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/results/temporary_file.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

#include <fcntl.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

namespace rigor::results {
namespace {

[[noreturn]] void fail_with(int error) {
  throw DatabaseError(std::generic_category().message(error));
}

std::string followed(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_symlink(std::filesystem::symlink_status(path, error))) return path;
  const std::filesystem::path target = std::filesystem::weakly_canonical(path, error);
  return error ? path : target.string();
}

}  // namespace

Writer::TemporaryFile::TemporaryFile(const std::string& path)
    : target_(followed(path)), temporary_(target_ + ".XXXXXX") {
  std::error_code error;
  if (std::filesystem::exists(target_, error) && !std::filesystem::is_regular_file(target_, error))
    throw DatabaseError("is no regular file");
  const int file = ::mkstemp(temporary_.data());
  if (file < 0) fail_with(errno);
  const mode_t mask = ::umask(0);
  ::umask(mask);
  const bool failed = ::fchmod(file, 0666U & ~mask) != 0;
  const int number = errno;
  ::close(file);
  if (!failed) return;
  ::unlink(temporary_.c_str());
  fail_with(number);
}

Writer::TemporaryFile::~TemporaryFile() {
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void Writer::TemporaryFile::rename() {
  const int file = ::open(temporary_.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) fail_with(errno);
  const bool synced = ::fsync(file) == 0;
  const int error = errno;
  ::close(file);
  if (!synced) fail_with(error);
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail_with(errno);
  temporary_.clear();
}

}  // namespace rigor::results
