// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/lsp/document/cached_disk.h>

#include <cstdint>
#include <utility>

namespace rigor::lsp {

void CachedDisk::expire() {
  const Time now = now_();
  if (now - since_ <= kMaxAge) return;
  forget();
  since_ = now;
}

void CachedDisk::forget() {
  const std::lock_guard lock(mutex_);
  kinds_.clear();
  bytes_.clear();
  bytes_kept_ = 0;
}

PathKind CachedDisk::kind(const std::string& path) const {
  const std::lock_guard lock(mutex_);
  const auto known = kinds_.find(path);
  if (known != kinds_.end()) return known->second;
  return kinds_.emplace(path, below_.kind(path)).first->second;
}

ReadResult CachedDisk::read(const std::string& path, std::uint64_t max_bytes) const {
  {
    const std::lock_guard lock(mutex_);
    const auto known = bytes_.find(path);
    if (known != bytes_.end() && known->second.size() <= max_bytes) return {known->second, {}};
  }
  ReadResult result = below_.read(path, max_bytes);
  if (!result.bytes || result.bytes->size() > kMaxFileBytes) return result;
  const std::lock_guard lock(mutex_);
  if (bytes_kept_ + result.bytes->size() <= kMaxBytes && bytes_.emplace(path, *result.bytes).second)
    bytes_kept_ += result.bytes->size();
  return result;
}

std::unique_ptr<OpenFile> CachedDisk::open(const std::string& path) const {
  return below_.open(path);
}

std::vector<std::string> CachedDisk::list(const std::string& folder) const {
  return below_.list(folder);
}

std::string CachedDisk::obstacle(const std::string& path) const { return below_.obstacle(path); }

}  // namespace rigor::lsp
