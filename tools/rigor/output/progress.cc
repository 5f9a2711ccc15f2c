// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "output/progress.h"

#include <cstdio>

#include <fmt/core.h>
#include <unistd.h>

#include <rigor/report/terminal/printable.h>
#include <rigor/text/path.h>

namespace rigor::tool {
namespace {

constexpr std::chrono::seconds kQuiet{1};

// Goes to the line's start and wipes it.
constexpr std::string_view kWipe = "\r\x1b[K";

void put(std::string_view text) { std::fwrite(text.data(), 1, text.size(), stderr); }

}  // namespace

ProgressDisk::ProgressDisk(const Disk& disk)
    : disk_(disk),
      terminal_(isatty(STDERR_FILENO) == 1),
      begin_(std::chrono::steady_clock::now()) {}

ProgressDisk::~ProgressDisk() {
  if (shown_) put(kWipe);
}

std::unique_ptr<OpenFile> ProgressDisk::open(const std::string& path) const {
  at(path);
  return disk_.open(path);
}

ReadResult ProgressDisk::read(const std::string& path, std::uint64_t max_bytes) const {
  at(path);
  return disk_.read(path, max_bytes);
}

void ProgressDisk::at(const std::string& path) const {
  if (!terminal_ || std::chrono::steady_clock::now() - begin_ < kQuiet) return;
  put(std::string(kWipe) + "reading " + report::printable(file_name(path), 60));
  shown_ = true;
}

CountProgress::CountProgress(std::string_view what)
    : what_(what),
      terminal_(isatty(STDERR_FILENO) == 1),
      begin_(std::chrono::steady_clock::now()) {}

CountProgress::~CountProgress() {
  if (shown_) put(kWipe);
}

void CountProgress::at(std::size_t done, std::size_t of) {
  if (!terminal_ || std::chrono::steady_clock::now() - begin_ < kQuiet) return;
  put(fmt::format("{}{} of {} {}", kWipe, done, of, what_));
  shown_ = true;
}

}  // namespace rigor::tool
