// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The quick reader of YAML against yaml-cpp: a file that it reads, and the same with a line behind it that
// only yaml-cpp reads, must give the same values at the same places.

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include <rigor/xacro/plain_yaml.h>

#include "xacro/expanded.h"

namespace rigor::test {
namespace {

constexpr const char* kPlainFile =
    "# limits of the arm, in °\n"
    "---\n"
    "arm:\n"
    "  # the first joint\n"
    "  mass: 1.50   # kg\n"
    "  reach: !millimeters  250*2\n"
    "  max: !degrees -360.0\n"
    "  name: left arm #1\n"
    "  file: \"package://arm/meshes/a b.dae\"   # quoted\n"
    "  color: '0.7 0.7 0.7 1.0'\n"
    "\n"
    "  link:\n"
    "      frame: $(arg prefix)base\n"
    "      octal: 010\n"
    "      flag: yes\n"
    "      # nothing here\n"
    "      none:   # nor here\n"
    "      nothing:\n"
    "\n"
    "  finger: &finger  # of both hands\n"
    "    length: 0.1\n"
    "  other: *finger\n"
    "  third: &finger\n"
    "    length: 0.3\n"
    "  fourth: *finger   # the last one\n"
    "count: 0x1f\n"
    "empty_text: \"\"\n";

TEST(XacroPlainYaml, ReadsWhatYamlCppReads) {
  const std::string plain = kPlainFile;
  ASSERT_TRUE(xacro::read_plain_yaml(plain));
  EXPECT_FALSE(xacro::read_plain_yaml(plain + "last: [1]\n"));
  const std::string use = robot(
      "<xacro:property name=\"cfg\" value=\"${xacro.load_yaml('arm.yaml')}\"/>\n"
      "<v all=\"${cfg['arm']}\" mass=\"${cfg.arm.mass}\" reach=\"${cfg.arm.reach}\" "
      "file=\"${cfg.arm.file}\" color=\"${cfg.arm.color}\" max=\"${cfg.arm.max}\" "
      "frame=\"${cfg.arm.link.frame}\" octal=\"${cfg.arm.link.octal}\" count=\"${cfg.count}\" "
      "empty=\"${cfg.empty_text}\" link=\"${cfg.arm.link}\" none=\"${cfg.arm.link.none}\" "
      "nothing=\"${cfg.arm.link.nothing}\" length=\"${cfg.arm.fourth.length}\" "
      "other=\"${cfg.arm.other}\" fourth=\"${cfg.arm.fourth}\"/>");
  const Expanded own(use, {{"arm.yaml", plain}});
  const Expanded theirs(use, {{"arm.yaml", plain + "last: [1]\n"}});
  ASSERT_TRUE(own.expansion.ok() && theirs.expansion.ok());
  EXPECT_EQ(own.text(), theirs.text());
  const auto& mine = own.expansion.root->first_element()->attributes;
  const auto& other = theirs.expansion.root->first_element()->attributes;
  ASSERT_EQ(mine.size(), other.size());
  for (std::size_t i = 0; i < mine.size(); ++i) {
    EXPECT_EQ(mine[i].from.begin, other[i].from.begin) << mine[i].name;
    EXPECT_EQ(mine[i].from.end, other[i].from.end) << mine[i].name;
  }
}

/// Files of keys, values, comments, anchors and aliases at random; most of them are no YAML.
class YamlWriter {
 public:
  explicit YamlWriter(unsigned seed) : random_(seed) {}

  std::string file() {
    text_.clear();
    dictionary(0, 0);
    return text_;
  }

 private:
  std::size_t below(std::size_t bound) { return random_() % bound; }

  void dictionary(std::size_t indentation, int depth) {
    constexpr const char* kKeys[] = {"a", "b", "c", "mass"};
    constexpr const char* kValues[] = {" 1",   " x y", " \"q z\"", " 007", " !degrees 90",
                                       " yes", " 1e3", " 1.5.2",   " ~",   " longer than a word"};
    constexpr int kDeepest = 3;
    for (std::size_t keys = 1 + below(4); keys > 0; --keys) {
      if (below(8) == 0) text_ += "\n      # between\n";
      text_ += std::string(indentation, ' ') + kKeys[below(4)] + ':';
      const std::size_t kind = below(8);
      if (kind < 3) text_ += kValues[below(10)];
      if (kind == 3) text_ += below(2) == 0 ? " *p" : " *q";
      if (kind > 5) text_ += below(2) == 0 ? " &p" : " &q";
      text_ += below(4) == 0 ? "   # *p &q\n" : "\n";
      if (kind > 4 && depth < kDeepest) dictionary(indentation + 1 + below(3), depth + 1);
    }
  }

  std::minstd_rand random_;
  std::string text_;
};

TEST(XacroPlainYaml, ReadsGeneratedFilesAsYamlCppDoes) {
  const std::string use = robot(
      "<xacro:property name=\"cfg\" value=\"${xacro.load_yaml('y.yaml')}\"/>\n"
      "<v all=\"${[(k, cfg[k]) for k in cfg if k != 'last']}\"/>"
      "<v a=\"${cfg.get('a')}\" b=\"${cfg.a.b}\" c=\"${cfg.b.a}\" d=\"${cfg['c']['a']}\"/>");
  const auto shown = [&use](const std::string& yaml) {
    const Expanded made(use, {{"y.yaml", yaml}});
    std::string text = made.text();
    for (const xacro::Node* node = made.expansion.root->first_element(); node != nullptr;
         node = node->next_element()) {
      for (const xacro::NodeAttribute& attribute : node->attributes)
        text +=
            ' ' + std::to_string(attribute.from.begin) + '-' + std::to_string(attribute.from.end);
    }
    return text;
  };
  YamlWriter writer(23);
  std::size_t plain = 0;
  for (int i = 0; i < 2'000; ++i) {
    const std::string yaml = writer.file();
    if (!xacro::read_plain_yaml(yaml)) continue;
    ++plain;
    EXPECT_EQ(shown(yaml), shown(yaml + "last: [1]\n")) << yaml;
  }
  EXPECT_GT(plain, 100U);
}

TEST(XacroPlainYaml, LeavesTheRestToYamlCpp) {
  for (const char* text : {"",
                           "# nothing\n",
                           "a:\n",
                           "a: 1\n b: 2\n",
                           "a: b\n  c\n",
                           "- a\n",
                           "a: [1]\n",
                           "a: {b: 1}\n",
                           "a: &x 1\n",
                           "a: *x\n",
                           "a: &x\nb: 1\n",
                           "a: &x b\n",
                           "a: &\n  b: 1\n",
                           "a: &x!\n  b: 1\n",
                           "a: &x\n  b: 1\nc: *x d\n",
                           "a: &x\n  b: 1\nc: *x*\n",
                           "a: &x\n  b: 1\nc: *\n",
                           "a: |\n  b\n",
                           "a: \"b\\n\"\n",
                           "a: 'it''s'\n",
                           "a: b: c\n",
                           "a: ~\n",
                           "a: \tb\n",
                           "a:b\n",
                           "? a\n",
                           "a: 1\n---\nb: 2\n",
                           "a: 1\r\n",
                           "<<: 1\n",
                           "a: \"b\" c\n",
                           "a:\n  b: 1\n c: 2\n",
                           "%YAML 1.1\n",
                           "null: 1\n",
                           "a: - b\n",
                           "a: ? b\n",
                           "a: !x\n",
                           "a: é\n"}) {
    EXPECT_FALSE(xacro::read_plain_yaml(text)) << text;
  }
}

TEST(XacroPlainYaml, GivesTheEventsOfNestedDictionaries) {
  const auto events = xacro::read_plain_yaml("a:\n  b: 1\nc: x");
  ASSERT_TRUE(events);
  using Kind = xacro::PlainYamlEvent::Kind;
  std::vector<Kind> kinds;
  for (const auto& event : *events) kinds.push_back(event.kind);
  EXPECT_EQ(kinds, (std::vector<Kind>{Kind::kMapStart, Kind::kScalar, Kind::kMapStart,
                                      Kind::kScalar, Kind::kScalar, Kind::kMapEnd, Kind::kScalar,
                                      Kind::kScalar, Kind::kMapEnd}));
}

}  // namespace
}  // namespace rigor::test
