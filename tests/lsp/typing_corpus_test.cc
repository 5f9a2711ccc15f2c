// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Somebody types real files from their first byte to the last, and edits them at random: what a session says of a
// text is what a new one says of it. With RIGOR_TYPING=full every prefix of 200 files and 20,000 edits are compared,
// which takes long with sanitizers; else a part of them.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <string_view>

#include <rigor/lsp/project/part_check.h>
#include <rigor/text/disk.h>

#include "lsp/editor.h"
#include "support/part.h"

namespace rigor::lsp {
namespace {

using test::Editor;

/// What sessions of this test know of the formats: what they have seen they do not share.
const std::shared_ptr<const Knowledge>& knowledge() {
  static const auto shared = std::make_shared<const Knowledge>();
  return shared;
}

/// Findings of the text in a session that has seen nothing else.
Json fresh(const Disk& disk, const std::string& path, const std::string& text) {
  Editor editor(disk, Editor::default_capabilities(),
                std::string(std::filesystem::path(path).parent_path()), knowledge());
  editor.open(path, text);
  return editor.diagnostics(path);
}

bool compares_all() {
  const char* const how = std::getenv("RIGOR_TYPING");
  return how != nullptr && std::string_view(how) == "full";
}

TEST(LspTypingCorpus, APrefixIsCheckedAsIfItWereNew) {
  RIGOR_NEEDS_CORPUS();
  RealDisk disk;
  std::size_t files = 0;
  std::mt19937 random(26);
  const std::size_t most_bytes = compares_all() ? 1'500 : 20'000;
  const std::size_t most_files = compares_all() ? 200 : rigor::test::part_of(40);
  for (const std::string& path : rigor::test::corpus_part()) {
    const std::string text = rigor::test::read_file(path);
    if (text.empty() || text.size() > most_bytes || files >= most_files) continue;
    ++files;
    Editor editor(disk, Editor::default_capabilities(),
                  std::string(std::filesystem::path(path).parent_path()), knowledge());
    editor.open(path, "");
    const std::size_t step = compares_all() ? 1 : text.size() / 25 + 1;
    for (std::size_t end = 0; end <= text.size(); end += step) {
      editor.change(path, text.substr(0, end));
      const bool compared = compares_all() || random() % 8 == 0;
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
  const std::size_t most_edits = compares_all() ? 20'000 : rigor::test::part_of(1'500);
  for (const std::string& path : rigor::test::corpus_part()) {
    std::string text = rigor::test::read_file(path);
    if (text.size() < 100 || text.size() > 20'000 || edits >= most_edits) continue;
    Editor editor(disk, Editor::default_capabilities(),
                  std::string(std::filesystem::path(path).parent_path()), knowledge());
    editor.open(path, text);
    for (int i = 0; i < 30; ++i, ++edits) {
      const std::size_t begin = random() % text.size();
      const std::size_t count = std::min<std::size_t>(random() % 12, text.size() - begin);
      const std::size_t from = random() % text.size();
      text.replace(begin, count, text.substr(from, random() % 12));
      if (text.size() < 2) break;
      editor.change(path, text);
      if (compares_all()) {
        EXPECT_EQ(editor.diagnostics(path), fresh(disk, path, text)) << path << " edit " << i;
      }
    }
    EXPECT_EQ(editor.diagnostics(path), fresh(disk, path, text)) << path;
  }
  EXPECT_GE(edits, rigor::test::part_of(1'000));
}

TEST(LspTypingCorpus, ATemplateThatReadsMuchIsCheckedAsIfItWereNew) {
  RIGOR_NEEDS_CORPUS();
  const std::string templates = rigor::test::corpus() + "/../corpus-xacro";
  if (!std::filesystem::exists(templates)) GTEST_SKIP() << "there is no corpus-xacro";
  RealDisk disk;
  std::mt19937 random(29);
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(templates)) {
    const std::string path = entry.path().lexically_normal().string();
    if (entry.path().extension() != ".xacro" || !rigor::test::in_part(path)) continue;
    std::string text = rigor::test::read_file(path);
    if (text.size() < 100 || text.size() > 20'000 || random() % 8 != 0) continue;
    ++files;
    Editor editor(disk, Editor::default_capabilities(),
                  std::string(std::filesystem::path(path).parent_path()), knowledge());
    editor.session().set_large(1);
    editor.open(path, text);
    for (int i = 0; i < 4; ++i) {
      const std::size_t from = random() % text.size();
      text.replace(random() % text.size(), random() % 6, text.substr(from, random() % 6));
      editor.change(path, text);
      EXPECT_EQ(editor.diagnostics(path), fresh(disk, path, text)) << path << " edit " << i;
    }
  }
  EXPECT_GE(files, rigor::test::part_of(40));
}

/// Of findings: what they are and where.
std::multiset<std::string> finding_keys(const Json& diagnostics) {
  std::multiset<std::string> keys;
  for (const Json& each : diagnostics) {
    keys.insert(text_at(each, "code") + each["range"].dump());
  }
  return keys;
}

TEST(LspTypingCorpus, OfALargeFileThePartThatIsTypedInIsCheckedFirst) {
  RIGOR_NEEDS_CORPUS();
  RealDisk disk;
  std::mt19937 random(28);
  std::size_t edits = 0;
  std::size_t in_parts = 0;
  std::size_t findings = 0;
  std::size_t to_come = 0;
  std::size_t to_go = 0;
  for (const std::string& path : rigor::test::corpus_part()) {
    const std::string whole = rigor::test::read_file(path);
    if (whole.size() < PartCheck::kLargeBytes || whole.size() > 600'000) continue;
    Editor editor(disk, Editor::default_capabilities(),
                  std::string(std::filesystem::path(path).parent_path()), knowledge());
    editor.open(path, whole);
    for (int i = 0; i < 6; ++i, ++edits) {
      std::string text = whole;
      const std::size_t from = random() % whole.size();
      text.replace(random() % whole.size(), random() % 3, whole.substr(from, random() % 3));
      editor.type(path, text);
      editor.work_on_keys();
      const auto first = finding_keys(editor.diagnostics(path));
      const bool is_part = editor.session().wants_whole_check();
      editor.work();
      ASSERT_EQ(editor.diagnostics(path), fresh(disk, path, text)) << path;
      if (!is_part) continue;
      ++in_parts;
      const auto then = finding_keys(editor.diagnostics(path));
      findings += then.size();
      for (const std::string& key : then) to_come += first.count(key) == 0 ? 1 : 0;
      for (const std::string& key : first) to_go += then.count(key) == 0 ? 1 : 0;
      editor.change(path, whole);
    }
  }
  EXPECT_GE(in_parts * 2, edits);
  // Rules on all of a model wait; of a hundred findings two may come or go with them.
  EXPECT_LE(to_come * 50, findings);
  EXPECT_LE(to_go * 50, findings);
  RecordProperty("edits", static_cast<int>(edits));
  RecordProperty("in_parts", static_cast<int>(in_parts));
  RecordProperty("findings", static_cast<int>(findings));
  RecordProperty("to_come", static_cast<int>(to_come));
  RecordProperty("to_go", static_cast<int>(to_go));
}

}  // namespace
}  // namespace rigor::lsp
