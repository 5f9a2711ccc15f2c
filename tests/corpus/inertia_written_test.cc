// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `inertia --write` over every model of the corpus: afterwards no rule has anything to say of a link
// whose shapes have an answer, nothing but inertials has changed, and writing again changes nothing.

#include <cstdio>
#include <string>

#include <gtest/gtest.h>

#include <rigor/author/model_inertia.h>
#include <rigor/mass/mesh/survey.h>
#include <rigor/read/load.h>
#include <rigor/rules/environment.h>
#include <rigor/text/edit.h>

#include "support/corpus.h"

namespace rigor {
namespace {

/// The table of a file that holds `bytes`; those on the disk when they are empty.
struct Looked {
  Looked(const Environment& environment, mass::MeshSurveys& surveys, const std::string& path,
         const std::string& bytes)
      : workspace(environment.disk, sources) {
    const read::File& file = bytes.empty() ? workspace.open(path) : workspace.put(path, bytes);
    loaded = load({workspace, environment.resolver, environment.sdf, environment.urdf}, file);
    if (file.document && file.document->complete()) {
      table = author::model_inertia(environment, sources, loaded, surveys, {});
    }
  }

  std::string text() const { return std::string(sources.bytes(loaded.root.source)); }

  Sources sources;
  read::Workspace workspace;
  read::Loaded loaded;
  author::ModelInertia table;
};

/// Without inertials, and without the white space that came with them.
std::string without_inertials(std::string text) {
  for (std::size_t begin; (begin = text.find("<inertial")) != std::string::npos;) {
    const std::size_t tag_end = text.find('>', begin);
    const bool empty = text[tag_end - 1] == '/';
    const std::size_t end =
        empty ? tag_end + 1 : text.find('>', text.find("</inertial", tag_end)) + 1;
    text.erase(begin, end - begin);
  }
  std::erase_if(text, [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; });
  return text;
}

TEST(CorpusInertia, WhatIsWrittenIsRightAndNothingElseChanges) {
  RIGOR_NEEDS_CORPUS();
  const RealDisk disk;
  const Environment environment(disk, {});
  mass::MeshSurveys surveys(disk);
  int changed = 0;
  int left = 0;
  for (const std::string& path : test::corpus_models()) {
    SCOPED_TRACE(path);
    const Looked before(environment, surveys, path, {});
    if (before.table.edits.empty()) continue;
    const auto written = apply_edits(before.text(), before.table.edits);
    ASSERT_TRUE(written);
    EXPECT_EQ(without_inertials(*written), without_inertials(before.text()));
    const Looked after(environment, surveys, path, *written);
    for (const author::LinkInertia& link : after.table.links) {
      if (link.findings.empty()) continue;
      EXPECT_FALSE(link.computed) << link.name << ": " << link.findings.front().message;
      EXPECT_FALSE(link.reason.empty()) << link.name;
      ++left;
    }
    EXPECT_TRUE(after.table.edits.empty());
    ++changed;
  }
  EXPECT_GT(changed, 300);
  std::printf("%d files written; %d links without an answer keep a finding\n", changed, left);
}

}  // namespace
}  // namespace rigor
