// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/lsp/document/stoppable_disk.h>

#include <utility>

namespace rigor::lsp {
namespace {

class StoppableFile final : public OpenFile {
 public:
  StoppableFile(std::unique_ptr<OpenFile> file, const std::atomic<bool>& stopped)
      : file_(std::move(file)), stopped_(stopped) {}
  std::uint64_t size() const override { return file_->size(); }
  std::size_t read(std::uint64_t offset, char* into, std::size_t count) const override {
    return stopped_ ? 0 : file_->read(offset, into, count);
  }

 private:
  std::unique_ptr<OpenFile> file_;
  const std::atomic<bool>& stopped_;
};

}  // namespace

std::unique_ptr<OpenFile> StoppableDisk::open(const std::string& path) const {
  std::unique_ptr<OpenFile> file = stopped_ ? nullptr : below_.open(path);
  if (!file) return nullptr;
  return std::make_unique<StoppableFile>(std::move(file), stopped_);
}

ReadResult StoppableDisk::read(const std::string& path, std::uint64_t max_bytes) const {
  if (stopped_) return {std::nullopt, "is no longer wanted"};
  return below_.read(path, max_bytes);
}

PathKind StoppableDisk::kind(const std::string& path) const {
  return stopped_ ? PathKind::kMissing : below_.kind(path);
}

std::vector<std::string> StoppableDisk::list(const std::string& folder) const {
  return stopped_ ? std::vector<std::string>{} : below_.list(folder);
}

std::string StoppableDisk::obstacle(const std::string& path) const {
  return stopped_ ? std::string() : below_.obstacle(path);
}

}  // namespace rigor::lsp
