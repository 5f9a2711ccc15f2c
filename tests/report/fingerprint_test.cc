// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/fingerprint.h>

#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <report/found.h>

namespace rigor::report {
namespace {

std::vector<std::string> all_line_hashes(const std::string& text) {
  std::set<std::uint32_t> lines;
  for (std::uint32_t line = 1; line <= 100; ++line) lines.insert(line);
  std::vector<std::string> hashes;
  for (const auto& [line, hash] : line_hashes(text, lines)) {
    EXPECT_EQ(line, hashes.size() + 1);
    hashes.push_back(hash);
  }
  return hashes;
}

using Hashes = std::vector<std::string>;

// The texts and hashes of codeql-action's own tests, src/fingerprints.test.ts.
TEST(LineHashes, AreThoseOfCodeqlAction) {
  EXPECT_EQ(all_line_hashes(""), (Hashes{"c129715d7a2bc9a3:1"}));
  EXPECT_EQ(all_line_hashes(" a\nb\n  \t\tc\n d"),
            (Hashes{"271789c17abda88f:1", "54703d4cd895b18:1", "180aee12dab6264:1",
                    "a23a3dc5e078b07b:1"}));
  EXPECT_EQ(all_line_hashes(" hello; \t\nworld!!!\n\n\n  \t\tGreetings\n End"),
            (Hashes{"8b7cf3e952e7aeb2:1", "b1ae1287ec4718d9:1", "bff680108adb0fcc:1",
                    "c6805c5e1288b612:1", "b86d3392aea1be30:1", "e6ceba753e1a442:1"}));
  const Hashes ended = {"e9496ae3ebfced30:1", "fb7c023a8b9ccb3f:1", "ce8ba1a563dcdaca:1",
                        "e20e36e16fcb0cc8:1", "b3edc88f2938467e:1", "c8e28b0b4002a3a0:1",
                        "c129715d7a2bc9a3:1"};
  for (const char* text : {" hello; \t\nworld!!!\n\n\n  \t\tGreetings\n End\n",
                           " hello; \t\nworld!!!\r\r\r  \t\tGreetings\r End\r",
                           " hello; \t\r\nworld!!!\r\n\r\n\r\n  \t\tGreetings\r\n End\r\n",
                           " hello; \t\nworld!!!\r\n\n\r  \t\tGreetings\r End\r\n"}) {
    EXPECT_EQ(all_line_hashes(text), ended);
  }
  std::string repeated;
  for (int i = 0; i < 10; ++i) repeated += "Lorem ipsum dolor sit amet.\n";
  EXPECT_EQ(all_line_hashes(repeated),
            (Hashes{"a7f2ff13bc495cf2:1", "a7f2ff13bc495cf2:2", "a7f2ff13bc495cf2:3",
                    "a7f2ff13bc495cf2:4", "a7f2ff13bc495cf2:5", "a7f2ff13bc495cf2:6",
                    "a7f2ff1481e87703:1", "a9cf91f7bbf1862b:1", "55ec222b86bcae53:1",
                    "cc97dc7b1d7d8f7b:1", "c129715d7a2bc9a3:1"}));
}

// Hashes by that algorithm in node, whose strings are UTF-16 and keep a byte-order mark.
TEST(LineHashes, CountUtf16) {
  EXPECT_EQ(all_line_hashes("\xEF\xBB\xBFmaß\n"),
            (Hashes{"9405cc87d4a8c945:1", "c129715d7a2bc9a3:1"}));
  EXPECT_EQ(all_line_hashes("🤖 a\nb"), (Hashes{"3f343c1cda2b1f8c:1", "8ee5a81e681643c1:1"}));
}

TEST(LineHashes, OnlyThoseThatWereAskedFor) {
  const auto some = line_hashes(" a\nb\n  \t\tc\n d", {2, 9});
  ASSERT_EQ(some.size(), 1U);
  EXPECT_EQ(some.at(2), "54703d4cd895b18:1");
}

Diagnostic said(const std::string& message, const std::string& subject = "arm/joint elbow") {
  return {.message = message, .subject = subject};
}

std::string only_id(const std::string& path, const std::string& bytes, const Diagnostic& told) {
  Found found;
  found.file(path, bytes).at("x", told);
  return finding_ids(found.validation()).at(0);
}

TEST(FindingIds, StayWhenLinesMoveAndNumbersAreTuned) {
  const std::string id = only_id("a.sdf", "x", said("mass is 1.5 kg, below 2e-3"));
  EXPECT_EQ(id.size(), 32U);
  EXPECT_EQ(only_id("a.sdf", "\n\n   x", said("mass is 1.5 kg, below 2e-3")), id);
  EXPECT_EQ(only_id("a.sdf", "x", said("mass is -27 kg,  below 1,204.5")), id);
}

TEST(FindingIds, ChangeWithRuleFileEntityAndNames) {
  const std::string id = only_id("a.sdf", "x", said("no link 'l1'"));
  EXPECT_NE(only_id("b.sdf", "x", said("no link 'l1'")), id);
  EXPECT_NE(only_id("a.sdf", "x", said("no link 'l1'", "arm/joint hip")), id);
  EXPECT_NE(only_id("a.sdf", "x", said("no link 'l2'")), id) << "a digit of a name is no number";
  Diagnostic other = said("no link 'l1'");
  other.rule = "axis-missing";
  EXPECT_NE(only_id("a.sdf", "x", other), id);
}

TEST(FindingIds, EqualFindingsAreToldApart) {
  Found found;
  found.file("a.sdf", "x y").at("x", said("it")).at("y", said("it")).at("y", said("it"));
  found.file("b.sdf", "x").at("x", said("it"));
  const std::vector<std::string> ids = finding_ids(found.validation());
  EXPECT_EQ(std::set<std::string>(ids.begin(), ids.end()).size(), 4U);
  EXPECT_EQ(ids[0], only_id("a.sdf", "x", said("it")));
  EXPECT_EQ(ids[3], only_id("b.sdf", "x", said("it"))) << "other files have no say";
}

}  // namespace
}  // namespace rigor::report
