// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/xml/characters.h>

#include <gtest/gtest.h>

#include <string>

#include <rigor/xml/decode.h>

namespace rigor::xml {
namespace {

TEST(Characters, EveryCodePointThatXmlAllowsIsFine) {
  for (std::uint32_t c = 0; c < 0x110000; c += c < 0x3000 ? 1 : 97) {
    std::string text;
    append_utf8(text, c);
    const bool allowed = c == 9 || c == 10 || c == 13 || (c >= 0x20 && (c < 0xD800 || c > 0xDFFF));
    ASSERT_EQ(!text.empty(), allowed) << c;
    // Long enough for the blocks in which plain text is skipped.
    const std::string padded = "abcde" + text + std::string(80, 'f');
    ASSERT_FALSE(find_bad_character(padded, 0)) << c;
  }
}

TEST(Characters, FindsWhatIsNotUtf8) {
  using namespace std::string_literals;
  for (const std::string& bad : {"\xC0\x80"s, "\xE0\x9F\xBF"s, "\xED\xA0\x80"s, "\xF4\x90\x80\x80"s,
                                 "\xF8"s, "\x80"s, "\xE2\x82"s}) {
    const auto found = find_bad_character("0123456789" + bad, 0);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->begin, 10U);
    EXPECT_FALSE(found->control);
  }
  const auto control = find_bad_character("01234567\x7F\0"s, 0);
  ASSERT_TRUE(control);
  EXPECT_EQ(control->begin, 9U);
  EXPECT_TRUE(control->control);
}

}  // namespace
}  // namespace rigor::xml
