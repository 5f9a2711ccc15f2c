// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mass/material.h>

#include <algorithm>
#include <set>
#include <string_view>

#include <gtest/gtest.h>

namespace rigor::mass {
namespace {

TEST(Material, ByNameAndByOtherWords) {
  ASSERT_NE(find_material("steel"), nullptr);
  EXPECT_EQ(find_material("steel")->density, 7850);
  EXPECT_EQ(find_material("aluminium"), find_material("aluminum"));
  EXPECT_EQ(find_material("delrin"), find_material("pom"));
  for (const std::string_view word : {"acrylic", "fr4", "nylon", "pc", "pp", "rubber", "teflon"}) {
    EXPECT_NE(find_material(word), nullptr) << word;
  }
  EXPECT_EQ(find_material("unobtainium"), nullptr);
  EXPECT_EQ(find_material(""), nullptr);
  EXPECT_EQ(find_material("Steel"), nullptr);
}

TEST(Material, EachIsInItsRangeAndNamedOnce) {
  std::set<std::string_view> names;
  for (const Material& material : materials()) {
    EXPECT_TRUE(names.insert(material.name).second) << material.name;
    EXPECT_GT(material.low, 0) << material.name;
    EXPECT_LE(material.low, material.density) << material.name;
    EXPECT_LE(material.density, material.high) << material.name;
    EXPECT_FALSE(material.source.empty()) << material.name;
    EXPECT_EQ(find_material(material.name), &material);  // no alias hides it
    EXPECT_TRUE(std::all_of(material.name.begin(), material.name.end(), [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
    })) << material.name;
  }
}

TEST(Material, OrderOfWeights) {
  // Known to everyone who has lifted them.
  const char* heavier[] = {"tungsten",
                           "lead",
                           "copper",
                           "steel",
                           "aluminum",
                           "pom",
                           "water",
                           "oak",
                           "pine",
                           "balsa",
                           "expanded-polystyrene"};
  for (std::size_t i = 0; i + 1 < std::size(heavier); ++i) {
    EXPECT_GT(find_material(heavier[i])->density, find_material(heavier[i + 1])->density)
        << heavier[i];
  }
}

}  // namespace
}  // namespace rigor::mass
