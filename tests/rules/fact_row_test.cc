// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The tables of rules that put facts into words: a row for each kind, and none that names a field which
// its facts lack.

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <type_traits>

#include <rigor/environment.h>
#include <rigor/read/load.h>
#include <rigor/rules/runner.h>

namespace rigor::rules {
namespace {

/// The rules that have words for a fact, in a file of either format.
template <class Fact>
std::set<std::string> rules_on(const Fact& fact) {
  MemoryDisk disk;
  disk.put("a.sdf", "<sdf version='1.9'><model name='m'/></sdf>");
  disk.put("a.urdf", "<robot name='m'/>");
  const Environment environment(disk, {});
  const Runner runner(environment.registry, {});
  std::set<std::string> rules;
  for (const char* path : {"a.sdf", "a.urdf"}) {
    Sources sources;
    read::Workspace workspace(disk, sources);
    const read::Loaded loaded = read::load(
        {workspace, environment.resolver, environment.sdf, environment.urdf}, workspace.open(path));
    Diagnostics found;
    if constexpr (std::is_same_v<Fact, convert::Note>) {
      found = runner.run(environment, sources, loaded, convert::Notes{fact});
    } else {
      found = runner.run_each(environment, sources, loaded, {fact}).at(0);
    }
    for (const Diagnostic& one : found.list()) {
      EXPECT_EQ(one.message.find_first_of("{}"), std::string::npos) << one.message;
      rules.emplace(one.rule);
    }
  }
  return rules;
}

TEST(FactRow, IsThereForEachKindOfNote) {
  for (int kind = 0; kind <= static_cast<int>(convert::NoteKind::kLinkBetween); ++kind) {
    convert::Note note{.kind = static_cast<convert::NoteKind>(kind), .written = "a"};
    EXPECT_EQ(rules_on(note).size(), 1U) << kind;
    note.instead = "b";
    EXPECT_EQ(rules_on(note).size(), 1U) << kind;
  }
}

TEST(FactRow, IsThereForEachKindOfFact) {
  for (int kind = 0; kind <= static_cast<int>(simulate::FactKind::kCauseMeshMissing); ++kind) {
    for (const double value : {0.0, -1.0, 2.0}) {
      const simulate::Fact fact{
          .kind = static_cast<simulate::FactKind>(kind), .value = value, .name = "a"};
      EXPECT_EQ(rules_on(fact).size(), 1U) << kind;
    }
  }
}

}  // namespace
}  // namespace rigor::rules
