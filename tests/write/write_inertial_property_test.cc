// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What holds for any body that is written, and for any file that it is written to.

#include <rigor/write/write_inertial.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "support/corpus.h"
#include "write/bodies.h"

namespace rigor::write {
namespace {

using mass::MassProperties;
using xml::Document;
using xml::Element;

/// The numbers that a reader finds, by strtod and by name.
MassProperties read_sdf(const Document& document) {
  const Element inertial = *document.root()->child("link")->child("inertial");
  const auto number = [](std::string_view text) {
    return std::strtod(std::string(text).c_str(), nullptr);
  };
  MassProperties body{number(inertial.child("mass")->text()), {}, {}};
  if (const auto pose = inertial.child("pose")) {
    const std::string text(pose->text());
    char* end = nullptr;
    body.com.x = std::strtod(text.c_str(), &end);
    body.com.y = std::strtod(end, &end);
    body.com.z = std::strtod(end, &end);
  }
  const Element inertia = *inertial.child("inertia");
  const auto entry = [&](std::string_view name) { return number(inertia.child(name)->text()); };
  body.about_com = {entry("ixx"), entry("ixy"), entry("ixz"),
                    entry("iyy"), entry("iyz"), entry("izz")};
  return body;
}

TEST(WriteInertial, IsReadBackForAnyBody) {
  std::mt19937 random(11);
  std::string text = "<sdf version='1.9'>\n  <link name='l'/>\n</sdf>\n";
  for (int i = 0; i < 10'000; ++i) {
    const MassProperties body = test::random_body(random);
    const Document before = xml::parse(text, {});  // has the last body
    const Element link = *before.root()->child("link");
    text = apply_edits(text, write_inertial(before, link, body, BlockFormat::kSdf)).value_or("");
    const Document document = xml::parse(text, {});
    ASSERT_TRUE(document.complete());
    const MassProperties back = read_sdf(document);
    ASSERT_TRUE(judge(back).possible()) << text;
    test::expect_near(back, body);
    const Element again = *document.root()->child("link");
    EXPECT_TRUE(write_inertial(document, again, body, BlockFormat::kSdf).empty());
    ASSERT_FALSE(HasFailure()) << text;
  }
}

std::vector<Element> links_of_models(const Document& document) {
  std::vector<Element> links;
  for (std::uint32_t i = 0; i < document.element_count(); ++i) {
    const Element element = document.element(i);
    const auto parent = element.parent();
    if (element.name() != "link" || !parent) continue;
    if (parent->name() == "model" || parent->name() == "robot") links.push_back(element);
  }
  return links;
}

std::vector<Edit> write_all(const Document& document, const MassProperties& body) {
  const bool is_urdf = document.root()->name() == "robot";
  std::vector<Edit> edits;
  for (const Element link : links_of_models(document)) {
    for (Edit& edit :
         write_inertial(document, link, body, is_urdf ? BlockFormat::kUrdf : BlockFormat::kSdf)) {
      edits.push_back(std::move(edit));
    }
  }
  return edits;
}

TEST(WriteInertial, WritesAllLinksOfRealFilesAtOnce) {
  RIGOR_NEEDS_CORPUS();
  std::mt19937 random(5);
  std::size_t links = 0;
  for (const std::string& path : test::corpus_models()) {
    const std::string text = test::read_file(path);
    const Document document = xml::parse(text, {});
    if (!document.complete()) continue;
    const MassProperties body = test::random_body(random);
    const auto changed = apply_edits(text, write_all(document, body));
    ASSERT_TRUE(changed) << path;
    const Document again = xml::parse(*changed, {});
    ASSERT_TRUE(again.complete()) << path;
    EXPECT_EQ(again.faults().size(), document.faults().size()) << path;
    EXPECT_TRUE(write_all(again, body).empty()) << path;
    links += links_of_models(again).size();
  }
  EXPECT_GT(links, 5'000U);
}

}  // namespace
}  // namespace rigor::write
