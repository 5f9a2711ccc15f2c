// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "output/atomic_file.h"

#include <cerrno>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <random>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <rigor/process/descriptor.h>
#include <rigor/text/path.h>
#include <rigor/text/write_all.h>
#include "command/command.h"

namespace rigor::tool {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& path, int error) {
  throw UsageError(path + ": cannot be written: " + std::generic_category().message(error));
}

void write_directly(const std::string& path, std::string_view bytes) {
  process::Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
  if (file.number() < 0) fail(path, errno);
  if (const int error = write_all(file.number(), bytes)) fail(path, error);
  if (const int error = file.close()) fail(path, error);
}

[[noreturn]] void refuse_way(const std::string& path, std::string_view why) {
  throw UsageError(path + ": " + std::string(why) +
                   ", and is not written, as no argument names it");
}

/// May it be read or not: it is enough that it can be entered.
process::Descriptor open_folder(const std::string& folder, const std::string& path) {
  process::Descriptor opened(
      ::open(folder.empty() ? "." : folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
  if (opened.number() < 0) fail(path, errno);
  return opened;
}

/// A folder in an open folder, made where there is none.
process::Descriptor open_below(const process::Descriptor& above, const std::string& name,
                               const std::string& path) {
  if (::mkdirat(above.number(), name.c_str(), 0777) != 0 && errno != EEXIST) fail(path, errno);
  process::Descriptor folder(
      ::openat(above.number(), name.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
  if (folder.number() >= 0) return folder;
  const int error = errno;
  struct stat status = {};
  const bool link = ::fstatat(above.number(), name.c_str(), &status, AT_SYMLINK_NOFOLLOW) == 0 &&
                    S_ISLNK(status.st_mode);
  if (link) refuse_way(path, "is a link");
  throw UsageError(path + ": cannot be created: " + std::generic_category().message(error));
}

/// Mode and owner for what takes the place of a name in an open folder. Where the owner may not be kept, it is the
/// caller's then.
void take_after(int file, const process::Descriptor& folder, const std::string& name,
                const std::string& path) {
  struct stat status = {};
  if (::fstatat(folder.number(), name.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0) return;
  if (S_ISLNK(status.st_mode)) refuse_way(path, "is a link");
  if (S_ISDIR(status.st_mode)) fail(path, EISDIR);
  if (!S_ISREG(status.st_mode)) refuse_way(path, "is no regular file");
  if ((status.st_mode & 0222U) == 0) throw UsageError(path + ": is read-only, and is not written");
  [[maybe_unused]] const int owned = ::fchown(file, status.st_uid, status.st_gid);
  if (::fchmod(file, status.st_mode & 07777U) != 0) fail(path, errno);
}

/// The name in the folder is on the disk only then. A folder that cannot be synchronized (no permission to read it,
/// a network's file system) is no failure: after a crash there is the old file or the new one, and both are whole.
void sync(const process::Descriptor& folder) {
  const process::Descriptor opened(
      ::openat(folder.number(), ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (opened.number() >= 0) ::fsync(opened.number());
}

/// Bytes that are to be a file's, which is as it was unless `commit` is called.
class StagedFile {
 public:
  virtual ~StagedFile() = default;
  virtual void commit() = 0;
};

/// A new file beside the name that it is to get in an open folder, gone unless it gets that.
class StagedBeside final : public StagedFile {
 public:
  StagedBeside(process::Descriptor folder, std::string name, std::string path,
               std::string_view bytes)
      : folder_(std::move(folder)), name_(std::move(name)), path_(std::move(path)) {
    process::Descriptor file = create_temporary();
    try {
      fill(file, bytes);
    } catch (...) {
      remove_temporary();
      throw;
    }
  }
  ~StagedBeside() override {
    if (!temporary_.empty()) remove_temporary();
  }
  StagedBeside(const StagedBeside&) = delete;
  StagedBeside& operator=(const StagedBeside&) = delete;

  void commit() override {
    if (::renameat(folder_.number(), temporary_.c_str(), folder_.number(), name_.c_str()) != 0)
      fail(path_, errno);
    temporary_.clear();
    sync(folder_);
  }

 private:
  /// A run that was killed leaves its own behind: of that another name is taken.
  process::Descriptor create_temporary() {
    constexpr int kAttempts = 100;
    std::random_device random;
    for (int i = 0; i < kAttempts; ++i) {
      temporary_ = name_ + '.' + std::to_string(random()) + ".new";
      process::Descriptor file(::openat(folder_.number(), temporary_.c_str(),
                                        O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC,
                                        0666));
      if (file.number() >= 0) return file;
      if (errno != EEXIST) break;
    }
    fail(path_, errno);
  }

  void remove_temporary() const { ::unlinkat(folder_.number(), temporary_.c_str(), 0); }

  void fill(process::Descriptor& file, std::string_view bytes) const {
    if (const int error = write_all(file.number(), bytes)) fail(path_, error);
    take_after(file.number(), folder_, name_, path_);
    // The bytes are on the disk before the name is theirs: else a crash can leave an empty file in its place.
    if (::fsync(file.number()) != 0) fail(path_, errno);
    if (const int error = file.close()) fail(path_, error);
  }

  process::Descriptor folder_;
  std::string name_;
  std::string path_;
  std::string temporary_;
};

/// What no regular file is takes its bytes as they come.
class StagedDirectly final : public StagedFile {
 public:
  StagedDirectly(std::string path, std::string_view bytes)
      : path_(std::move(path)), bytes_(bytes) {}
  void commit() override { write_directly(path_, bytes_); }

 private:
  std::string path_;
  std::string bytes_;
};

std::unique_ptr<StagedFile> staged_below(const std::string& folder, std::string_view name,
                                         std::string_view bytes) {
  const std::string below = normalize_path(name);
  const std::string whole = join_path(folder, below);
  if (is_absolute(below) || below == "." || below == ".." || below.starts_with("../")) {
    throw UsageError(std::string(name) + ": lies outside of " + folder + ", and is not written");
  }
  process::Descriptor at = open_folder(folder, whole);
  std::size_t begin = 0;
  for (std::size_t slash = 0; (slash = below.find('/', begin)) != std::string::npos;) {
    at = open_below(at, below.substr(begin, slash - begin),
                    join_path(folder, below.substr(0, slash)));
    begin = slash + 1;
  }
  return std::make_unique<StagedBeside>(std::move(at), below.substr(begin), whole, bytes);
}

std::unique_ptr<StagedFile> staged_file(const std::string& path, std::string_view bytes) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (fs::is_directory(status)) fail(path, EISDIR);
  if (fs::exists(status) && !fs::is_regular_file(status))
    return std::make_unique<StagedDirectly>(path, bytes);
  fs::path target = path;
  if (fs::is_symlink(fs::symlink_status(path, ignored)))
    target = fs::weakly_canonical(path, ignored);
  if (!target.has_filename()) target = path;
  return std::make_unique<StagedBeside>(open_folder(target.parent_path().string(), path),
                                        target.filename().string(), path, bytes);
}

std::unique_ptr<StagedFile> staged_found(const std::vector<std::string>& named,
                                         const std::string& path, std::string_view bytes) {
  const std::string whole = normalize_path(path);
  std::string best;
  for (const std::string& each : named) {
    if (normalize_path(each) == whole) return staged_file(path, bytes);
    std::error_code ignored;
    std::string folder = fs::is_directory(each, ignored) ? each : std::string(parent_path(each));
    const std::string below = relative_path(folder, whole);
    if (!is_absolute(below) && !below.starts_with("../")) {
      return staged_below(folder, below, bytes);
    }
    if (best.empty()) best = std::move(folder);
  }
  return staged_below(best, relative_path(best, whole), bytes);
}

/// What could not be done, for the message: nothing is left to try.
std::string restored(const std::vector<std::string>& named, const FileReplacement& file) {
  try {
    staged_found(named, file.path, file.before)->commit();
    return {};
  } catch (const UsageError& error) {
    return std::string("; changed, and not restored: ") + error.what();
  }
}

}  // namespace

void put_file(const std::string& folder, std::string_view name, std::string_view bytes) {
  staged_below(folder, name, bytes)->commit();
}

void replace_found(const std::vector<std::string>& named, const std::string& path,
                   std::string_view bytes) {
  staged_found(named, path, bytes)->commit();
}

void replace_file(const std::string& path, std::string_view bytes) {
  staged_file(path, bytes)->commit();
}

void replace_all_found(const std::vector<std::string>& named,
                       const std::vector<FileReplacement>& files) {
  std::vector<std::unique_ptr<StagedFile>> staged;
  for (const FileReplacement& file : files)
    staged.push_back(staged_found(named, file.path, file.after));
  for (std::size_t i = 0; i < staged.size(); ++i) {
    try {
      staged[i]->commit();
    } catch (const UsageError& error) {
      std::string message = error.what();
      for (std::size_t done = 0; done < i; ++done) message += restored(named, files[done]);
      throw UsageError(message);
    }
  }
}

}  // namespace rigor::tool
