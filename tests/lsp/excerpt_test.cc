// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <optional>
#include <string>

#include <rigor/lsp/document/excerpt.h>
#include <rigor/xml/document.h>

namespace rigor::lsp {
namespace {

/// Larger than a part may be.
const std::string kExcerptRest =
    "<model name='rest'>" + std::string(Excerpt::kMaxPartBytes, ' ') + "</model>";

const std::string kExcerptWorld =
    "<!-- rigor: file-ignore[schema] --><sdf version='1.9'><!-- a --><world name='w'>" +
    kExcerptRest +
    "<!-- b --><model name='one'><link name='l'/></model><model name='two'/></world></sdf>";

/// Of the first `mark`, `moved` bytes on.
TextChange insertion(const std::string& text, const std::string& mark, std::uint32_t moved,
                     std::uint32_t size) {
  const auto at = static_cast<std::uint32_t>(text.find(mark)) + moved;
  return {at, at, size};
}

std::optional<std::string> excerpt_around(const TextChange& change) {
  const xml::Document document = xml::parse_own(kExcerptWorld, SourceId{0});
  const std::optional<Excerpt> excerpt = Excerpt::around(document, change);
  if (!excerpt) return std::nullopt;
  return excerpt->text(kExcerptWorld);
}

const std::string kExcerptHead =
    "<!-- rigor: file-ignore[schema] --><sdf version='1.9'><!-- a --><world name='w'>";

TEST(LspExcerpt, IsTheLargestElementThatIsSmallEnoughWithTheTagsAndCommentsAroundIt) {
  EXPECT_EQ(excerpt_around(insertion(kExcerptWorld, "name='l'", 3, 1)),
            kExcerptHead + "<!-- b --><model name='one'><link name='l'/></model></world></sdf>");
}

TEST(LspExcerpt, BetweenTwoElementsIsBoth) {
  EXPECT_EQ(excerpt_around(insertion(kExcerptWorld, "<model name='two'", 0, 1)),
            kExcerptHead +
                "<!-- b --><model name='one'><link name='l'/></model><model name='two'/>"
                "</world></sdf>");
}

TEST(LspExcerpt, ThereIsNoneOfTagsAroundParts) {
  EXPECT_EQ(excerpt_around(insertion(kExcerptWorld, "version", 0, 1)), std::nullopt);
  EXPECT_EQ(excerpt_around(insertion(kExcerptWorld, "</world>", 3, 1)), std::nullopt);
  EXPECT_EQ(excerpt_around(insertion(kExcerptWorld, "<!-- rigor", 6, 1)), std::nullopt);
  EXPECT_EQ(excerpt_around({10, static_cast<std::uint32_t>(kExcerptWorld.size() - 2), 0}),
            std::nullopt);
  const xml::Document broken = xml::parse_own("<sdf><world>", SourceId{0});
  EXPECT_FALSE(Excerpt::around(broken, {7, 7, 1}).has_value());
}

TEST(LspExcerpt, EveryByteHasItsPlaceInTheDocument) {
  const TextChange change = insertion(kExcerptWorld, "name='l'", 6, 4);
  std::string after = kExcerptWorld;
  after.insert(change.begin, "long");
  const xml::Document document = xml::parse_own(kExcerptWorld, SourceId{0});
  const Excerpt excerpt = Excerpt::around(document, change)->after(change);
  const std::string text = excerpt.text(after);
  EXPECT_NE(text.find("<link name='longl'/>"), std::string::npos);
  for (std::uint32_t i = 0; i < text.size(); ++i) {
    EXPECT_EQ(text[i], after[excerpt.begin_in_document(i)]) << i;
    EXPECT_EQ(excerpt.end_in_document(i + 1), excerpt.begin_in_document(i) + 1) << i;
  }
  const auto link = static_cast<std::uint32_t>(after.find("<link"));
  EXPECT_TRUE(excerpt.core_has(link, link + 10));
  EXPECT_FALSE(excerpt.core_has(0, 5));
}

}  // namespace
}  // namespace rigor::lsp
