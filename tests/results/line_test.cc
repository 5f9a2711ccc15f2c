// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/results/line.h>

#include <string>

#include <gtest/gtest.h>

#include "results/result_lines.h"

namespace rigor::results {
namespace {

TEST(ResultLine, OfValidateIsWhatItSays) {
  const auto record = record_of(checked_line(12, 20));
  ASSERT_TRUE(record && std::holds_alternative<CheckedFile>(*record));
  const auto& file = std::get<CheckedFile>(*record);
  EXPECT_EQ(file.one.index, 12U);
  EXPECT_EQ(file.one.of, 20U);
  EXPECT_EQ(file.path, "models/m12/model.sdf");
  EXPECT_EQ(file.kind, "sdf");
  EXPECT_EQ(file.links, 2U);
  ASSERT_EQ(file.findings.size(), 2U);
  EXPECT_EQ(file.findings[0].rule, "inertia-not-physical");
  EXPECT_EQ(file.findings[0].place.line, 3);
  ASSERT_EQ(file.findings[1].others.size(), 1U);
  EXPECT_EQ(file.findings[1].others[0].path, "other.sdf");
  EXPECT_FALSE(file.findings[1].others[0].line);
  ASSERT_EQ(file.meshes.size(), 1U);
  EXPECT_EQ(file.meshes[0].triangles, 12U);
  EXPECT_EQ(file.meshes[0].digest, std::string(32, '0'));
  ASSERT_TRUE(file.meshes[0].max);
  EXPECT_EQ((*file.meshes[0].max)[2], 1.0);
}

TEST(ResultLine, OfSimulateIsWhatItSays) {
  const auto record = record_of(simulated_line(5, 6));
  ASSERT_TRUE(record && std::holds_alternative<SimulatedCase>(*record));
  const auto& simulated = std::get<SimulatedCase>(*record);
  EXPECT_EQ(simulated.model, "models/m5/model.sdf");
  EXPECT_EQ(simulated.one.id, "seed=0");
  ASSERT_EQ(simulated.runs.size(), 1U);
  EXPECT_EQ(simulated.runs[0].duration, 2.5);
  ASSERT_EQ(simulated.runs[0].metrics.size(), 2U);
  EXPECT_EQ(simulated.runs[0].metrics[0].value, 1.5);
  EXPECT_EQ(simulated.runs[0].metrics[0].unit, "rad");
  EXPECT_FALSE(simulated.runs[0].metrics[1].value) << "it was not finite";
}

TEST(ResultLine, TheHeadIsThatOfTheWhole) {
  for (const std::string& line : {checked_line(3, 9), simulated_line(3, 9)}) {
    const auto head = head_of(line);
    ASSERT_TRUE(head);
    EXPECT_EQ(head->one.index, 3U);
    EXPECT_EQ(head->one.of, 9U);
  }
  EXPECT_EQ(head_of(checked_line(3, 9))->kind, ResultKind::kValidate);
  EXPECT_EQ(head_of(simulated_line(3, 9))->kind, ResultKind::kSimulate);
  const auto reordered =
      head_of(R"({"runs":[{"path":"no"}],"model":"m","case":{"of":2,"index":1}})");
  ASSERT_TRUE(reordered) << "another program may have sorted the keys";
  EXPECT_EQ(reordered->kind, ResultKind::kSimulate);
}

TEST(ResultLine, WhatIsCutIsNone) {
  for (const std::string& line : {checked_line(0, 1), simulated_line(0, 1)}) {
    for (std::size_t size = 0; size < line.size(); ++size)
      EXPECT_FALSE(record_of(line.substr(0, size))) << size;
  }
}

TEST(ResultLine, WhatIsNoResultIsNone) {
  for (const char* line :
       {"", "{}", "[]", "null", "1", R"({"case":{"index":1,"of":1},"path":"a"})",
        R"({"case":{"index":-1,"of":1},"path":"a"})", R"({"case":{"index":0,"of":1}})",
        R"({"case":[0,1],"path":"a"})", R"({"case":{"index":"0","of":1},"path":"a"})"}) {
    EXPECT_FALSE(head_of(line)) << line;
    EXPECT_FALSE(record_of(line)) << line;
  }
  const std::string deep = std::string(100000, '[');
  EXPECT_FALSE(head_of(deep));
  EXPECT_FALSE(record_of(deep));
}

}  // namespace
}  // namespace rigor::results
