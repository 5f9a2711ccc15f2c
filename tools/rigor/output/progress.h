// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Shows on a terminal where a long run is: quiet for the first second, and when stderr is something else.
//
//   const RealDisk real;
//   const ProgressDisk disk(real);   // then used in place of it
//
//   CountProgress progress("runs");
//   progress.at(12, 100);

#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>

#include <rigor/text/disk.h>

namespace rigor::tool {

/// The disk behind it, with a line on stderr while files are read.
class ProgressDisk final : public Disk {
 public:
  explicit ProgressDisk(const Disk& disk);
  ~ProgressDisk() override;
  ProgressDisk(const ProgressDisk&) = delete;
  ProgressDisk& operator=(const ProgressDisk&) = delete;

  std::unique_ptr<OpenFile> open(const std::string& path) const override;
  ReadResult read(const std::string& path, std::uint64_t max_bytes) const override;
  PathKind kind(const std::string& path) const override { return disk_.kind(path); }
  std::vector<std::string> list(const std::string& folder) const override {
    return disk_.list(folder);
  }
  std::string obstacle(const std::string& path) const override { return disk_.obstacle(path); }

 private:
  void at(const std::string& path) const;

  const Disk& disk_;
  bool terminal_;
  std::chrono::steady_clock::time_point begin_;
  mutable bool shown_ = false;
};

/// "12 of 100 runs"
class CountProgress {
 public:
  explicit CountProgress(std::string_view what);
  ~CountProgress();
  CountProgress(const CountProgress&) = delete;
  CountProgress& operator=(const CountProgress&) = delete;

  void at(std::size_t done, std::size_t of);

 private:
  std::string_view what_;
  bool terminal_;
  std::chrono::steady_clock::time_point begin_;
  bool shown_ = false;
};

}  // namespace rigor::tool
