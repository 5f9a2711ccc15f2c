// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What holds for edits of any file: over random documents in every layout, and over real files.

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/xml/edit.h>
#include <rigor/xml/style.h>

#include "support/corpus.h"
#include "support/part.h"

namespace rigor::xml {
namespace {

using Random = std::mt19937;

int pick(Random& random, int count) {
  return std::uniform_int_distribution<int>(0, count - 1)(random);
}

/// A document in one style, in which some places break it.
class Author {
 public:
  explicit Author(unsigned seed) : random_(seed) {
    constexpr std::string_view kUnits[] = {"  ", "\t", "    ", "   ", " "};
    unit_ = kUnits[pick(random_, 5)];
    end_ = pick(random_, 3) == 0 ? "\r\n" : "\n";
    mark_ = pick(random_, 2) == 0 ? '"' : '\'';
    close_ = pick(random_, 2) == 0 ? "/>" : " />";
    lines_ = pick(random_, 8) != 0;
  }

  std::string document() {
    std::string text = pick(random_, 6) == 0 ? "\xEF\xBB\xBF" : "";
    if (pick(random_, 2) == 0) text += "<?xml version='1.0'?>" + end_;
    text += element(0);
    return text + (pick(random_, 3) == 0 ? "" : end_);
  }

 private:
  std::string line(int depth) {
    if (!lines_ || pick(random_, 12) == 0) return pick(random_, 2) == 0 ? "" : " ";
    std::string text = pick(random_, 15) == 0 ? " \t" : "";  // blanks that nobody sees
    text += pick(random_, 20) == 0 && end_ == "\n" ? "\r\n" : end_;
    if (pick(random_, 15) == 0) text += end_;
    for (int i = 0; i < depth; ++i) text += unit_;
    return text;
  }

  std::string attributes(int depth) {
    std::string text;
    const int count = pick(random_, 4);
    const bool several_lines = pick(random_, 6) == 0;
    for (int i = 0; i < count; ++i) {
      text += several_lines ? line(depth + 2) : " ";
      if (text.back() != ' ' && text.back() != '\t' && text.back() != '\n') text += ' ';
      text += std::string(1, static_cast<char>('p' + i)) + '=' + mark_ + "1 &amp; 2" + mark_;
    }
    return text;
  }

  std::string comment() { return pick(random_, 5) == 0 ? "<!-- two\nlines -->" : "<!-- c -->"; }

  std::string element(int depth) {
    const std::string name(1, static_cast<char>('a' + pick(random_, 6)));
    const std::string tag = '<' + name + attributes(depth);
    const std::string end = "</" + name + (pick(random_, 20) == 0 ? " >" : ">");
    switch (pick(random_, depth == 0 ? 3 : 6)) {
      case 3: return tag + close_;
      case 4: return tag + '>' + (pick(random_, 3) == 0 ? " 5 &lt; 6 " : "5") + end;
      case 5: return tag + '>' + (pick(random_, 3) == 0 ? line(depth) : "") + end;
      default: return tag + '>' + content(depth + 1) + line(depth) + end;
    }
  }

  std::string content(int depth) {
    std::string text = pick(random_, 10) == 0 ? " " + comment() : "";
    if (pick(random_, 25) == 0) text += line(depth) + "words <![CDATA[<more>]]>";
    const int count = depth > 4 ? 0 : pick(random_, 5);
    for (int i = 0; i < count; ++i) {
      if (pick(random_, 6) == 0) text += line(depth) + comment();
      text += line(depth) + element(depth);
      if (pick(random_, 8) == 0) text += " " + comment();
    }
    return text;
  }

  Random random_;
  std::string unit_, end_, close_;
  char mark_ = '"';
  bool lines_ = true;
};

/// What an XML reader takes a document for: tags, comments and text without white space around it.
/// `<a/>` counts as `<a></a>`.
std::vector<std::string> skeleton(const Document& document) {
  constexpr std::string_view kSpace = " \t\r\n";
  std::vector<std::string> parts;
  for (const Token& token : document.tokens()) {
    std::string_view text = document.bytes().substr(token.begin, token.end - token.begin);
    if (token.kind == TokenKind::kEmptyTag) {
      text.remove_suffix(2);
      text = text.substr(0, text.find_last_not_of(kSpace) + 1);
      parts.push_back(std::string(text) + '>');
      parts.push_back("</" + std::string(text.substr(1, text.find_first_of(kSpace) - 1)) + '>');
      continue;
    }
    text = text.substr(std::min(text.find_first_not_of(kSpace), text.size()));
    text = text.substr(0, text.find_last_not_of(kSpace) + 1);
    if (!text.empty()) parts.emplace_back(text);
  }
  return parts;
}

/// The parts that differ, between what two skeletons begin with and what they end with.
struct Difference {
  std::vector<std::string> before, after;
};

Difference difference(const Document& a, const Document& b) {
  std::vector<std::string> before = skeleton(a), after = skeleton(b);
  const auto begin = std::mismatch(before.begin(), before.end(), after.begin(), after.end());
  before.erase(before.begin(), begin.first);
  after.erase(after.begin(), begin.second);
  const auto end = std::mismatch(before.rbegin(), before.rend(), after.rbegin(), after.rend());
  before.erase(end.first.base(), before.end());
  after.erase(end.second.base(), after.end());
  return {before, after};
}

/// A text after edits, and the text read again.
struct Changed {
  Changed(std::string_view bytes, const std::vector<Edit>& edits)
      : text(apply_edits(bytes, edits).value_or("")), document(parse(text, {})) {}

  Element element(std::uint32_t index) const { return document.element(index); }

  std::string text;
  Document document;
};

constexpr std::string_view kNew = "inserted-by-test";

std::optional<Element> find_new(const Document& document) {
  for (std::uint32_t i = 0; i < document.element_count(); ++i) {
    if (document.element(i).name() == kNew) return document.element(i);
  }
  return std::nullopt;
}

std::vector<FaultKind> faults(const Document& document) {
  std::vector<FaultKind> kinds;
  for (const Fault& fault : document.faults()) kinds.push_back(fault.kind);
  return kinds;
}

/// Whether an element holds nothing to stand beside: then its tags change with what is put in.
bool is_bare(const Document& document, Element element) {
  if (is_empty_tag(document, element)) return true;
  const Span tag = element.tag_span();
  const std::string_view inside = document.bytes().substr(tag.end, element.span().end - tag.end);
  const std::size_t first = inside.find_first_not_of(" \t\r\n");
  return inside.substr(first).starts_with("</") &&
         inside.substr(0, first).find('\n') == std::string_view::npos;
}

void check_insert(const Document& document, Element parent, std::optional<Element> after) {
  const std::string xml = '<' + std::string(kNew) + "/>";
  const Changed changed(document.bytes(), insert_child(document, parent, after, xml));
  ASSERT_TRUE(changed.document.complete());
  EXPECT_EQ(faults(changed.document), faults(document));
  const auto [before, added] = difference(document, changed.document);
  EXPECT_TRUE(before.empty());
  EXPECT_EQ(added.size(), 2U);  // <x></x>

  const auto child = find_new(changed.document);
  ASSERT_TRUE(child);
  EXPECT_EQ(child->parent()->index(), parent.index());
  std::optional<std::uint32_t> behind;
  for (const Element sibling : child->parent()->children()) {
    if (sibling == *child) break;
    behind = sibling.index();
  }
  EXPECT_EQ(behind, after ? std::optional(after->index()) : std::nullopt);
  if (after || !is_bare(document, parent)) {
    const Changed back(changed.text, remove_element(changed.document, *child));
    EXPECT_EQ(back.text, document.bytes());
  }
}

void check_set_text(const Document& document, Element element) {
  const std::string value = "0.5 & <more>";
  const Changed changed(document.bytes(), set_text(document, element, value));
  ASSERT_TRUE(changed.document.complete());
  EXPECT_EQ(faults(changed.document), faults(document));
  const std::string_view read = changed.element(element.index()).text();
  EXPECT_NE(read.find(value), std::string_view::npos) << read;
  const auto [before, after] = difference(document, changed.document);
  EXPECT_LE(before.size(), 1U);
  EXPECT_EQ(after.size(), 1U);
  EXPECT_TRUE(set_text(changed.document, changed.element(element.index()), value).empty());
}

void check_set_attribute(const Document& document, Element element, std::string_view name) {
  const std::string value = "it's \"5\" & <6>";
  const Changed changed(document.bytes(), set_attribute(document, element, name, value));
  ASSERT_TRUE(changed.document.complete());
  EXPECT_EQ(faults(changed.document), faults(document));
  const Element now = changed.element(element.index());
  ASSERT_TRUE(now.attribute(name));
  EXPECT_EQ(now.attribute(name)->value(), value);
  for (const Attribute attribute : element.attributes()) {
    if (attribute.name() == name) continue;
    EXPECT_EQ(now.attribute(attribute.name())->value(), attribute.value());
  }
  const auto [before, after] = difference(document, changed.document);
  EXPECT_EQ(before.size(), 1U);
  EXPECT_EQ(after.size(), 1U);
  if (!element.attribute(name)) {
    const Changed back(changed.text, remove_attribute(changed.document, *now.attribute(name)));
    EXPECT_EQ(back.text, document.bytes());
  }
}

void check_rename(const Document& document, Element element) {
  const Changed changed(document.bytes(), rename_element(document, element, kNew));
  ASSERT_TRUE(changed.document.complete());
  const Element now = changed.element(element.index());
  EXPECT_EQ(now.name(), kNew);
  const Changed back(changed.text, rename_element(changed.document, now, element.name()));
  EXPECT_EQ(back.text, document.bytes());
}

void check_remove(const Document& document, Element element) {
  const std::vector<Edit> edits = remove_element(document, element);
  const Changed changed(document.bytes(), edits);
  ASSERT_TRUE(changed.document.complete());
  ASSERT_EQ(edits.size(), 1U);
  // Besides white space, the element's own bytes are all that goes.
  const Span span = element.span();
  EXPECT_LE(edits[0].span.begin, span.begin);
  EXPECT_GE(edits[0].span.end, span.end);
  const std::string_view bytes = document.bytes();
  for (std::uint32_t i = edits[0].span.begin; i < edits[0].span.end; ++i) {
    if (i < span.begin || i >= span.end) {
      EXPECT_NE(std::string_view(" \t\r\n").find(bytes[i]), std::string_view::npos);
    }
  }
}

void check_all(const Document& document, Element element, Random& random) {
  check_insert(document, element, std::nullopt);
  std::vector<Element> children;
  for (const Element child : element.children()) children.push_back(child);
  if (!children.empty()) {
    check_insert(
        document, element,
        children[static_cast<std::size_t>(pick(random, static_cast<int>(children.size())))]);
  }
  check_set_text(document, element);
  check_set_attribute(document, element, kNew);
  if (!element.attributes().empty()) {
    check_set_attribute(document, element, (*element.attributes().begin()).name());
  }
  check_rename(document, element);
  if (element.parent()) check_remove(document, element);
}

TEST(EditProperties, HoldForRandomDocuments) {
  for (unsigned seed = 0; seed < 3'000 / test::parts(); ++seed) {
    const std::string text = Author(seed).document();
    const Document document = parse(text, {});
    ASSERT_TRUE(document.complete()) << text;
    Random random(seed);
    for (int i = 0; i < 4; ++i) {
      const auto index =
          static_cast<std::uint32_t>(pick(random, static_cast<int>(document.element_count())));
      check_all(document, document.element(index), random);
      ASSERT_FALSE(HasFailure()) << "seed " << seed << ", element " << index << " of\n" << text;
    }
  }
}

TEST(EditProperties, HoldForRealFiles) {
  RIGOR_NEEDS_CORPUS();
  Random random(1);
  int checked = 0;
  for (const std::string& path : test::corpus_part()) {
    const std::string text = test::read_file(path);
    const Document document = parse(text, {});
    if (!document.complete()) continue;
    for (int i = 0; i < 3; ++i, ++checked) {
      const auto index =
          static_cast<std::uint32_t>(pick(random, static_cast<int>(document.element_count())));
      check_all(document, document.element(index), random);
      ASSERT_FALSE(HasFailure()) << path << ", element " << index << ": "
                                 << document.element(index).name();
    }
  }
  EXPECT_GT(checked, static_cast<int>(test::part_of(1'000)));
}

}  // namespace
}  // namespace rigor::xml
