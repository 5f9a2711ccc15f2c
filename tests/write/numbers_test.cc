// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/write/numbers.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace rigor::write {
namespace {

TEST(Numbers, WhatAdditionLeavesInTheLastPlaceIsDropped) {
  EXPECT_EQ(settled(0.1 + 0.2, 0, 0.3), 0.3);
  EXPECT_EQ(settled(0.1 + 0.2 - 0.3, 1, 0.3), 0);
  EXPECT_FALSE(std::signbit(settled(-1e-18, 1, 1)));
  EXPECT_EQ(settled(1000.1 - 1000, 0, 1000), 0.1);
  EXPECT_EQ(settled(1e-20, 0, 1e-20), 1e-20);
}

TEST(Numbers, WhatIsWrittenStaysWhenItIsTheSameRounded) {
  const double written = 0.30000000000000004;
  EXPECT_EQ(settled(0.3, written, 0.3), written);
  EXPECT_NE(settled(0.31, written, 0.3), written);
}

TEST(Numbers, WhatHasNoSizeIsLeftAlone) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(settled(kInfinity, 1, 1), kInfinity);
  EXPECT_EQ(settled(0.1, 1, 0), 0.1);
  EXPECT_EQ(settled(1e300, 1, 1e300), 1e300);
}

std::string with_text(const std::string& text, const std::vector<double>& numbers) {
  const xml::Document document = xml::parse(text, {});
  return apply_edits(text, set_numbers(document, *document.root(), numbers)).value_or("");
}

TEST(Numbers, OnlyOthersAreReplaced) {
  EXPECT_EQ(with_text("<a>\t1.50  2e0\n3 </a>", {1.5, 2, -4}), "<a>\t1.50  2e0\n-4 </a>");
  EXPECT_EQ(with_text("<a>1 2</a>", {1, 2, 3}), "<a>1 2 3</a>");
  EXPECT_EQ(with_text("<a/>", {0.001}), "<a>0.001</a>");

  const std::string text = "<a b='1 2'/>";
  const xml::Document document = xml::parse(text, {});
  EXPECT_EQ(apply_edits(text, set_numbers(document, *document.root(), "b", {1, 3})),
            "<a b='1 3'/>");
  EXPECT_EQ(apply_edits(text, set_numbers(document, *document.root(), "c", {1, 3})),
            "<a b='1 2' c='1 3'/>");
}

TEST(Numbers, ATextOfSomethingElseHasNone) {
  EXPECT_EQ(numbers_in(" 1 -2.5\n"), (std::vector<double>{1, -2.5}));
  EXPECT_FALSE(numbers_in("1 ${x}"));
  EXPECT_FALSE(numbers_in("1,5"));
}

}  // namespace
}  // namespace rigor::write
