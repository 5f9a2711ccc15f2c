// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/lsp/document/editor_disk.h>

#include <algorithm>
#include <cstring>
#include <utility>

#include <rigor/text/path.h>

namespace rigor::lsp {
namespace {

class OpenText final : public OpenFile {
 public:
  explicit OpenText(std::shared_ptr<const std::string> text) : text_(std::move(text)) {}
  std::uint64_t size() const override { return text_->size(); }
  std::size_t read(std::uint64_t offset, char* into, std::size_t count) const override {
    if (offset >= text_->size()) return 0;
    const std::size_t bytes = std::min(count, text_->size() - static_cast<std::size_t>(offset));
    std::memcpy(into, text_->data() + offset, bytes);
    return bytes;
  }

 private:
  std::shared_ptr<const std::string> text_;
};

}  // namespace

void EditorDisk::open_in_editor(const std::string& path, std::string text) {
  const std::lock_guard lock(mutex_);
  open_[normalize_path(path)] = std::make_shared<const std::string>(std::move(text));
}

void EditorDisk::close_in_editor(const std::string& path) {
  const std::lock_guard lock(mutex_);
  open_.erase(normalize_path(path));
}

OpenTexts EditorDisk::open_texts() const {
  const std::lock_guard lock(mutex_);
  return open_;
}

std::set<std::string> EditorDisk::take_asked() const {
  const std::lock_guard lock(mutex_);
  return std::exchange(asked_, {});
}

std::shared_ptr<const std::string> EditorDisk::text_of(const std::string& path) const {
  const std::lock_guard lock(mutex_);
  std::string normal = normalize_path(path);
  const auto found = open_.find(normal);
  asked_.insert(std::move(normal));
  if (found == open_.end()) return nullptr;
  return found->second;
}

std::unique_ptr<OpenFile> EditorDisk::open(const std::string& path) const {
  if (auto text = text_of(path)) return std::make_unique<OpenText>(std::move(text));
  return below_.open(path);
}

ReadResult EditorDisk::read(const std::string& path, std::uint64_t max_bytes) const {
  const auto text = text_of(path);
  if (!text) return below_.read(path, max_bytes);
  if (text->size() <= max_bytes) return {*text, {}};
  return {std::nullopt, "is larger than " + std::to_string(max_bytes) + " bytes",
          ReadError::kTooLarge};
}

PathKind EditorDisk::kind(const std::string& path) const {
  return text_of(path) ? PathKind::kFile : below_.kind(path);
}

std::vector<std::string> EditorDisk::list(const std::string& folder) const {
  std::vector<std::string> names = below_.list(folder);
  const std::string inside = normalize_path(folder);
  const std::lock_guard lock(mutex_);
  for (const auto& [path, text] : open_) {
    if (parent_path(path) == inside) names.emplace_back(file_name(path));
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

std::string EditorDisk::obstacle(const std::string& path) const {
  return text_of(path) ? std::string() : below_.obstacle(path);
}

}  // namespace rigor::lsp
