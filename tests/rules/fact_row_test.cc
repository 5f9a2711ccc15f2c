// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The tables of rules that put facts into words: a row for each kind, and none that names a field which
// its facts lack.

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/convert/note.h>
#include <rigor/read/load.h>
#include <rigor/rules/environment.h>
#include <rigor/rules/runner.h>
#include <rigor/simulate/fact.h>

namespace rigor::rules {
namespace {

Diagnostics run(const Runner& runner, const Environment& environment, const Sources& sources,
                const read::Loaded& loaded, const convert::Note& note) {
  return runner.run(environment, sources, loaded, convert::Notes{note});
}

Diagnostics run(const Runner& runner, const Environment& environment, const Sources& sources,
                const read::Loaded& loaded, const simulate::Fact& fact) {
  return runner.run_each(environment, sources, loaded, {fact}).at(0);
}

/// Expects each fact to be put into words by one rule, in a file of one of the formats at least.
template <class Fact>
void expect_words(const std::vector<Fact>& facts) {
  MemoryDisk disk;
  disk.put("a.sdf", "<sdf version='1.9'><model name='m'/></sdf>");
  disk.put("a.urdf", "<robot name='m'/>");
  const Environment environment(disk, {});
  const Runner runner(environment.registry, {});
  Sources sources;
  read::Workspace workspace(disk, sources);
  const read::Reader reader{workspace, environment.resolver, environment.sdf, environment.urdf};
  const read::Loaded sdf = read::load(reader, workspace.open("a.sdf"));
  const read::Loaded urdf = read::load(reader, workspace.open("a.urdf"));
  for (const Fact& fact : facts) {
    std::set<std::string_view> rules;
    for (const read::Loaded* loaded : {&sdf, &urdf}) {
      const Diagnostics found = run(runner, environment, sources, *loaded, fact);
      for (const Diagnostic& one : found.list()) {
        EXPECT_EQ(one.message.find_first_of("{}"), std::string::npos) << one.message;
        rules.insert(one.rule);
      }
    }
    EXPECT_EQ(rules.size(), 1U) << static_cast<int>(fact.kind);
  }
}

TEST(FactRow, IsThereForEachKindOfNote) {
  std::vector<convert::Note> notes;
  for (int kind = 0; kind <= static_cast<int>(convert::NoteKind::kLinkBetween); ++kind) {
    for (const char* instead : {"", "b"}) {
      notes.push_back(
          {.kind = static_cast<convert::NoteKind>(kind), .written = "a", .instead = instead});
    }
  }
  expect_words(notes);
}

TEST(FactRow, IsThereForEachKindOfFact) {
  std::vector<simulate::Fact> facts;
  for (int kind = 0; kind <= static_cast<int>(simulate::FactKind::kCauseMeshScale); ++kind) {
    for (const double value : {0.0, -1.0, 2.0}) {
      facts.push_back({.kind = static_cast<simulate::FactKind>(kind), .value = value, .name = "a"});
    }
  }
  expect_words(facts);
}

}  // namespace
}  // namespace rigor::rules
