// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A disk on which files that are open in an editor are as the editor has them.
//
//   EditorDisk disk(real);
//   disk.open_in_editor("/robot/arm.xacro", text);
//   disk.read("/robot/arm.xacro", …);              // the editor's text, saved or not
//
// It also remembers what it was asked for: what depends on a file is checked again with it.

#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <rigor/text/disk.h>

namespace rigor::lsp {

/// By normalized path.
using OpenTexts = std::map<std::string, std::shared_ptr<const std::string>>;

class EditorDisk final : public Disk {
 public:
  /// `below` outlives it.
  explicit EditorDisk(const Disk& below, OpenTexts texts = {})
      : below_(below), open_(std::move(texts)) {}

  /// As they are now: for another disk, on another thread.
  OpenTexts open_texts() const;

  /// By normalized path; the text takes the place of what an earlier call gave.
  void open_in_editor(const std::string& path, std::string text);
  void close_in_editor(const std::string& path);

  /// Normalized paths that were read or asked for since the last call, open or not.
  std::set<std::string> take_asked() const;

  std::unique_ptr<OpenFile> open(const std::string& path) const override;
  ReadResult read(const std::string& path, std::uint64_t max_bytes) const override;
  PathKind kind(const std::string& path) const override;
  std::vector<std::string> list(const std::string& folder) const override;
  std::string obstacle(const std::string& path) const override;

 private:
  std::shared_ptr<const std::string> text_of(const std::string& path) const;

  const Disk& below_;
  mutable std::mutex mutex_;
  OpenTexts open_;
  mutable std::set<std::string> asked_;
};

}  // namespace rigor::lsp
