// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/lsp/document/line_index.h>

#include <gtest/gtest.h>

namespace rigor::lsp {
namespace {

// "aé😀b": one, two and four bytes; one, one and two units of UTF-16.
constexpr std::string_view kText =
    "x\r\na\xC3\xA9\xF0\x9F\x98\x80"
    "b\ry\n";

TEST(LspLineIndex, CharactersAreUnitsOfTheEncoding) {
  const LineIndex utf16(kText, PositionEncoding::kUtf16);
  const LineIndex utf8(kText, PositionEncoding::kUtf8);
  const std::uint32_t b = static_cast<std::uint32_t>(kText.find('b'));
  EXPECT_EQ(utf16.position(b), (TextPosition{1, 4}));
  EXPECT_EQ(utf8.position(b), (TextPosition{1, 7}));
  EXPECT_EQ(utf16.offset({1, 4}), b);
  EXPECT_EQ(utf8.offset({1, 7}), b);
  EXPECT_EQ(utf16.line_count(), 4U);
  EXPECT_EQ(utf16.position(b + 2), (TextPosition{2, 0}));  // behind a lone CR
}

TEST(LspLineIndex, PlacesPastTheEndAreTheEnd) {
  const LineIndex lines(kText, PositionEncoding::kUtf16);
  EXPECT_EQ(lines.offset({0, 99}), 1U);  // before the line end
  EXPECT_EQ(lines.offset({99, 0}), kText.size());
  EXPECT_EQ(lines.position(9999), (TextPosition{3, 0}));
  EXPECT_EQ(lines.offset({1, 3}), kText.find("\xF0"));  // within a pair of surrogates
}

TEST(LspLineIndex, EachOffsetOfACharacterComesBack) {
  for (const auto encoding : {PositionEncoding::kUtf8, PositionEncoding::kUtf16}) {
    const LineIndex lines(kText, encoding);
    for (std::uint32_t offset = 0; offset <= kText.size(); ++offset) {
      const bool within =
          offset < kText.size() && (static_cast<unsigned char>(kText[offset]) & 0xC0U) == 0x80U;
      const bool in_line_end = offset == 2;
      if (!within && !in_line_end) {
        EXPECT_EQ(lines.offset(lines.position(offset)), offset);
      }
    }
  }
}

}  // namespace
}  // namespace rigor::lsp
