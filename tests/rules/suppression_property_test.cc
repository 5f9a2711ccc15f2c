// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Random files: what a comment covers is what a search over all tokens says, and what its fixes leave is
// the same model.

#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <rigor/rules/runner.h>
#include <rigor/rules/suppression.h>
#include <rigor/rules/suppression/suppression_comment.h>
#include <rigor/text/edit.h>
#include <rigor/text/sources.h>

namespace rigor::rules {
namespace {

/// A well-formed file of elements, texts and comments, most of which suppress something.
class RandomSuppressions {
 public:
  explicit RandomSuppressions(unsigned seed) : random_(seed) {}

  std::string text() {
    std::string text = one_of({"", "\xEF\xBB\xBF"}) + one_of({"", comment()}) + "<sdf>";
    int depth = 0;
    for (unsigned left = below(20); left > 0; --left) {
      switch (below(8)) {
        case 0:
        case 1:
          text += "<a>";
          ++depth;
          break;
        case 2:
          if (depth > 0) text += "</a>";
          depth -= depth > 0 ? 1 : 0;
          break;
        case 3: text += "<b/>"; break;
        case 4: text += "word"; break;
        default: text += comment();
      }
      text += one_of({"", "\n", " ", "\n  ", "\r\n", "\t"});
    }
    for (; depth > 0; --depth) text += "</a>";
    return text + "</sdf>\n" + one_of({"", comment()});
  }

  unsigned below(std::size_t count) { return static_cast<unsigned>(random_() % count); }

 private:
  std::string one_of(const std::vector<std::string>& choices) {
    return choices[below(choices.size())];
  }

  std::string comment() {
    std::string text = "<!--" + one_of({" rigor: ", "rigor:", "\nrigor:\t", "x rigor: "}) +
                       one_of({"ignore", "ignore", "ignore-next", "file-ignore", "ignroe"}) + "[";
    for (unsigned left = below(4); left > 0; --left) {
      text += one_of({"axis-zero", "unknown-element", "schema", "kinematics", "nope", "all", ""});
      if (left > 1) text += one_of({",", ", "});
    }
    return text + one_of({"] why -->", "]-->"});
  }

  std::mt19937 random_;
};

struct Covered {
  Span span;
  std::string name;
};

/// From each comment to its element, token by token.
std::vector<Covered> searched(const xml::Document& document) {
  std::vector<Covered> covers;
  const std::vector<xml::Token>& tokens = document.tokens();
  const auto is_tag = [&](std::size_t i) {
    return tokens[i].kind == xml::TokenKind::kStartTag ||
           tokens[i].kind == xml::TokenKind::kEmptyTag;
  };
  std::uint32_t elements = 0;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (is_tag(i)) ++elements;
    if (tokens[i].kind != xml::TokenKind::kComment) continue;
    const auto comment = read_suppression(document, tokens[i]);
    if (!comment) continue;
    Span span;
    if (comment->form == SuppressionForm::kFileIgnore) {
      if (elements == 0) span = {document.source(), 0, tokens.back().end};
    } else {
      std::size_t next = i;
      while (next < tokens.size() && !is_tag(next) &&
             tokens[next].kind != xml::TokenKind::kEndTag) {
        ++next;
      }
      if (next < tokens.size() && is_tag(next)) {
        const xml::Element element = document.element(elements);
        span = comment->form == SuppressionForm::kIgnore ? element.span() : element.tag_span();
      }
    }
    for (const Span name : comment->names) {
      covers.push_back({span, std::string(document.bytes().substr(name.begin, name.size()))});
    }
  }
  return covers;
}

using Place = std::pair<std::uint32_t, std::string_view>;

TEST(RandomSuppression, CoversWhatASearchSays) {
  constexpr std::pair<std::string_view, std::string_view> kRules[] = {
      {"axis-zero", "kinematics"}, {"unknown-element", "schema"}, {"mass-zero", "inertia"}};
  std::size_t covered = 0;
  for (unsigned seed = 0; seed < 1000; ++seed) {
    RandomSuppressions random(seed);
    const std::string text = random.text();
    const xml::Document document = xml::parse(text, SourceId{0});
    const std::vector<Covered> covers = searched(document);
    Diagnostics found;
    std::multiset<Place> expected;
    for (int i = 0; i < 12; ++i) {
      const auto& [rule, category] = kRules[random.below(3)];
      const std::uint32_t at = random.below(text.size());
      found.add({.rule = rule, .category = category, .where = {SourceId{0}, at, at + 1}});
      bool hidden = false;
      for (const auto& [span, name] : covers) {
        hidden =
            hidden || (span.begin <= at && at < span.end && (name == rule || name == category));
      }
      if (!hidden) expected.insert({at, rule});
      covered += hidden ? 1 : 0;
    }
    const Diagnostics uncovered = Suppressions(document).uncovered(std::move(found));
    std::multiset<Place> left;
    for (const Diagnostic& one : uncovered.list()) {
      left.insert({one.where.begin, one.rule});
    }
    EXPECT_EQ(left, expected) << text;
  }
  EXPECT_GT(covered, 500U);
}

/// What consumers read: names and texts.
std::vector<std::string> values_in(const std::string& text) {
  const xml::Document document = xml::parse(text, SourceId{0});
  std::vector<std::string> values{document.complete() ? "whole" : "cut"};
  for (std::uint32_t i = 0; i < document.element_count(); ++i) {
    const xml::Element element = document.element(i);
    const bool white = element.text().find_first_not_of(" \t\r\n") == std::string_view::npos;
    values.push_back(std::string(element.name()) + (white ? "" : std::string(element.text())) +
                     (element.lost_text().nowhere() ? "" : " and more"));
  }
  return values;
}

TEST(RandomSuppression, IsFixedInOnePassAndLeavesTheModel) {
  const Registry registry;
  const Runner runner(registry, {});
  std::size_t edited = 0;
  for (unsigned seed = 0; seed < 1000; ++seed) {
    const std::string text = RandomSuppressions(seed).text();
    const auto edits_for = [&](const std::string& bytes) {
      std::vector<Edit> edits;
      const Suppressions suppressions(xml::parse(bytes, SourceId{0}));
      for (const SuppressionFact& fact : suppressions.facts(registry, runner)) {
        append(edits, fact.edits);
      }
      return edits;
    };
    const std::vector<Edit> edits = edits_for(text);
    const auto fixed = apply_edits(text, edits);
    ASSERT_TRUE(fixed) << text;
    EXPECT_EQ(values_in(*fixed), values_in(text)) << text;
    EXPECT_TRUE(edits_for(*fixed).empty()) << text << "\n---\n" << *fixed;
    edited += edits.empty() ? 0 : 1;
  }
  EXPECT_GT(edited, 200U);
}

}  // namespace
}  // namespace rigor::rules
