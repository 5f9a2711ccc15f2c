// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor sdf2urdf` of a model that others are included in: merged, or changed by parameters.

#include <gtest/gtest.h>

#include <string>

#include "cli/conversion_models.h"

namespace rigor::test {
namespace {

/// libsdformat 12 adds, changes and removes what `<experimental:params>` names.
TEST_F(ConversionCli, ParametersOfAnIncludeChangeTheModel) {
  folder.put("models/arm/model.config",
             "<model><name>arm</name><sdf version='1.9'>model.sdf</sdf></model>");
  folder.put("models/arm/model.sdf", arm("revolute"));
  const std::string two =
      "<sdf version='1.9' xmlns:experimental='e'><model name='two'><include>"
      "<uri>model://arm</uri><experimental:params>"
      "<link element_id='tip' action='modify'><inertial><mass>7</mass></inertial></link>"
      "<collision element_id='base' name='skin' action='add'><geometry><sphere>"
      "<radius>0.25</radius></sphere></geometry></collision>"
      "</experimental:params></include></model></sdf>";
  folder.put("two.sdf", two);
  const Ran ran = folder.rigor("sdf2urdf two.sdf --model-path models");
  EXPECT_EQ(ran.exit, 0) << ran.err;
  EXPECT_NE(ran.out.find("<mass value=\"7\"/>"), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("<sphere radius=\"0.25\"/>"), std::string::npos);

  // Of an include in a model that parameters of an include have changed themselves.
  folder.put("models/two/model.config",
             "<model><name>two</name><sdf version='1.9'>model.sdf</sdf></model>");
  folder.put("models/two/model.sdf", two);
  folder.put("three.sdf",
             "<sdf version='1.9' xmlns:experimental='e'><model name='three'><include>"
             "<uri>model://two</uri><experimental:params><frame element_id='' name='mark' "
             "action='add'/></experimental:params></include></model></sdf>");
  const Ran three = folder.rigor("sdf2urdf three.sdf --model-path models");
  EXPECT_EQ(three.exit, 0) << three.err;
  EXPECT_NE(three.out.find("mark"), std::string::npos) << three.out;
  EXPECT_NE(three.out.find("<mass value=\"7\"/>"), std::string::npos) << three.out;
}

/// The frame that merging makes of the included model's own: `ign sdf -g pose` of libsdformat 12 has it
/// between the model and all that refers to it.
TEST_F(ConversionCli, FrameOfAMergedModelCanBeReferredTo) {
  folder.put("models/arm/model.config",
             "<model><name>arm</name><sdf version='1.9'>model.sdf</sdf></model>");
  folder.put("models/arm/model.sdf", arm("revolute"));
  folder.put("m.sdf",
             "<sdf version='1.9'><model name='m'><include merge='true'><uri>model://arm</uri>"
             "<pose>1 0 0 0 0 0</pose></include>"
             "<frame name='f' attached_to='_merged__arm__model__'><pose>0 2 0 0 0 0</pose></frame>"
             "<link name='tool'><pose relative_to='_merged__arm__model__'>0 0 3 0 0 0</pose>"
             "</link><joint name='j' type='fixed'><parent>_merged__arm__model__</parent>"
             "<child>tool</child></joint></model></sdf>");
  const Ran checked = folder.rigor("validate m.sdf --model-path models --compat sdformat");
  EXPECT_EQ(checked.exit, 0) << checked.out;
  const Ran ran = folder.rigor("sdf2urdf m.sdf --model-path models --format concise -o m.urdf");
  EXPECT_EQ(ran.exit, 0) << ran.out << ran.err;
  const std::string urdf = folder.get("m.urdf");
  EXPECT_NE(urdf.find("<child link=\"tool\"/>\n    <origin xyz=\"0 0 3\"/>"), std::string::npos)
      << urdf;
  EXPECT_NE(urdf.find("<child link=\"f\"/>\n    <origin xyz=\"0 2 0\"/>"), std::string::npos)
      << urdf;
}

/// libsdformat 12 leaves each of them out, with an error.
TEST_F(ConversionCli, ParametersOfAnIncludeThatLeadNowhereAreLost) {
  folder.put("models/arm/model.config",
             "<model><name>arm</name><sdf version='1.9'>model.sdf</sdf></model>");
  folder.put("models/arm/model.sdf", arm("revolute"));
  folder.put("two.sdf",
             "<sdf version='1.9' xmlns:experimental='e'><model name='two'><include>"
             "<uri>model://arm</uri><experimental:params>"
             "<collision element_id='nobody' name='skin' action='add'/>"
             "<link element_id='base'><visual name='none' action='remove'/></link>"
             "<joint element_id='shoulder' action='modify'/>"
             "</experimental:params></include></model></sdf>");
  const Ran ran = folder.rigor("sdf2urdf two.sdf --model-path models -o two.urdf");
  EXPECT_EQ(ran.exit, 0) << ran.out << ran.err;
  for (const std::string name : {"collision", "visual", "joint"}) {
    EXPECT_NE(ran.out.find("experimental:params/" + name + ", which does not exist"),
              std::string::npos)
        << name << "\n"
        << ran.out;
  }
}

/// `ign sdf -k` of libsdformat 12.3 rejects each of them, with an error of its own.
TEST_F(ConversionCli, ParametersOfAnIncludeThatAreSkippedAreFindings) {
  folder.put("models/arm/model.config",
             "<model><name>arm</name><sdf version='1.9'>model.sdf</sdf></model>");
  folder.put("models/arm/model.sdf", arm("revolute"));
  const auto validated = [this](const std::string& parameters) {
    folder.put("two.sdf",
               "<sdf version='1.9' xmlns:experimental='e'><model name='two'><include>"
               "<uri>model://arm</uri><experimental:params>" +
                   parameters + "</experimental:params></include></model></sdf>");
    return folder.rigor("validate two.sdf --model-path models --format concise");
  };
  EXPECT_EQ(validated("<link element_id='' name='hand' action='add'/>").exit, 0);
  const Ran exists = validated("<link element_id='' name='tip' action='add'/>");
  EXPECT_EQ(exists.exit, 1);
  EXPECT_NE(exists.out.find("parameter <link>: 'tip' already exists in the included model "
                            "[include-parameter-skipped]"),
            std::string::npos)
      << exists.out;
  const Ran missing = validated("<link element_id='tip'><gravity action='remove'/></link>");
  EXPECT_EQ(missing.exit, 1);
  EXPECT_NE(missing.out.find("parameter <gravity> in <link> of 'tip': the <link> in the included "
                             "model has no such child"),
            std::string::npos)
      << missing.out;
  // What is skipped is not in the model.
  EXPECT_EQ(folder.rigor("inspect two.sdf --model-path models --format tsv").out.find("hand"),
            std::string::npos);
}

}  // namespace
}  // namespace rigor::test
