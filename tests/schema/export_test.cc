// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
#include <rigor/schema/embedded.h>
#include <rigor/schema/export.h>

#include <set>
#include <string>
#include <string_view>
#include <variant>

#include <gtest/gtest.h>

namespace rigor::schema {
namespace {

constexpr std::string_view kSmall = R"(versions 1.0 1.1
define root
  element doc card=1 | Root & <all>.
    attribute kind type=string card=1 enum=a|b | Which.
    attribute scale type=double card=0 default=2 min=0 unit=m | How large.
    use part card=*
define part
  element part type=vector3 card=* since=1.0 deprecated=1.1 | A part.
    attribute name type=string card=0 default="" | Its name.
)";

Schema parse(std::string_view text) { return std::get<Schema>(Schema::parse(text)); }

std::size_t count(std::string_view text, std::string_view part) {
  std::size_t found = 0;
  for (std::size_t i = text.find(part); i != text.npos; i = text.find(part, i + 1)) ++found;
  return found;
}

TEST(Export, XsdOfASmallSchema) {
  const Schema schema = parse(kSmall);
  const std::string xsd = *to_xsd(schema, Version{1}, "doc");
  EXPECT_EQ(count(xsd, "<xs:element name=\"doc\" type=\"doc_1\">"), 1u);
  EXPECT_EQ(count(xsd, "Root &amp; &lt;all&gt;."), 1u);
  EXPECT_EQ(count(xsd, "<xs:attribute name=\"kind\" use=\"required\">"), 1u);
  EXPECT_EQ(count(xsd, "<xs:enumeration value=\"b\"/>"), 1u);
  EXPECT_EQ(count(xsd, "<xs:attribute name=\"scale\" type=\"value_double\" default=\"2\">"), 1u);
  EXPECT_EQ(count(xsd, "How large. Unit: m. Default: 2. At least 0."), 1u);
  EXPECT_EQ(count(xsd, "<xs:element name=\"part\" type=\"part_2\">"), 1u);
  EXPECT_EQ(count(xsd, "<xs:extension base=\"value_vector3\">"), 1u);
  EXPECT_EQ(count(xsd, "A part. Deprecated since 1.1."), 1u);
}

TEST(Export, DocsOfASmallSchema) {
  const Schema schema = parse(kSmall);
  const std::string docs = *to_docs(schema, Version{1}, "doc");
  EXPECT_EQ(count(docs, "\n## doc\n\nRoot & <all>.\n\n- Number: exactly one\n"), 1u);
  EXPECT_EQ(count(docs, "| `kind` | `a`, `b` | exactly one |  |  | Which. |\n"), 1u);
  EXPECT_EQ(count(docs, "| `scale` | double | at most one | `2` | m | How large. |\n"), 1u);
  EXPECT_EQ(count(docs,
                  "\n## doc/part\n\nA part.\n\n- Number: any number\n- Type: vector3\n"
                  "- Deprecated since: 1.1\n"),
            1u);
}

TEST(Export, NothingForAnUnknownRootOrVersion) {
  const Schema schema = parse(kSmall);
  EXPECT_EQ(to_xsd(schema, Version{2}, "doc"), std::nullopt);
  EXPECT_EQ(to_xsd(schema, Version{0}, "part"), std::nullopt);
  EXPECT_EQ(to_docs(schema, Version{0}, ""), std::nullopt);
}

TEST(Export, EveryTypeIsWrittenOnceAlthoughBlocksRecur) {
  const Schema schema = parse(sdf_schema_text());
  for (const Version version : schema.versions()) {
    for (const Node root : schema.roots(version)) {
      const std::string xsd = *to_xsd(schema, version, root.name());
      constexpr std::string_view kType = "<xs:complexType name=\"";
      std::set<std::string> names;
      for (std::size_t i = xsd.find(kType); i != xsd.npos; i = xsd.find(kType, i + 1)) {
        const std::size_t begin = i + kType.size();
        const std::string name = xsd.substr(begin, xsd.find('"', begin) - begin);
        EXPECT_TRUE(names.insert(name).second) << name << " is defined twice";
        EXPECT_GE(count(xsd, "type=\"" + name + "\""), 1u) << name << " is not used";
      }
      EXPECT_GT(names.size(), 100u);
      EXPECT_FALSE(to_docs(schema, version, root.name())->empty());
    }
  }
}

}  // namespace
}  // namespace rigor::schema
