// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `<experimental:params>` of an include. What each case makes of the model, and whether it is skipped, is
// what `ign sdf -p` of libsdformat 12.3 printed for it.

#include <gtest/gtest.h>

#include <string>
#include <variant>
#include <vector>

#include <rigor/read/include_parameters.h>
#include <rigor/schema/embedded.h>

namespace rigor::read {
namespace {

const schema::Schema& sdf_schema() {
  static const auto kParsed = schema::Schema::parse(schema::sdf_schema_text());
  return std::get<schema::Schema>(kParsed);
}

const std::string kIncludedModel =
    "<sdf version='1.9'><model name='m'>"
    "<link name='base'><inertial><mass>3</mass></inertial>"
    "<visual name='skin'><geometry><sphere><radius>1</radius></sphere></geometry></visual>"
    "<collision name='hull'><geometry><sphere><radius>2</radius></sphere></geometry></collision>"
    "</link>"
    "<link name='x'><visual name='w'><geometry><box/></geometry></visual></link>"
    "<plugin name='p' filename='libp.so'/>"
    "<model name='sub'><link name='inner'><visual name='iv'/></link></model>"
    "</model></sdf>";

const std::string kBox = "<geometry><box><size>1 1 1</size></box></geometry>";

struct Parameterized {
  std::string bytes;  ///< of the included file, as it is then
  std::vector<ParameterFault> faults;
  std::vector<std::string> details;

  bool has(const std::string& text) const { return bytes.find(text) != std::string::npos; }
  bool is_unchanged() const { return bytes == kIncludedModel; }
};

Parameterized with_parameters(const std::string& parameters,
                              const std::string& model = kIncludedModel) {
  const std::string text =
      "<sdf version='1.9'><model name='top'><include><uri>m</uri>"
      "<experimental:params>" +
      parameters + "</experimental:params></include></model></sdf>";
  const xml::Document source = xml::parse(text, {});
  const xml::Document included = xml::parse(model, {});
  const IncludeChanges changes = with_include_parameters(
      included, source, *source.root()->child("model")->child("include"), sdf_schema());
  Parameterized result{changes.bytes.value_or(model), {}, {}};
  for (const SkippedParameter& skipped : changes.skipped) {
    result.faults.push_back(skipped.fault);
    result.details.push_back(skipped.detail);
  }
  return result;
}

/// Nothing of it is done, for one reason.
void expect_skipped(const std::string& parameters, ParameterFault fault) {
  const Parameterized result = with_parameters(parameters);
  EXPECT_TRUE(result.is_unchanged()) << parameters << "\n" << result.bytes;
  EXPECT_EQ(result.faults, std::vector{fault}) << parameters;
}

TEST(IncludeParameters, AddWhatHasANewName) {
  const auto added =
      with_parameters("<visual element_id='base' name='mark' action='add'>" + kBox + "</visual>");
  EXPECT_TRUE(added.has("<visual name='mark'>"));
  EXPECT_TRUE(added.has("<visual name='skin'>"));
  EXPECT_TRUE(added.faults.empty());
  // A collision may be called as another link's visual, and a plugin as another plugin.
  EXPECT_TRUE(
      with_parameters("<collision element_id='base' name='w' action='add'/>").faults.empty());
  EXPECT_TRUE(with_parameters("<plugin element_id='' name='p' filename='q' action='add'/>")
                  .has("filename='q'"));
}

TEST(IncludeParameters, DoNotAddANameThatExists) {
  expect_skipped("<visual element_id='base' name='skin' action='add'>" + kBox + "</visual>",
                 ParameterFault::kExists);
  expect_skipped("<link element_id='' name='base' action='add'/>", ParameterFault::kExists);
  expect_skipped(
      "<link element_id='base'><visual name='skin' action='add'>" + kBox + "</visual></link>",
      ParameterFault::kExists);
}

TEST(IncludeParameters, DoNotAddWithoutAName) {
  expect_skipped("<visual element_id='base' action='add'>" + kBox + "</visual>",
                 ParameterFault::kNoName);
  expect_skipped("<visual element_id='base' name='' action='add'/>", ParameterFault::kNoName);
}

TEST(IncludeParameters, ReplaceOnlyByWhatCanBeRead) {
  const auto done = with_parameters("<visual element_id='base::skin' name='new' action='replace'>" +
                                    kBox + "</visual>");
  EXPECT_TRUE(done.has("<visual name='new'>"));
  EXPECT_FALSE(done.has("skin"));
  expect_skipped("<visual element_id='base::skin' action='replace'>" + kBox + "</visual>",
                 ParameterFault::kBadContent);
  expect_skipped("<link element_id='base'><visual action='replace'>" + kBox + "</visual></link>",
                 ParameterFault::kBadContent);
  expect_skipped("<link element_id='base'><joint name='skin' action='replace'/></link>",
                 ParameterFault::kNotAChild);
  expect_skipped("<foo element_id='base' name='base' action='replace'/>",
                 ParameterFault::kNotFound);
}

TEST(IncludeParameters, ContentIsReadAsLenientlyAsByLibsdformat) {
  const auto radius = [](const std::string& value) {
    return "<visual element_id='base' name='n' action='add'><geometry><sphere><radius>" + value +
           "</radius></sphere></geometry></visual>";
  };
  expect_skipped(radius("abc"), ParameterFault::kBadContent);
  expect_skipped(radius(""), ParameterFault::kBadContent);
  EXPECT_TRUE(with_parameters(radius("1.5kg")).faults.empty());
  expect_skipped(
      "<joint element_id='' name='j' type='fixed' action='add'><parent>base</parent></joint>",
      ParameterFault::kBadContent);
  expect_skipped(
      "<joint element_id='' name='j' action='add'><parent>base</parent><child>x</child></joint>",
      ParameterFault::kBadContent);
  expect_skipped("<foo element_id='' name='n' action='add'/>", ParameterFault::kNotSdf);
}

TEST(IncludeParameters, FindNoNameOfOneLetterAtTheStart) {
  expect_skipped("<link element_id='x' action='remove'/>", ParameterFault::kOneLetterName);
  expect_skipped("<visual element_id='x::w' action='remove'/>", ParameterFault::kOneLetterName);
  // What something is added to is found by another way, and what is deeper has something before it.
  EXPECT_TRUE(with_parameters("<visual element_id='x' name='mark' action='add'/>").has("mark"));
  const std::string one_letter =
      "<sdf version='1.9'><model name='m'><link name='base'><visual "
      "name='v'/></link></model></sdf>";
  EXPECT_FALSE(
      with_parameters("<visual element_id='base::v' action='remove'/>", one_letter).has("visual"));
}

TEST(IncludeParameters, FindByTheWholePath) {
  EXPECT_FALSE(with_parameters("<visual element_id='sub::inner::iv' action='remove'/>").has("iv"));
  expect_skipped("<link element_id='m::base' action='remove'/>", ParameterFault::kNotFound);
  expect_skipped("<collision element_id='base::skin' action='remove'/>", ParameterFault::kNotFound);
  expect_skipped("<link element_id='based' action='remove'/>", ParameterFault::kNotFound);
  expect_skipped("<link element_id='base::' action='remove'/>", ParameterFault::kNoLastName);
  expect_skipped("<link action='remove'/>", ParameterFault::kNoElementId);
  // A name may have colons itself: those of included models, in files of SDF 1.6.
  const std::string flat =
      "<sdf version='1.6'><model name='m'><link name='hand::palm'><visual name='v'/></link>"
      "</model></sdf>";
  EXPECT_FALSE(
      with_parameters("<visual element_id='hand::palm::v' action='remove'/>", flat).has("visual"));
}

TEST(IncludeParameters, KnowFourActions) {
  expect_skipped("<link element_id='base' action='delete'/>", ParameterFault::kUnknownAction);
  expect_skipped("<link element_id='base'><visual name='skin' action='x'/></link>",
                 ParameterFault::kUnknownAction);
  expect_skipped("<link element_id='base'><visual name='skin'/></link>", ParameterFault::kNoAction);
}

TEST(IncludeParameters, RemoveTheFirstChildWhereNoneIsNamed) {
  const auto both =
      with_parameters("<link element_id='base' action='remove'><visual/><collision/></link>");
  EXPECT_FALSE(both.has("skin"));
  EXPECT_FALSE(both.has("hull"));
  EXPECT_TRUE(both.faults.empty());
  // libsdformat 12.3 aborts here.
  const auto again =
      with_parameters("<link element_id='base' action='remove'><visual/><visual/></link>");
  EXPECT_EQ(again.faults, std::vector{ParameterFault::kRemovesNothing});
  expect_skipped("<link element_id='base'><light name='none' action='remove'/></link>",
                 ParameterFault::kNotInElement);
}

TEST(IncludeParameters, ModifyWhatIsWritten) {
  const auto mass = [](const std::string& inside) {
    return with_parameters("<link element_id='base' action='modify'>" + inside + "</link>");
  };
  EXPECT_TRUE(mass("<inertial><mass>5</mass></inertial>").has("<mass>5</mass>"));
  // The default, where there is no value.
  EXPECT_FALSE(mass("<inertial><mass/></inertial>").has("<mass>3</mass>"));
  EXPECT_TRUE(mass("<inertial><mass/></inertial>").faults.empty());
  // A name that no child has is a new one for the first.
  EXPECT_TRUE(mass("<visual name='z'/>").has("<visual name='z'>"));

  expect_skipped("<link element_id='base' action='modify'><gravity>0</gravity></link>",
                 ParameterFault::kNotInElement);
  expect_skipped("<link element_id='base' action='modify' foo='1'/>",
                 ParameterFault::kNoSuchAttribute);
  expect_skipped(
      "<link element_id='base' action='modify'><inertial><mass>abc</mass></inertial></link>",
      ParameterFault::kBadValue);
  const auto some = mass("<gravity>0</gravity><inertial><mass>5</mass></inertial>");
  EXPECT_TRUE(some.has("<mass>5</mass>")) << "the rest is done";
  EXPECT_EQ(some.faults, std::vector{ParameterFault::kNotInElement});
}

TEST(IncludeParameters, OneAfterAnotherSeeTheChangesBefore) {
  const auto result = with_parameters(
      "<visual element_id='base::skin'><geometry action='remove'/>"
      "<geometry action='add'><box><size>1 1 1</size></box></geometry></visual>"
      "<link element_id='' name='arm' action='add'/>"
      "<visual element_id='arm' name='mark' action='add'/>");
  EXPECT_TRUE(result.faults.empty());
  EXPECT_TRUE(result.has("<size>1 1 1</size>"));
  EXPECT_TRUE(result.has("mark"));
  EXPECT_FALSE(result.has("<radius>1</radius>"));
}

TEST(IncludeParameters, AreNotFollowedIntoAnIncludeOfTheIncluded) {
  const std::string nested =
      "<sdf version='1.9'><model name='m'><include><uri>n</uri><name>sub</name></include>"
      "</model></sdf>";
  EXPECT_EQ(with_parameters("<link element_id='sub::inner' action='remove'/>", nested).faults,
            std::vector{ParameterFault::kInInclude});
  EXPECT_EQ(with_parameters("<link element_id='other' action='remove'/>", nested).faults,
            std::vector{ParameterFault::kNotFound});
}

}  // namespace
}  // namespace rigor::read
