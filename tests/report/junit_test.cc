// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/junit/junit.h>

#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <tinyxml2.h>

#include <report/found.h>

namespace rigor::report {
namespace {

class JunitReport {
 public:
  explicit JunitReport(const Found& found) : text_(junit(found.validation())) {
    EXPECT_EQ(document_.Parse(text_.c_str()), tinyxml2::XML_SUCCESS) << text_;
  }
  const tinyxml2::XMLElement& suites() const { return *document_.FirstChildElement("testsuites"); }
  const tinyxml2::XMLElement& suite() const { return *suites().FirstChildElement("testsuite"); }
  const tinyxml2::XMLElement& only_case() const { return *suite().FirstChildElement("testcase"); }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  tinyxml2::XMLDocument document_;
};

std::string attribute_of(const tinyxml2::XMLElement& element, const char* name) {
  const char* value = element.Attribute(name);
  return value == nullptr ? "" : value;
}

std::vector<std::string> attributes_of_all(const tinyxml2::XMLElement& parent, const char* name) {
  std::vector<std::string> all;
  for (auto* child = parent.FirstChildElement(); child; child = child->NextSiblingElement()) {
    all.push_back(attribute_of(*child, name));
  }
  return all;
}

using Texts = std::vector<std::string>;

TEST(Junit, AFindingIsAFailureWithItsExcerpt) {
  Found found;
  found.folders = {"/ci/repo/robots", "/ci/repo"};
  found.file("arm/model.sdf", "<a>\n <xyz>0 0 0</xyz>")
      .at("0 0 0", {.message = "the axis is 0 0 0", .help = "write another"});
  const JunitReport report(found);
  EXPECT_EQ(attribute_of(report.suites(), "name"), "rigor");
  EXPECT_EQ(attribute_of(report.suites(), "failures"), "1");
  EXPECT_EQ(attribute_of(report.suite(), "name"), "robots/arm/model.sdf");
  const tinyxml2::XMLElement& one = report.only_case();
  EXPECT_EQ(attribute_of(one, "name"), "axis-zero");
  EXPECT_EQ(attribute_of(one, "classname"), "robots.arm.model.sdf");
  EXPECT_EQ(attribute_of(one, "file"), "robots/arm/model.sdf");
  EXPECT_EQ(attribute_of(one, "line"), "2");
  EXPECT_EQ(one.Attribute("time"), nullptr);
  const tinyxml2::XMLElement* failure = one.FirstChildElement("failure");
  ASSERT_NE(failure, nullptr);
  EXPECT_EQ(attribute_of(*failure, "message"), "the axis is 0 0 0");
  EXPECT_EQ(attribute_of(*failure, "type"), "error");
  EXPECT_EQ(std::string(failure->GetText()),
            "arm/model.sdf:2:7: error: the axis is 0 0 0 [axis-zero]\n"
            "  |\n"
            "2 |  <xyz>0 0 0</xyz>\n"
            "  |       ^^^^^\n"
            "  |\n"
            "help: write another\n");
}

TEST(Junit, ACleanFilePasses) {
  Found found;
  found.file("arm.sdf", "x");
  const JunitReport report(found);
  EXPECT_EQ(attribute_of(report.suites(), "tests"), "1");
  EXPECT_EQ(attribute_of(report.suites(), "failures"), "0");
  EXPECT_EQ(attribute_of(report.only_case(), "name"), "rigor");
  EXPECT_TRUE(report.only_case().NoChildren());
}

TEST(Junit, SeveritiesAreOutcomes) {
  Found found;
  found.file("arm.sdf", "x")
      .at("x", {.rule = "xml-not-well-formed", .category = "xml", .message = "no end"})
      .at("x", {.severity = Severity::kWarning, .message = "odd"})
      .at("x", {.rule = "axis-missing", .severity = Severity::kInfo, .message = "know this"});
  const JunitReport report(found);
  EXPECT_EQ(attribute_of(report.suites(), "tests"), "3");
  EXPECT_EQ(attribute_of(report.suites(), "failures"), "1");
  EXPECT_EQ(attribute_of(report.suites(), "errors"), "1");
  const tinyxml2::XMLElement* one = &report.only_case();
  EXPECT_NE(one->FirstChildElement("error"), nullptr);
  one = one->NextSiblingElement();
  EXPECT_EQ(attribute_of(*one->FirstChildElement("failure"), "type"), "warning");
  one = one->NextSiblingElement();
  EXPECT_EQ(one->FirstChildElement("failure"), nullptr);
  ASSERT_NE(one->FirstChildElement("system-out"), nullptr);
  EXPECT_NE(std::string(one->FirstChildElement("system-out")->GetText()).find("know this"),
            std::string::npos);
}

TEST(Junit, EqualCasesAreNumberedAndSuitesSorted) {
  Found found;
  found.file("b.sdf", "x y").at("x", {.message = "it"}).at("y", {.message = "it"});
  found.file("a.sdf", "x").at("x", {.message = "it"});
  const JunitReport report(found);
  EXPECT_EQ(attributes_of_all(report.suites(), "name"), (Texts{"a.sdf", "b.sdf"}));
  EXPECT_EQ(attributes_of_all(report.suite(), "name"), (Texts{"axis-zero"}));
  EXPECT_EQ(attributes_of_all(*report.suite().NextSiblingElement(), "name"),
            (Texts{"axis-zero", "axis-zero[2]"}));
}

TEST(Junit, AFileThatWasLeftOutIsSkipped) {
  Found found;
  found.file("a.sdf", "x");
  found.result.not_looked_at = {{"t.sdf.erb", "template: expand it first"},
                                {"a.sdf", "include of https://example.org/hand"}};
  const JunitReport report(found);
  EXPECT_EQ(attributes_of_all(report.suites(), "name"), (Texts{"a.sdf", "t.sdf.erb"}));
  EXPECT_EQ(attribute_of(report.suites(), "skipped"), "1");
}

TEST(Junit, HoldsOnlyWhatXmlCanHold) {
  Found found;
  found.file("a&b.sdf", "<\x01>").at("\x01", {.message = "is '<\x01\"&\xFF]]>'"});
  const JunitReport report(found);  // parses
  EXPECT_EQ(report.text().find('\x01'), std::string::npos);
  EXPECT_EQ(report.text().find('\xFF'), std::string::npos);
  EXPECT_EQ(attribute_of(report.suite(), "name"), "a&b.sdf");
}

}  // namespace
}  // namespace rigor::report
