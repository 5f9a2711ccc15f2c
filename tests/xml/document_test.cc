// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/xml/document.h>

#include <gtest/gtest.h>
#include <tinyxml2.h>

#include <array>
#include <random>
#include <string>
#include <string_view>

#include "support/corpus.h"

namespace rigor::xml {
namespace {

/// What the author of a document wrote, put together again from its tokens.
std::string joined(const Document& document) {
  std::string text;
  for (const Token& token : document.tokens()) {
    EXPECT_EQ(token.begin, text.size()) << "tokens leave a gap or overlap";
    text += document.bytes().substr(token.begin, token.end - token.begin);
  }
  return text;
}

std::vector<FaultKind> kinds(const Document& document) {
  std::vector<FaultKind> result;
  for (const Fault& fault : document.faults()) result.push_back(fault.kind);
  return result;
}

std::string at(const Document& document, Span span) {
  return std::string(document.bytes().substr(span.begin, span.size()));
}

TEST(Document, SpansAreTheBytesThatWereWritten) {
  const std::string text = "<a one='1'>\n  <b two=\"&lt;2\" >t&amp;u</b >\n  <c/>\n</a>\n";
  const Document document = parse(text, SourceId{7});
  ASSERT_TRUE(document.root());
  const Element a = *document.root();
  EXPECT_EQ(a.name(), "a");
  EXPECT_EQ(at(document, a.span()), text.substr(0, text.size() - 1));
  EXPECT_EQ(at(document, a.tag_span()), "<a one='1'>");
  EXPECT_EQ(at(document, a.attribute("one")->value_span()), "1");
  EXPECT_EQ(at(document, a.attribute("one")->span()), "one='1'");
  EXPECT_EQ(a.tag_span().source, SourceId{7});

  const Element b = *a.child("b");
  EXPECT_EQ(at(document, b.span()), "<b two=\"&lt;2\" >t&amp;u</b >");
  EXPECT_EQ(b.attribute("two")->value(), "<2");
  EXPECT_FALSE(b.attribute("two")->verbatim());
  EXPECT_EQ(b.text(), "t&u");
  EXPECT_EQ(at(document, b.text_span()), "t&amp;u");
  EXPECT_EQ(b.parent()->name(), "a");

  const Element c = *a.child("c");
  EXPECT_EQ(at(document, c.span()), "<c/>");
  EXPECT_EQ(c.text(), "");
  EXPECT_TRUE(document.complete());
  EXPECT_EQ(joined(document), text);
}

TEST(Document, KnowsTheElementAroundEachByte) {
  const std::string text = " <a><b x='1'>t</b> <c/><d><e>u";  // and all are cut
  const Document document = parse(text, {});
  const std::string around = " aaabbbbbbbbbbbbbbaccccdddeeee";
  for (std::uint32_t at = 0; at < text.size(); ++at) {
    const auto element = document.element_at(at);
    const std::string name = element ? std::string(element->name()) : " ";
    EXPECT_EQ(name[0], around[at]) << at;
  }
}

TEST(Document, ValueIsTheFirstRunOfTextAfterComments) {
  const std::string text = "<a><!-- x -->5<!-- y -->6</a>";
  const Document document = parse(text, {});
  EXPECT_EQ(document.root()->text(), "5");
  EXPECT_EQ(at(document, document.root()->lost_text()), "6");
}

struct Case {
  const char* text;
  std::vector<FaultKind> kinds;
  const char* where;
};

TEST(Document, NamesEachFaultWhereItStands) {
  const std::vector<Case> cases{
      {"", {FaultKind::kEmpty}, ""},
      {"<!-- only -->", {FaultKind::kEmpty}, ""},
      {"<a><b></a>", {FaultKind::kMismatchedEnd}, "</a>"},
      {"<a><b>", {FaultKind::kUnclosedElement}, ""},
      {"<a>< b/></a>", {FaultKind::kBadTag}, "<"},
      {"<a b/>", {FaultKind::kBadAttribute}, "b"},
      {"<a b=c/>", {FaultKind::kBadAttribute}, "b"},
      {"<a b='c/>", {FaultKind::kUnclosedValue}, "'"},
      {"<a b='c'", {FaultKind::kUnclosedTag}, "<a"},
      {"<a><!-- x", {FaultKind::kUnclosedMarkup}, "<!--"},
      {"<a/></b>", {FaultKind::kUnexpectedEnd}, "</b>"},
      {"<a b='1' b='2'/>", {FaultKind::kDuplicateAttribute}, "b"},
      {"<!-- x --><?xml version='1.0'?><a/>",
       {FaultKind::kDeclarationNotFirst},
       "<?xml version='1.0'?>"},
      {" <?xml version='1.0'?><a/>", {FaultKind::kDeclarationNotFirst}, "<?xml version='1.0'?>"},
      {"<a/><b/>", {FaultKind::kSecondRoot}, "b"},
      {"<a/> x <!-- y -->", {FaultKind::kTextOutsideRoot}, "x"},
      {"<a/> x ", {FaultKind::kRefused}, "x"},
      {"<a>&nbsp;</a>", {FaultKind::kUndefinedEntity}, "&nbsp;"},
      {"<a>b & c</a>", {FaultKind::kUndefinedEntity}, "&"},
      {"<a>\xE9</a>", {FaultKind::kNotUtf8}, "\xE9"},
      {"<a>\x01</a>", {FaultKind::kControlCharacter}, "\x01"},
      {"<n:a/>", {FaultKind::kUnboundPrefix}, "n"},
      {"<a xmlns:n='u'><n:b n:c='1'/></a>", {}, nullptr},
      {"<!DOCTYPE a [<!ENTITY b '>'>]><a/>",
       {FaultKind::kDoctype},
       "<!DOCTYPE a [<!ENTITY b '>'>]>"},
      {"<a><!-- b -- c --></a>", {FaultKind::kHyphensInComment}, "--"},
      {"<a b='<'/>", {FaultKind::kAngleInValue}, "<"},
      {"<a b='1'c='2'/>", {FaultKind::kNoSpaceBetween}, "c='2'"},
      {"\xEF\xBB\xBF<?xml version='1.0'?><a/>", {}, nullptr},
      {"\xFF\xFE<", {FaultKind::kUtf16}, "\xFF\xFE"},
  };
  for (const Case& one : cases) {
    const std::string text = one.text;
    const Document document = parse(text, {});
    EXPECT_EQ(kinds(document), one.kinds) << text;
    if (one.where != nullptr && !document.faults().empty()) {
      EXPECT_EQ(at(document, document.faults().front().where), one.where) << text;
    }
    EXPECT_EQ(joined(document), text);
  }
}

TEST(Document, KeepsWhatStandsBeforeTheDamage) {
  const Document document = parse("<a><b c='1'/><d>", {});
  EXPECT_FALSE(document.complete());
  EXPECT_EQ(document.root()->child("b")->attribute("c")->value(), "1");
  EXPECT_TRUE(document.root()->cut());
  EXPECT_TRUE(document.root()->child("d")->cut());
  EXPECT_FALSE(document.root()->child("b")->cut());
}

TEST(Document, HostileInputCostsLittle) {
  std::string open;
  for (int i = 0; i < 1'000'000; ++i) open += "<a>";
  EXPECT_EQ(kinds(parse(open, {})).front(), FaultKind::kTooDeep);

  const std::string value = "<a b='" + std::string(20'000'000, 'x') + "'/>";
  EXPECT_EQ(parse(value, {}).root()->attribute("b")->value().size(), 20'000'000U);

  std::string attributes = "<a";
  for (int i = 0; i < 100'000; ++i) attributes += " b" + std::to_string(i) + "=''";
  EXPECT_EQ(kinds(parse(attributes + "/>", {})).front(), FaultKind::kTooMany);

  const std::string ampersands = "<a>" + std::string(1'000'000, '&') + "</a>";
  const Document entities = parse(ampersands, {});
  EXPECT_LE(entities.faults().size(), kMaxFaultsOfKind);

  std::string bomb = "<!DOCTYPE a [<!ENTITY b 'bbbbbbbb'>";
  for (char c = 'c'; c < 'z'; ++c) {
    bomb += std::string("<!ENTITY ") + c + " '&" + char(c - 1) + ";&" + char(c - 1) + ";'>";
  }
  EXPECT_EQ(parse(bomb + "]><a>&y;</a>", {}).root()->text(), "&y;");
}

TEST(Document, TokensOfRandomTextJoinToTheText) {
  std::mt19937 random(20261121);
  const std::string alphabet = "<>/='\" ab&;!-[]?\n\xC3\xA9\x80";
  for (int round = 0; round < 20'000; ++round) {
    std::string text = round % 2 == 0 ? "<a>" : "";
    const std::size_t size = random() % 60;
    while (text.size() < size) text += alphabet[random() % alphabet.size()];
    EXPECT_EQ(joined(parse(text, {})), text);
  }
}

/// The same names, attributes and values, element by element, as tinyxml2 gives its consumers.
void expect_same(Element ours, const tinyxml2::XMLElement& theirs) {
  ASSERT_EQ(ours.name(), theirs.Name());
  const tinyxml2::XMLAttribute* attribute = theirs.FirstAttribute();
  for (const Attribute our_attribute : ours.attributes()) {
    ASSERT_NE(attribute, nullptr);
    ASSERT_EQ(our_attribute.name(), attribute->Name());
    ASSERT_EQ(our_attribute.value(), attribute->Value());
    attribute = attribute->Next();
  }
  ASSERT_EQ(attribute, nullptr);
  const char* text = theirs.GetText();
  ASSERT_EQ(ours.text(), text == nullptr ? "" : text) << theirs.GetLineNum();
  const tinyxml2::XMLElement* child = theirs.FirstChildElement();
  for (const Element our_child : ours.children()) {
    ASSERT_NE(child, nullptr);
    expect_same(our_child, *child);
    child = child->NextSiblingElement();
  }
  ASSERT_EQ(child, nullptr);
}

/// What tinyxml2 refuses, no consumer reads: then it is never read whole, whether it was asked or not.
void expect_refused_as_by_tinyxml2(const std::string& text) {
  tinyxml2::XMLDocument theirs;
  if (theirs.Parse(text.data(), text.size()) == tinyxml2::XML_SUCCESS) return;
  EXPECT_FALSE(parse(text, {}).complete()) << text;
}

TEST(Document, RefusesWhatTinyxml2Refuses) {
  // Of pieces of markup, so that what is whole is not rare.
  const std::array<std::string_view, 26> pieces{"<a>",
                                                "</a>",
                                                "<b c='1'>",
                                                "</b>",
                                                "<b/>",
                                                "<!--",
                                                "-->",
                                                "<![CDATA[",
                                                "]]>",
                                                "<?xml version='1.0'?>",
                                                "<?p q?>",
                                                "<!D>",
                                                "&lt;",
                                                "&",
                                                " ",
                                                "\n",
                                                "x",
                                                "<a ",
                                                "d=\"2\"",
                                                "'",
                                                ">",
                                                "/",
                                                "\f",
                                                "\xc3\xa9",
                                                "\xef\xbb\xbf",
                                                std::string_view("\0", 1)};
  std::mt19937 random(3);
  int whole = 0;
  for (int round = 0; round < 60'000; ++round) {
    std::string text = round % 2 == 0 ? "<a>" : "";
    for (std::size_t count = random() % 8; count > 0; --count)
      text += pieces[random() % pieces.size()];
    if (round % 2 == 0) text += "</a>";
    expect_refused_as_by_tinyxml2(text);
    whole += parse(text, {}).complete() ? 1 : 0;
  }
  EXPECT_GT(whole, 1000);
}

TEST(Document, RefusesWhatTinyxml2RefusesOfADamagedModel) {
  const std::string model = test::read_file(RIGOR_TESTDATA "models/my_robot/model.sdf");
  std::mt19937 random(4);
  for (int round = 0; round < 3'000; ++round) {
    std::string damaged = model;
    for (std::size_t count = random() % 3 + 1; count > 0; --count) {
      const std::size_t at = random() % damaged.size();
      switch (random() % 3) {
        case 0: damaged[at] = static_cast<char>(random()); break;
        case 1: damaged.erase(at, random() % 20); break;
        default: damaged.insert(at, model.substr(random() % model.size(), random() % 20));
      }
    }
    expect_refused_as_by_tinyxml2(damaged);
  }
}

TEST(DocumentCorpus, ReadsRealFilesLosslesslyAndAsTinyxml2Does) {
  RIGOR_NEEDS_CORPUS();
  int compared = 0;
  for (const std::string& path : test::corpus_models()) {
    SCOPED_TRACE(path);
    const std::string text = test::read_file(path);
    const Document document = parse(text, {});
    ASSERT_EQ(joined(document), text);
    tinyxml2::XMLDocument theirs;
    const bool taken = theirs.Parse(text.data(), text.size()) == tinyxml2::XML_SUCCESS;
    if (!taken) {
      EXPECT_FALSE(document.complete());
    } else if (document.complete() && theirs.RootElement() != nullptr) {
      expect_same(*document.root(), *theirs.RootElement());
      ++compared;
    }
  }
  EXPECT_GT(compared, 1500);
}

TEST(DocumentCorpus, CutFilesAreReadAsFarAsTheyGo) {
  RIGOR_NEEDS_CORPUS();
  const auto paths = test::corpus_models();
  std::mt19937 random(50);
  for (int file = 0; file < 50; ++file) {
    const std::string& path = paths[random() % paths.size()];
    const std::string text = test::read_file(path);
    for (int cut = 0; cut < 200; ++cut) {
      const std::string part = text.substr(0, random() % (text.size() + 1));
      EXPECT_EQ(joined(parse(part, {})), part) << path << " cut at " << part.size();
    }
  }
}

}  // namespace
}  // namespace rigor::xml
