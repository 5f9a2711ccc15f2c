// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A disk for work in the background: once it is stopped nothing can be read of it any more, so that whoever reads
// mesh files comes to an end soon. What such work finds then is thrown away.

#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include <rigor/text/disk.h>

namespace rigor::lsp {

class StoppableDisk final : public Disk {
 public:
  /// `below` outlives it.
  explicit StoppableDisk(const Disk& below) : below_(below) {}

  /// From any thread.
  void stop() { stopped_ = true; }
  bool stopped() const { return stopped_; }

  std::unique_ptr<OpenFile> open(const std::string& path) const override;
  ReadResult read(const std::string& path, std::uint64_t max_bytes) const override;
  PathKind kind(const std::string& path) const override;
  std::vector<std::string> list(const std::string& folder) const override;
  std::string obstacle(const std::string& path) const override;

 private:
  const Disk& below_;
  std::atomic<bool> stopped_ = false;
};

}  // namespace rigor::lsp
