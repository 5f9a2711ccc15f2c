// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Edits against pairs written by hand, one for each layout that real files have. The properties that
// hold for any file are in edit_property_test.cc.

#include <rigor/xml/edit.h>

#include <gtest/gtest.h>

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include <rigor/xml/style.h>

namespace rigor::xml {
namespace {

Element find(const Document& document, std::string_view name) {
  for (std::uint32_t i = 0; i < document.element_count(); ++i) {
    if (document.element(i).name() == name) return document.element(i);
  }
  ADD_FAILURE() << "no element " << name;
  return document.element(0);
}

using Change = std::function<std::vector<Edit>(const Document&)>;

std::string changed(std::string_view text, const Change& change) {
  const Document document = parse(text, SourceId{3});
  EXPECT_TRUE(document.complete()) << text;
  const auto result = apply_edits(text, change(document));
  EXPECT_TRUE(result) << text;
  return result.value_or("");
}

/// A child of `parent`, as the first one or behind the child `after`.
std::string inserted(std::string_view text, std::string_view parent, std::string_view after,
                     std::string_view xml = "<x/>") {
  return changed(text, [&](const Document& document) {
    std::optional<Element> behind;
    if (!after.empty()) behind = find(document, after);
    return insert_child(document, find(document, parent), behind, xml);
  });
}

std::string removed(std::string_view text, std::string_view name) {
  return changed(text, [&](const Document& document) {
    return remove_element(document, find(document, name));
  });
}

std::string with_text(std::string_view text, std::string_view value) {
  return changed(
      text, [&](const Document& document) { return set_text(document, *document.root(), value); });
}

std::string with_attribute(std::string_view text, std::string_view name, std::string_view value) {
  return changed(text, [&](const Document& document) {
    return set_attribute(document, *document.root(), name, value);
  });
}

TEST(InsertChild, TakesTheIndentationOfTheChildren) {
  EXPECT_EQ(inserted("<a>\n  <b/>\n</a>\n", "a", ""), "<a>\n  <x/>\n  <b/>\n</a>\n");
  EXPECT_EQ(inserted("<a>\n  <b/>\n</a>\n", "a", "b"), "<a>\n  <b/>\n  <x/>\n</a>\n");
  EXPECT_EQ(inserted("<a>\n\t<b/>\n\t<c/>\n</a>", "a", "b"), "<a>\n\t<b/>\n\t<x/>\n\t<c/>\n</a>");
  EXPECT_EQ(inserted("<a>\r\n   <b/>\r\n</a>\r\n", "a", "b"),
            "<a>\r\n   <b/>\r\n   <x/>\r\n</a>\r\n");
}

TEST(InsertChild, TakesTheLineEndOfThePlaceInAMixedFile) {
  EXPECT_EQ(inserted("<a>\n  <b/>\r\n  <c/>\n</a>\r\n", "a", "b"),
            "<a>\n  <b/>\r\n  <x/>\r\n  <c/>\n</a>\r\n");
  EXPECT_EQ(inserted("<a>\n  <b/>\r\n  <c/>\n</a>\r\n", "a", ""),
            "<a>\n  <x/>\n  <b/>\r\n  <c/>\n</a>\r\n");
}

TEST(InsertChild, IndentsEachLevelAsTheAuthorDoes) {
  constexpr std::string_view kTwoLevels = "<x>\n  <y>1</y>\n</x>";
  EXPECT_EQ(inserted("<a>\n\t<b>\n\t\t<c/>\n\t</b>\n</a>", "a", "b", kTwoLevels),
            "<a>\n\t<b>\n\t\t<c/>\n\t</b>\n\t<x>\n\t\t<y>1</y>\n\t</x>\n</a>");
  EXPECT_EQ(inserted("<a>\n    <b/>\n</a>", "a", "", kTwoLevels),
            "<a>\n    <x>\n        <y>1</y>\n    </x>\n    <b/>\n</a>");
  EXPECT_EQ(inserted("<a>\n    <b/>\n</a>", "a", "b", "<x/>\n<y/>"),
            "<a>\n    <b/>\n    <x/>\n    <y/>\n</a>");
  // The file is laid out with four, this model with two.
  EXPECT_EQ(inserted("<w>\n    <m>\n      <l/>\n    </m>\n</w>", "l", ""),
            "<w>\n    <m>\n      <l>\n        <x/>\n      </l>\n    </m>\n</w>");
}

TEST(InsertChild, GivesAnEmptyElementAnEndTag) {
  EXPECT_EQ(inserted("<a>\n  <b name=\"n\"/>\n</a>", "b", ""),
            "<a>\n  <b name=\"n\">\n    <x/>\n  </b>\n</a>");
  EXPECT_EQ(inserted("<a>\n  <b name='n' />\n</a>", "b", ""),
            "<a>\n  <b name='n'>\n    <x />\n  </b>\n</a>");
  EXPECT_EQ(inserted("<a>\r\n\t<b\r\n\t\tname='n'\r\n\t/>\r\n</a>", "b", "", "<x></x>"),
            "<a>\r\n\t<b\r\n\t\tname='n'>\r\n\t\t<x></x>\r\n\t</b>\r\n</a>");
  EXPECT_EQ(inserted("<a><b/></a>", "b", ""), "<a><b><x/></b></a>");
}

TEST(InsertChild, OpensAnElementThatHoldsNothing) {
  EXPECT_EQ(inserted("<a>\n  <b></b>\n</a>", "b", ""), "<a>\n  <b>\n    <x/>\n  </b>\n</a>");
  EXPECT_EQ(inserted("<a>\n  <b> </b>\n</a>", "b", ""), "<a>\n  <b>\n    <x/>\n  </b>\n</a>");
  EXPECT_EQ(inserted("<a>\n  <b>\n  </b>\n</a>", "b", ""), "<a>\n  <b>\n    <x/>\n  </b>\n</a>");
  EXPECT_EQ(inserted("<a><b></b></a>", "b", ""), "<a><b><x/></b></a>");
}

TEST(InsertChild, StaysInTheLineOfItsSiblings) {
  EXPECT_EQ(inserted("<a><b/><c/></a>\n", "a", ""), "<a><x/><b/><c/></a>\n");
  EXPECT_EQ(inserted("<a><b/><c/></a>\n", "a", "c"), "<a><b/><c/><x/></a>\n");
  EXPECT_EQ(inserted("<a> <b/> <c/> </a>\n", "a", ""), "<a> <x/> <b/> <c/> </a>\n");
  EXPECT_EQ(inserted("<a> <b/> <c/> </a>\n", "a", "c"), "<a> <b/> <c/> <x/> </a>\n");
  EXPECT_EQ(inserted("<a>\n  <b/> <c/>\n</a>\n", "a", "b"), "<a>\n  <b/> <x/> <c/>\n</a>\n");
  EXPECT_EQ(inserted("<a> <b/></a>", "a", "b", "<x>\n  <y/>\n</x>"), "<a> <b/> <x> <y/> </x></a>");
}

TEST(InsertChild, BeginsALineBehindTheLastOfALine) {
  EXPECT_EQ(inserted("<a>\n  <b/><c/>\n</a>\n", "a", "c"), "<a>\n  <b/><c/>\n  <x/>\n</a>\n");
  EXPECT_EQ(inserted("<a>\n  <b/></a>\n", "a", "b"), "<a>\n  <b/>\n  <x/></a>\n");
}

TEST(InsertChild, LeavesCommentsWhereTheyBelong) {
  EXPECT_EQ(inserted("<a>\n  <b/> <!-- of b -->\n</a>", "a", "b"),
            "<a>\n  <b/> <!-- of b -->\n  <x/>\n</a>");
  EXPECT_EQ(inserted("<a> <!-- of a --> <!-- too -->\n  <b/>\n</a>", "a", ""),
            "<a> <!-- of a --> <!-- too -->\n  <x/>\n  <b/>\n</a>");
  EXPECT_EQ(inserted("<a>\n  <b/>\n  <!-- of c -->\n  <c/>\n</a>", "a", "b"),
            "<a>\n  <b/>\n  <x/>\n  <!-- of c -->\n  <c/>\n</a>");
  EXPECT_EQ(inserted("<a>\n     <!-- only -->\n</a>", "a", ""),
            "<a>\n     <x/>\n     <!-- only -->\n</a>");
  EXPECT_EQ(inserted("<a><!-- only --></a>", "a", ""), "<a><x/><!-- only --></a>");
  EXPECT_EQ(inserted("<a>\n  <b/><!-- two\n  lines -->\n</a>", "a", "b"),
            "<a>\n  <b/><x/><!-- two\n  lines -->\n</a>");
}

TEST(InsertChild, LeavesTextInFront) {
  EXPECT_EQ(inserted("<a>5</a>", "a", ""), "<a>5<x/></a>");
  EXPECT_EQ(inserted("<a>\n  5\n  <b/>\n</a>", "a", ""), "<a>\n  5\n  <x/>\n  <b/>\n</a>");
  EXPECT_EQ(inserted("<a><![CDATA[5]]></a>", "a", ""), "<a><![CDATA[5]]><x/></a>");
}

TEST(InsertChild, TakesQuotesAndEndsOfTheAuthor) {
  constexpr std::string_view kOrigin = "<o xyz=\"0 0 1\"/>";
  EXPECT_EQ(inserted("<a n='1'>\n  <b />\n</a>", "a", "", kOrigin),
            "<a n='1'>\n  <o xyz='0 0 1' />\n  <b />\n</a>");
  EXPECT_EQ(inserted("<a n='1'/>", "a", "", "<o t=\"it's\"/>"),
            "<a n='1'>\n  <o t=\"it's\"/>\n</a>");
  EXPECT_EQ(inserted("<a n='1'/>", "a", "", "<o>say \"x\"</o>"),
            "<a n='1'>\n  <o>say \"x\"</o>\n</a>");
}

TEST(InsertChild, KnowsAByteOrderMark) {
  EXPECT_EQ(inserted("\xEF\xBB\xBF<a></a>\r\n", "a", ""), "\xEF\xBB\xBF<a>\r\n  <x/>\r\n</a>\r\n");
}

TEST(ReplaceElement, KeepsThePlace) {
  const auto replaced = [](std::string_view text) {
    return changed(text, [](const Document& document) {
      return replace_element(document, find(document, "b"), "<x>\n  <y/>\n</x>");
    });
  };
  EXPECT_EQ(replaced("<a>\n\t<b>\n\t</b> <!-- c -->\n</a>"),
            "<a>\n\t<x>\n\t\t<y/>\n\t</x> <!-- c -->\n</a>");
  EXPECT_EQ(replaced("<a><b/> <c/></a>"), "<a><x><y/></x> <c/></a>");
}

TEST(RemoveElement, TakesItsLines) {
  EXPECT_EQ(removed("<a>\n  <b>\n    <c/>\n  </b>\n  <d/>\n</a>", "b"), "<a>\n  <d/>\n</a>");
  EXPECT_EQ(removed("<a>\r\n\t<b/>  \r\n</a>\r\n", "b"), "<a>\r\n</a>\r\n");
  EXPECT_EQ(removed("<a>\n  <b/>\n\n  <c/></a>", "c"), "<a>\n  <b/>\n</a>");
  EXPECT_EQ(removed("<a>\r\n  <b/></a>", "b"), "<a></a>");
}

TEST(RemoveElement, StaysInsideALine) {
  EXPECT_EQ(removed("<a><b/><c/></a>", "b"), "<a><c/></a>");
  EXPECT_EQ(removed("<a> <b/> <c/> </a>", "c"), "<a> <b/> </a>");
  EXPECT_EQ(removed("<a>\n  <b/> <c/>\n</a>", "b"), "<a>\n  <c/>\n</a>");
  EXPECT_EQ(removed("<a>\n  <b/> <c/>\n</a>", "c"), "<a>\n  <b/>\n</a>");
  EXPECT_EQ(removed("<a>a word <b/></a>", "b"), "<a>a word </a>");
}

TEST(RemoveElement, LeavesComments) {
  EXPECT_EQ(removed("<a>\n  <!-- b -->\n  <b/>\n</a>", "b"), "<a>\n  <!-- b -->\n</a>");
  EXPECT_EQ(removed("<a>\n  <b/> <!-- b -->\n</a>", "b"), "<a>\n  <!-- b -->\n</a>");
  EXPECT_EQ(removed("<a>\n  <!-- b --> <b/>\n</a>", "b"), "<a>\n  <!-- b -->\n</a>");
}

TEST(RemoveElement, LeavesTheRoot) { EXPECT_EQ(removed("<a/>", "a"), "<a/>"); }

TEST(SetText, KeepsTheSpaceAround) {
  EXPECT_EQ(with_text("<a>5</a>", "6"), "<a>6</a>");
  EXPECT_EQ(with_text("<a> 5\n</a>", "6"), "<a> 6\n</a>");
  EXPECT_EQ(with_text("<a>\r\n  5 7\r\n</a>", "6"), "<a>\r\n  6\r\n</a>");
  EXPECT_EQ(with_text("<a>5</a>", "x & \"y\" < 'z'"),
            "<a>x &amp; &quot;y&quot; &lt; &apos;z&apos;</a>");
}

TEST(SetText, FillsWhatIsEmpty) {
  EXPECT_EQ(with_text("<a/>", "6"), "<a>6</a>");
  EXPECT_EQ(with_text("<a b='c' />", "6"), "<a b='c'>6</a>");
  EXPECT_EQ(with_text("<a></a >", "6"), "<a>6</a >");
  EXPECT_EQ(with_text("<a>\n</a>", "6"), "<a>6</a>");
}

TEST(SetText, LeavesCommentsAndChildren) {
  EXPECT_EQ(with_text("<a><!-- kg --> 5</a>", "6"), "<a><!-- kg --> 6</a>");
  EXPECT_EQ(with_text("<a>5 <!-- kg --></a>", "6"), "<a>6 <!-- kg --></a>");
  EXPECT_EQ(with_text("<a><!-- kg --></a>", "6"), "<a>6<!-- kg --></a>");
  EXPECT_EQ(with_text("<a>\n  <b/>\n</a>", "6"), "<a>6\n  <b/>\n</a>");
  EXPECT_EQ(with_text("<a><![CDATA[5]]></a>", "<"), "<a>&lt;</a>");
}

TEST(SetText, DoesNothingWhereItReadsSo) {
  EXPECT_EQ(with_text("<a> &#54; </a>", "6"), "<a> &#54; </a>");
  EXPECT_EQ(with_text("<a/>", ""), "<a/>");
}

TEST(SetAttribute, KeepsQuotesAndPlace) {
  EXPECT_EQ(with_attribute("<a b = '1' c=\"2\"/>", "b", "it's"), "<a b = 'it&apos;s' c=\"2\"/>");
  EXPECT_EQ(with_attribute("<a b='&#49;'/>", "b", "1"), "<a b='&#49;'/>");
  EXPECT_EQ(with_attribute("<a b=''/>", "b", "1"), "<a b='1'/>");
}

TEST(SetAttribute, AddsBehindTheLast) {
  EXPECT_EQ(with_attribute("<a/>", "n", "1"), "<a n=\"1\"/>");
  EXPECT_EQ(with_attribute("<a b='1' />", "n", "1"), "<a b='1' n='1' />");
  EXPECT_EQ(with_attribute("<a\n    b='1'\n    c=\"2\" />", "n", "1"),
            "<a\n    b='1'\n    c=\"2\"\n    n=\"1\" />");
  EXPECT_EQ(with_attribute("<a><b c='1'/></a>", "n", "1"), "<a n='1'><b c='1'/></a>");
}

TEST(SetAttributes, AddsInTheOrderGiven) {
  const std::string text = "<a b='1' c='2'/>";
  EXPECT_EQ(
      changed(
          text,
          [](const Document& document) {
            return set_attributes(document, *document.root(), {{"y", "8"}, {"c", "3"}, {"x", "9"}});
          }),
      "<a b='1' c='3' y='8' x='9'/>");
}

TEST(RemoveAttribute, TakesTheSpaceBefore) {
  const auto without_b = [](std::string_view text) {
    return changed(text, [](const Document& document) {
      return remove_attribute(document, *document.root()->attribute("b"));
    });
  };
  EXPECT_EQ(without_b("<a b='1'/>"), "<a/>");
  EXPECT_EQ(without_b("<a b='1' />"), "<a />");
  EXPECT_EQ(without_b("<a\n  b='1'\n  c='2'></a>"), "<a\n  c='2'></a>");
  EXPECT_EQ(without_b("<a b='1'c='2'/>"), "<a c='2'/>");
}

TEST(RenameElement, RenamesBothTags) {
  const auto renamed = [](std::string_view text) {
    return changed(text, [](const Document& document) {
      return rename_element(document, *document.root(), "sdf");
    });
  };
  EXPECT_EQ(renamed("<gazebo v='1'><gazebo/></gazebo >"), "<sdf v='1'><gazebo/></sdf >");
  EXPECT_EQ(renamed("<gazebo v='1' />"), "<sdf v='1' />");
}

TEST(Edit, NeverTouchesACutDocument) {
  for (const std::string_view text : {"<a b='1'><c>5</c>", "<a b='1'><c>5</c></a></d>"}) {
    const Document document = parse(text, {});
    const Element a = *document.root();
    const Element c = *a.child("c");
    EXPECT_TRUE(insert_child(document, a, c, "<x/>").empty());
    EXPECT_TRUE(replace_element(document, c, "<x/>").empty());
    EXPECT_TRUE(remove_element(document, c).empty());
    EXPECT_TRUE(set_text(document, c, "6").empty());
    EXPECT_TRUE(set_attribute(document, a, "b", "2").empty());
    EXPECT_TRUE(remove_attribute(document, *a.attribute("b")).empty());
    EXPECT_TRUE(rename_element(document, a, "x").empty());
  }
}

TEST(Edit, NamesTheSource) {
  const Document document = parse("<a>\n  <b/>\n</a>", SourceId{9});
  for (const Edit& edit : insert_child(document, *document.root(), std::nullopt, "<x/>")) {
    EXPECT_EQ(edit.span.source, SourceId{9});
  }
}

}  // namespace
}  // namespace rigor::xml
