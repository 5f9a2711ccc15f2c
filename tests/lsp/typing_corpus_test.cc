// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Somebody types real files from their first byte to the last, and edits them at random: what a session says of a
// text is what a new one says of it.

#include <gtest/gtest.h>

#include <filesystem>
#include <random>
#include <string>

#include <rigor/text/disk.h>

#include "lsp/editor.h"
#include "support/part.h"

namespace rigor::lsp {
namespace {

using test::Editor;

/// Findings of the text in a session that has seen nothing else.
Json fresh(const Disk& disk, const std::string& path, const std::string& text) {
  Editor editor(disk, Editor::default_capabilities(),
                std::string(std::filesystem::path(path).parent_path()));
  editor.open(path, text);
  return editor.diagnostics(path);
}

TEST(LspTypingCorpus, APrefixIsCheckedAsIfItWereNew) {
  RIGOR_NEEDS_CORPUS();
  RealDisk disk;
  std::size_t files = 0;
  std::mt19937 random(26);
  for (const std::string& path : rigor::test::corpus_part()) {
    const std::string text = rigor::test::read_file(path);
    if (text.empty() || text.size() > 20'000 || files >= rigor::test::part_of(40)) continue;
    ++files;
    Editor editor(disk, Editor::default_capabilities(),
                  std::string(std::filesystem::path(path).parent_path()));
    editor.open(path, "");
    const std::size_t step = text.size() / 25 + 1;
    for (std::size_t end = 0; end <= text.size(); end += step) {
      editor.change(path, text.substr(0, end));
      const bool compared = random() % 8 == 0;
      if (!compared) continue;
      EXPECT_EQ(editor.diagnostics(path), fresh(disk, path, text.substr(0, end)))
          << path << " " << end;
    }
    editor.change(path, text);
    EXPECT_EQ(editor.diagnostics(path), fresh(disk, path, text)) << path;
  }
  EXPECT_GE(files, rigor::test::part_of(20));
}

TEST(LspTypingCorpus, RandomEditsAreCheckedAsIfTheTextWereNew) {
  RIGOR_NEEDS_CORPUS();
  RealDisk disk;
  std::mt19937 random(27);
  std::size_t edits = 0;
  for (const std::string& path : rigor::test::corpus_part()) {
    std::string text = rigor::test::read_file(path);
    if (text.size() < 100 || text.size() > 20'000 || edits >= rigor::test::part_of(1'500)) continue;
    Editor editor(disk, Editor::default_capabilities(),
                  std::string(std::filesystem::path(path).parent_path()));
    editor.open(path, text);
    for (int i = 0; i < 30; ++i, ++edits) {
      const std::size_t begin = random() % text.size();
      const std::size_t count = std::min<std::size_t>(random() % 12, text.size() - begin);
      const std::size_t from = random() % text.size();
      text.replace(begin, count, text.substr(from, random() % 12));
      if (text.size() < 2) break;
      editor.change(path, text);
    }
    EXPECT_EQ(editor.diagnostics(path), fresh(disk, path, text)) << path;
  }
  EXPECT_GE(edits, rigor::test::part_of(1'000));
}

}  // namespace
}  // namespace rigor::lsp
