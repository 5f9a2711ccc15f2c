// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/text/disk.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <iterator>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <rigor/text/letter_case.h>
#include <rigor/text/path.h>

namespace rigor {
namespace fs = std::filesystem;

namespace {

ReadResult too_large(std::uint64_t max_bytes) {
  const bool in_mib = max_bytes >= std::uint64_t{1} << 20U;
  return {std::nullopt,
          "is larger than " + std::to_string(max_bytes >> (in_mib ? 20U : 10U)) +
              (in_mib ? " MiB" : " KiB"),
          ReadError::kTooLarge};
}

class RealFile final : public OpenFile {
 public:
  RealFile(int descriptor, std::uint64_t size) : descriptor_(descriptor), size_(size) {}
  ~RealFile() override { ::close(descriptor_); }
  RealFile(const RealFile&) = delete;
  RealFile& operator=(const RealFile&) = delete;

  std::uint64_t size() const override { return size_; }

  std::size_t read(std::uint64_t offset, char* into, std::size_t count) const override {
    std::size_t done = 0;
    while (done < count) {
      const ssize_t got =
          ::pread(descriptor_, into + done, count - done, static_cast<off_t>(offset + done));
      if (got < 0 && errno == EINTR) continue;
      if (got <= 0) break;
      done += static_cast<std::size_t>(got);
    }
    return done;
  }

 private:
  int descriptor_;
  std::uint64_t size_;
};

class MemoryFile final : public OpenFile {
 public:
  explicit MemoryFile(std::string_view bytes) : bytes_(bytes) {}

  std::uint64_t size() const override { return bytes_.size(); }

  std::size_t read(std::uint64_t offset, char* into, std::size_t count) const override {
    if (offset >= bytes_.size()) return 0;
    return bytes_.copy(into, count, static_cast<std::size_t>(offset));
  }

 private:
  std::string_view bytes_;
};

}  // namespace

std::unique_ptr<OpenFile> RealDisk::open(const std::string& path) const {
  // Without O_NONBLOCK, opening a pipe waits for somebody who writes into it.
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (descriptor < 0) return nullptr;
  struct stat status = {};
  if (::fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode)) {
    ::close(descriptor);
    return nullptr;
  }
  return std::make_unique<RealFile>(descriptor, static_cast<std::uint64_t>(status.st_size));
}

ReadResult RealDisk::read(const std::string& path, std::uint64_t max_bytes) const {
  const std::unique_ptr<OpenFile> file = open(path);
  if (!file) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status)) return {std::nullopt, "no such file"};
    if (fs::is_directory(status)) return {std::nullopt, "is a folder"};
    // A pipe or device has no size and may never end.
    if (!fs::is_regular_file(status)) return {std::nullopt, "is not a regular file"};
    return {std::nullopt, "cannot be opened (permissions?)"};
  }
  if (file->size() > max_bytes) return too_large(max_bytes);
  std::string bytes(static_cast<std::size_t>(file->size()), '\0');
  bytes.resize(file->read(0, bytes.data(), bytes.size()));
  return {std::move(bytes), {}};
}

PathKind RealDisk::kind(const std::string& path) const {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_regular_file(status)) return PathKind::kFile;
  if (fs::is_directory(status)) return PathKind::kFolder;
  return fs::exists(status) ? PathKind::kOther : PathKind::kMissing;
}

std::vector<std::string> RealDisk::list(const std::string& folder) const {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    // A link to a folder may lead back up, and then a walk would never end.
    std::error_code unknown;
    if (it->is_symlink(unknown) && it->is_directory(unknown)) continue;
    names.push_back(it->path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string RealDisk::obstacle(const std::string& path) const {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status)) {
    const fs::directory_iterator listed(path, error);
    if (!error) return {};
    // As the C library words it, but for the capital: "permission denied".
    std::string why = error.message();
    if (!why.empty()) why[0] = lower(why[0]);
    return "cannot be listed: " + why;
  }
  const bool is_link = fs::is_symlink(fs::symlink_status(path, error));
  return is_link && !fs::exists(status) ? "is a link to a file that does not exist" : "";
}

MemoryDisk::MemoryDisk(std::map<std::string, std::string> files) {
  for (auto& [path, bytes] : files) put(path, std::move(bytes));
}

void MemoryDisk::put(const std::string& path, std::string bytes) {
  std::string below = normalize_path(path);
  entries_[below].bytes = std::move(bytes);
  for (bool added = true; added && below != "." && below != "/";) {
    std::string folder(parent_path(below));
    added = entries_[folder].names.emplace(file_name(below)).second;
    below = std::move(folder);
  }
}

const MemoryDisk::Entry* MemoryDisk::find(const std::string& path) const {
  // Nearly always the path is in its normal form.
  auto found = entries_.find(path);
  if (found == entries_.end() && !is_normal(path)) found = entries_.find(normalize_path(path));
  return found == entries_.end() ? nullptr : &found->second;
}

std::unique_ptr<OpenFile> MemoryDisk::open(const std::string& path) const {
  const Entry* const entry = find(path);
  if (entry == nullptr || !entry->bytes) return nullptr;
  return std::make_unique<MemoryFile>(*entry->bytes);
}

ReadResult MemoryDisk::read(const std::string& path, std::uint64_t max_bytes) const {
  const Entry* const entry = find(path);
  if (entry == nullptr) return {std::nullopt, "no such file"};
  if (!entry->bytes) return {std::nullopt, "is a folder"};
  if (entry->bytes->size() > max_bytes) return too_large(max_bytes);
  return {*entry->bytes, {}};
}

PathKind MemoryDisk::kind(const std::string& path) const {
  const Entry* const entry = find(path);
  if (entry == nullptr) return PathKind::kMissing;
  return entry->bytes ? PathKind::kFile : PathKind::kFolder;
}

std::vector<std::string> MemoryDisk::list(const std::string& folder) const {
  const Entry* const entry = find(folder);
  if (entry == nullptr) return {};
  return {entry->names.begin(), entry->names.end()};
}

}  // namespace rigor
