// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/places.h>

#include <cstdint>
#include <string>

#include <gtest/gtest.h>

namespace rigor::report {
namespace {

/// Places answers as Sources does, byte for byte; it only answers faster.
void expect_same_positions(const std::string& bytes) {
  Sources sources;
  const SourceId source = sources.add("a.sdf", bytes);
  const LineTable table(sources.bytes(source));
  Places places(sources);
  for (std::uint32_t i = 0; i <= bytes.size(); ++i) {
    EXPECT_EQ(places.begin({source, i, i}), table.position(i)) << "offset " << i;
  }
}

TEST(Places, AgreesWithTheLineTable) {
  expect_same_positions("");
  expect_same_positions("<a>\n</a>\n");
  expect_same_positions("\r\na\rb\r\r\nc\n\nd\r");
  expect_same_positions("\n\r\n\r");
  expect_same_positions("ä\nöü€\n\xF0\x9F\xA4\x96x");
  expect_same_positions("\xFF\x80\x80z\xE2\x82\n\xC3");
}

TEST(Places, AgreesInLongLines) {
  std::string line;
  for (int i = 0; i < 2000; ++i) line += i % 3 == 0 ? "€" : i % 7 == 0 ? "\xFF" : "ab";
  expect_same_positions(line + "\n" + line);
  expect_same_positions("\n" + std::string(3000, '\x80') + "x");
}

TEST(Places, AByteOrderMarkHasNoColumn) {
  Sources sources;
  const SourceId source = sources.add("a.sdf", "\xEF\xBB\xBF<a>\nb");
  Places places(sources);
  EXPECT_EQ(places.begin({source, 0, 3}), (Position{1, 1}));
  EXPECT_EQ(places.end({source, 0, 3}), (Position{1, 1}));
  EXPECT_EQ(places.begin({source, 4, 4}), (Position{1, 2}));
  EXPECT_EQ(places.begin({source, 7, 8}), (Position{2, 1}));
}

}  // namespace
}  // namespace rigor::report
