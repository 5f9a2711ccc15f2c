// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a disk answered a moment ago: each key asks for the same hundreds of files and folders as the key before.
//
//   CachedDisk disk(real);
//   disk.expire();               // at each message: answers that are a second old are asked for again
//   disk.forget();               // files have changed
//
// Kinds of paths and bytes of small files are kept; folders and what is opened piece by piece are not.

#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include <rigor/text/disk.h>

namespace rigor::lsp {

class CachedDisk final : public Disk {
 public:
  using Time = std::chrono::steady_clock::time_point;

  static constexpr std::chrono::milliseconds kMaxAge{1000};
  static constexpr std::size_t kMaxFileBytes = std::size_t{1} << 20U;
  static constexpr std::size_t kMaxBytes = std::size_t{16} << 20U;

  /// `below` outlives it.
  explicit CachedDisk(const Disk& below, std::function<Time()> now = std::chrono::steady_clock::now)
      : below_(below), now_(std::move(now)) {}

  /// Forgets all when that was done longer ago than `kMaxAge`.
  void expire();
  void forget();

  std::unique_ptr<OpenFile> open(const std::string& path) const override;
  ReadResult read(const std::string& path, std::uint64_t max_bytes) const override;
  PathKind kind(const std::string& path) const override;
  std::vector<std::string> list(const std::string& folder) const override;
  std::string obstacle(const std::string& path) const override;

 private:
  const Disk& below_;
  std::function<Time()> now_;
  mutable std::mutex mutex_;
  mutable std::unordered_map<std::string, PathKind> kinds_;
  mutable std::unordered_map<std::string, std::string> bytes_;
  mutable std::size_t bytes_kept_ = 0;
  Time since_{};
};

}  // namespace rigor::lsp
