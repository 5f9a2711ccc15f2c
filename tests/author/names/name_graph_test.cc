// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/names/name_graph.h>

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include <rigor/author/names/rename.h>
#include <rigor/read/workspace.h>
#include <rigor/rules/environment.h>
#include <rigor/text/disk.h>

namespace rigor::author {
namespace {

/// Files in memory, and their names.
class NamedFiles {
 public:
  explicit NamedFiles(std::map<std::string, std::string> files)
      : files_(files),
        disk_(std::move(files)),
        environment_(disk_, {}),
        workspace_(environment_.resolver, sources_),
        graph_(workspace_, environment_.resolver) {}

  NameGraph& graph() { return graph_; }

  /// Uses of what has that name in a file, in all files: "path:offset" of each.
  std::vector<std::string> uses(const std::string& path, const std::string& name) {
    std::vector<std::string> places;
    const auto target = graph_.find(path, name);
    if (!target) return places;
    for (const auto& [file, bytes] : files_) {
      for (const NameUse& use : graph_.uses(file)) {
        if (use.target == *target) places.push_back(file + ":" + std::to_string(use.where.begin));
      }
    }
    return places;
  }

  /// The file after a rename; why not, when it is refused.
  std::string renamed(const std::string& path, const std::string& old, const std::string& name) {
    const auto target = graph_.find(path, old);
    if (!target) return "nothing has the name";
    std::vector<std::string> all;
    for (const auto& [file, bytes] : files_) all.push_back(file);
    const Renaming renaming =
        author::renamed({graph_, environment_.resolver, sources_}, *target, name, all);
    if (!renaming.refused.empty()) return renaming.refused;
    std::vector<Edit> own;
    for (const Edit& edit : renaming.edits) {
      if (sources_.path(edit.span.source) == path) own.push_back(edit);
    }
    return apply_edits(files_.at(path), own).value_or("overlap");
  }

 private:
  std::map<std::string, std::string> files_;
  MemoryDisk disk_;
  Environment environment_;
  Sources sources_;
  read::Workspace workspace_;
  NameGraph graph_;
};

std::string sdf_of(const std::string& content) {
  return "<sdf version='1.9'>" + content + "</sdf>";
}

TEST(NameGraph, NamesAreThoseOfTheirScope) {
  const std::string text = sdf_of(
      "<model name='m'><link name='a'/><model name='n'><link name='a'/><frame name='f' "
      "attached_to='a'/></model>"
      "<frame name='g' attached_to='a'/><frame name='h' attached_to='n::a'/></model>");
  NamedFiles files({{"m.sdf", text}});
  EXPECT_EQ(files.uses("m.sdf", "n::a").size(), 3U);
  EXPECT_EQ(
      files.renamed("m.sdf", "n::a", "b"),
      sdf_of(
          "<model name='m'><link name='a'/><model name='n'><link name='b'/><frame name='f' "
          "attached_to='b'/>"
          "</model><frame name='g' attached_to='a'/><frame name='h' attached_to='n::b'/></model>"));
  EXPECT_EQ(files.renamed("m.sdf", "n", "a"), "a link is named 'a' already");
}

TEST(NameGraph, TheModelsOwnPoseIsInTheScopeAroundIt) {
  const std::string text = sdf_of(
      "<world name='w'><frame name='a'/><model name='m'><pose relative_to='a'/><link name='a'>"
      "<pose relative_to='a'/></link></model></world>");
  NamedFiles files({{"w.sdf", text}});
  EXPECT_EQ(
      files.renamed("w.sdf", "a", "b"),
      sdf_of(
          "<world name='w'><frame name='b'/><model name='m'><pose relative_to='b'/><link name='a'>"
          "<pose relative_to='a'/></link></model></world>"));
}

TEST(NameGraph, FrictionDirectionsInAFrame) {
  for (const std::string prefix : {"gz", "ignition"}) {
    const auto text = [&](const std::string& name) {
      return sdf_of("<model name='m'><link name='" + name +
                    "'/><link name='w'><collision><surface>"
                    "<fdir1 " +
                    prefix + ":expressed_in='" + name +
                    "'>1 0 0</fdir1></surface></collision></link></model>");
    };
    NamedFiles files({{"m.sdf", text("a")}});
    EXPECT_EQ(files.renamed("m.sdf", "a", "b"), text("b"));
  }
}

TEST(NameGraph, TheJointOfASensorOfAUrdf) {
  const auto text = [](const std::string& name) {
    return "<robot name='r'><link name='l'/><joint name='" + name +
           "' type='fixed'/><sensor name='j' type='force_torque'><parent joint='" + name +
           "'/></sensor></robot>";
  };
  NamedFiles files({{"r.urdf", text("j")}});
  EXPECT_EQ(files.renamed("r.urdf", "j", "k"),
            "<robot name='r'><link name='l'/><joint name='k' type='fixed'/><sensor name='j' "
            "type='force_torque'><parent joint='k'/></sensor></robot>");
}

/// The link of DetachableJoint's child_model is that model's, which may have the name of one of the plugin's own model.
TEST(NameGraph, ADetachableJointNamesAModelAndItsLink) {
  const auto text = [](const std::string& own, const std::string& model, const std::string& link) {
    return sdf_of("<world name='w'><model name='m'><link name='" + own +
                  "'/><plugin name='p' filename='f'><parent_link>" + own +
                  "</parent_link><child_model>" + model + "</child_model><child_link>" + link +
                  "</child_link></plugin><plugin name='q' filename='f'><parent_link>" + own +
                  "</parent_link><child_model>__model__</child_model><child_link>" + own +
                  "</child_link></plugin></model><model name='" + model + "'><link name='" + link +
                  "'/></model></world>");
  };
  NamedFiles files({{"w.sdf", text("body", "n", "body")}});
  EXPECT_EQ(files.renamed("w.sdf", "n", "k"), text("body", "k", "body"));
  EXPECT_EQ(files.renamed("w.sdf", "m::body", "hull"), text("hull", "n", "body"));
  EXPECT_EQ(files.renamed("w.sdf", "n::body", "hull"), text("body", "n", "hull"));
  const std::string alone =
      "<robot name='r'><link name='a'/><gazebo><plugin name='p' filename='f'><parent_link>a"
      "</parent_link><child_model>box</child_model><child_link>a</child_link></plugin></gazebo>"
      "</robot>";
  NamedFiles robot({{"r.urdf", alone}});
  EXPECT_EQ(robot.uses("r.urdf", "a").size(), 2U);  // not the box's
}

TEST(NameGraph, LevelsNameModels) {
  const auto text = [](const std::string& name) {
    return sdf_of(
        "<world name='w'><plugin name='gz::sim' filename='dummy'><performer name='p'>"
        "<ref>" +
        name + "</ref></performer><level name='l'><ref>" + name +
        "</ref><ref>tile</ref></level></plugin><model name='" + name +
        "'><link name='box'/></model><model name='tile'/></world>");
  };
  NamedFiles files({{"w.sdf", text("box")}});
  EXPECT_EQ(files.renamed("w.sdf", "box", "crate"),
            sdf_of("<world name='w'><plugin name='gz::sim' filename='dummy'><performer name='p'>"
                   "<ref>crate</ref></performer><level name='l'><ref>crate</ref><ref>tile</ref>"
                   "</level></plugin><model name='crate'><link name='box'/></model>"
                   "<model name='tile'/></world>"));
}

TEST(NameGraph, MergedModelsJoinTheScope) {
  NamedFiles files(
      {{"arm.sdf", sdf_of("<model name='arm'><link name='hand'/></model>")},
       {"m.sdf", sdf_of("<model name='m'><include merge='true'><uri>arm.sdf</uri></include>"
                        "<frame name='f' attached_to='hand'/></model>")}});
  EXPECT_EQ(files.uses("m.sdf", "hand").size(), 2U);
  EXPECT_EQ(files.renamed("m.sdf", "hand", "palm").find("attached_to='hand'"), std::string::npos);
}

TEST(NameGraph, AStateNamesModelsAndLinks) {
  NamedFiles files(
      {{"w.sdf",
        sdf_of("<world name='w'><model name='m'><link name='a'/></model><state world_name='w'>"
               "<model name='m'><link name='a'/></model></state></world>")}});
  EXPECT_EQ(files.uses("w.sdf", "m::a").size(), 2U);
  EXPECT_EQ(files.uses("w.sdf", "m").size(), 2U);
}

TEST(NameGraph, LinksAndJointsOfAUrdfMayShareAName) {
  const std::string text =
      "<robot name='r'><link name='a'/><link name='b'/><joint name='b' type='revolute'><parent "
      "link='a'/>"
      "<child link='b'/><mimic joint='c'/></joint><joint name='c' type='fixed'/>"
      "<transmission name='t'><joint name='b'/></transmission>"
      "<gazebo><plugin name='p' "
      "filename='x'><joint_name>b</joint_name><body>b</body><rate>b</rate></plugin></gazebo>"
      "</robot>";
  NamedFiles files({{"r.urdf", text}});
  const std::string after = files.renamed("r.urdf", "b", "z");  // the link, which comes first
  EXPECT_EQ(after,
            "<robot name='r'><link name='a'/><link name='z'/><joint name='b' "
            "type='revolute'><parent link='a'/>"
            "<child link='z'/><mimic joint='c'/></joint><joint name='c' type='fixed'/>"
            "<transmission name='t'><joint name='b'/></transmission>"
            "<gazebo><plugin name='p' "
            "filename='x'><joint_name>b</joint_name><body>z</body><rate>b</rate></plugin>"
            "</gazebo></robot>");
  EXPECT_EQ(files.uses("r.urdf", "c").size(), 2U);
}

TEST(NameGraph, IncludesThatLeadToEachOtherEnd) {
  NamedFiles files(
      {{"a.sdf",
        sdf_of("<model name='a'><include merge='true'><uri>b.sdf</uri></include></model>")},
       {"b.sdf",
        sdf_of("<model name='b'><include merge='true'><uri>a.sdf</uri></include></model>")}});
  EXPECT_EQ(files.uses("a.sdf", "nothing").size(), 0U);
}

TEST(RenameNames, TwoRobotsThatShareAMacroAreRenamedTogether) {
  const std::string ns = " xmlns:xacro='http://www.ros.org/wiki/xacro'";
  const std::string robot =
      "<robot name='r'" + ns +
      "><xacro:include filename='arm.xacro'/><xacro:arm/><link name='t'/>"
      "<joint name='j' type='fixed'><parent link='hand'/><child link='t'/></joint></robot>";
  NamedFiles files(
      {{"arm.xacro",
        "<robot" + ns +
            "><xacro:macro name='arm' params=''><link name='hand'/></xacro:macro></robot>"},
       {"one.urdf.xacro", robot},
       {"two.urdf.xacro", robot}});
  EXPECT_NE(files.renamed("one.urdf.xacro", "hand", "palm").find("parent link='palm'"),
            std::string::npos);
  EXPECT_NE(files.renamed("two.urdf.xacro", "hand", "palm").find("parent link='palm'"),
            std::string::npos);
  EXPECT_NE(files.renamed("one.urdf.xacro", "hand", "palm").find("name='j'"), std::string::npos);
}

}  // namespace
}  // namespace rigor::author
