// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/sdf_to_urdf.h>
#include <rigor/model/motion.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <string>
#include <vector>

#include "convert/converted.h"
#include "support/corpus.h"
#include "support/part.h"
#include "support/workers.h"

namespace rigor::convert {
namespace {

using test::Converted;
using test::digits_of;
using test::sdf_joint;
using test::sdf_link;

using Files = std::map<std::string, std::string>;
using Names = std::vector<std::string>;

const std::string kTwoLinks = sdf_link("a") + sdf_link("b", "1 0 0.50 0 0 0");

TEST(SdfToUrdf, CarriesTheDigitsOfAPoseThatIsTheOrigin) {
  const Converted robot(sdf_link("a") + sdf_link("b", "1.0 0 0.50 0 0 1.570") +
                        sdf_joint("j", "fixed", "a", "b"));
  EXPECT_EQ(digits_of(robot.joint("j").origin.xyz), "1.0 0 0.50");
  EXPECT_EQ(digits_of(robot.joint("j").origin.rpy), "0 0 1.570");
  EXPECT_EQ(robot.result.model.value, 0U);
}

TEST(SdfToUrdf, CarriesTheDigitsOfAPoseRelativeToTheParent) {
  // The parent's frame is far off and turned, so that the product has noise.
  const Converted robot(
      sdf_link("r") + sdf_link("a", "0.1 0.2 0.3 0.4 0.5 0.6") + sdf_joint("i", "fixed", "r", "a") +
      "<link name='b'><pose relative_to='a'>0.70 0.1 -.3 0.10 0.20 0.30</pose></link>" +
      sdf_joint("j", "fixed", "a", "b"));
  EXPECT_EQ(digits_of(robot.joint("j").origin.xyz), "0.70 0.1 -.3");
  EXPECT_EQ(digits_of(robot.joint("j").origin.rpy), "0.10 0.20 0.30");
}

TEST(SdfToUrdf, WritesSumsAsAHandWould) {
  const Converted robot(sdf_link("r") + sdf_link("a", "0.1 0 0 0 0 0") +
                        sdf_link("b", "0.3 0 0 0 0 0") + sdf_joint("i", "fixed", "r", "a") +
                        sdf_joint("j", "fixed", "a", "b"));
  EXPECT_EQ(digits_of(robot.joint("j").origin.xyz), "0.2 0 0");  // 0.3 - 0.1 is 0.19999999999999998
}

TEST(SdfToUrdf, MovesTheLinkFrameToTheJoint) {
  const Converted robot(sdf_link("a") +
                        "<link name='b'><pose>1 0 0 0 0 0</pose><collision name='c'><pose>0 0 1 0 "
                        "0 0</pose><geometry>"
                        "<sphere><radius>1</radius></sphere></geometry></collision></link>" +
                        sdf_joint("j", "fixed", "a", "b", "<pose>0 0 0.25 0 0 0</pose>"));
  EXPECT_EQ(digits_of(robot.joint("j").origin.xyz), "1 0 0.25");
  EXPECT_EQ(digits_of(robot.result.robot->links[1].collisions[0].origin.xyz), "0 0 0.75");
  ASSERT_EQ(robot.notes(NoteKind::kLinkFrame).size(), 1U);
  EXPECT_EQ(robot.text_at(robot.notes(NoteKind::kLinkFrame)[0]), "0 0 0.25 0 0 0");
}

TEST(SdfToUrdf, KeepsLinkFramesOnDemand) {
  UrdfOptions options;
  options.link_frames = LinkFramePolicy::kKeepLinks;
  const Converted robot(
      kTwoLinks + sdf_joint("j", "fixed", "a", "b", "<pose>0 0 0.25 0 0 0</pose>"), "1.9", options);
  EXPECT_EQ(robot.link_names(), (Names{"a", "b", "b_frame"}));
  EXPECT_EQ(robot.joint("b_frame_joint").parent, "b");
  EXPECT_EQ(digits_of(robot.joint("b_frame_joint").origin.xyz), "0 0 -0.25");
}

TEST(SdfToUrdf, FlattensNestedModelsAndNamesThem) {
  const Converted robot(sdf_link("a") + "<model name='hand'><pose>0 0 2 0 0 0</pose>" +
                        sdf_link("a", "0 0 1 0 0 0") + "</model>" +
                        sdf_joint("j", "fixed", "a", "hand::a"));
  EXPECT_EQ(robot.link_names(), (Names{"a", "hand__a"}));
  EXPECT_EQ(digits_of(robot.joint("j").origin.xyz), "0 0 3");
  EXPECT_EQ(robot.result.links.at("hand::a"), "hand__a");
  ASSERT_EQ(robot.notes(NoteKind::kNested).size(), 1U);
  EXPECT_TRUE(robot.notes(NoteKind::kRenamed).empty());
}

TEST(SdfToUrdf, NamesAreUniqueAndWhoCanKeepItsNameDoes) {
  const Converted robot("<model name='b'>" + sdf_link("c") + "</model>" + sdf_link("b__c") +
                        sdf_link("two words") + sdf_joint("j", "fixed", "b__c", "b::c") +
                        sdf_joint("l", "fixed", "b__c", "two words"));
  EXPECT_EQ(robot.link_names(), (Names{"b__c_2", "b__c", "two_words"}));
  const auto renamed = robot.notes(NoteKind::kRenamed);
  ASSERT_EQ(renamed.size(), 2U);
  EXPECT_EQ(renamed[1].written, "\"two words\"");
  EXPECT_EQ(renamed[1].instead, "two_words");
}

TEST(SdfToUrdf, NoLinkIsTakenForTheWorld) {
  EXPECT_EQ(Converted(sdf_link("world")).link_names(), Names{"world_2"});
}

TEST(SdfToUrdf, AJointOnTheWorldHangsOnALinkOfThatName) {
  const Converted robot(sdf_link("a", "0 0 1 0 0 0") +
                        sdf_joint("j", "revolute", "world", "a", "<axis><xyz>0 0 1</xyz></axis>"));
  EXPECT_EQ(robot.link_names(), (Names{"world", "a"}));
  EXPECT_EQ(robot.joint("j").parent, "world");
  EXPECT_EQ(digits_of(robot.joint("j").origin.xyz), "0 0 1");
  EXPECT_EQ(robot.notes(NoteKind::kWorldLink).size(), 1U);
}

TEST(SdfToUrdf, RefusesSeveralRootsAndListsThem) {
  const Converted robot(kTwoLinks);
  EXPECT_FALSE(robot.result.robot);
  ASSERT_EQ(robot.notes(NoteKind::kSeveralRoots).size(), 1U);
  EXPECT_EQ(robot.notes(NoteKind::kSeveralRoots)[0].written, "a, b");
  EXPECT_EQ(robot.notes(NoteKind::kSeveralRoots)[0].count, 2U);
}

TEST(SdfToUrdf, AddsARootOnDemand) {
  UrdfOptions options;
  options.roots = RootPolicy::kAddRoot;
  const Converted robot(kTwoLinks, "1.9", options);
  EXPECT_EQ(robot.link_names(), (Names{"m_root", "a", "b"}));
  EXPECT_EQ(robot.joint("m_root_to_b").parent, "m_root");
  EXPECT_EQ(digits_of(robot.joint("m_root_to_b").origin.xyz), "1 0 0.50");
}

TEST(SdfToUrdf, TheLinksOfAStaticModelAreFixedToTheWorld) {
  const Converted robot("<static>true</static>" + kTwoLinks);
  EXPECT_EQ(robot.link_names(), (Names{"world", "a", "b"}));
  EXPECT_EQ(robot.joint("world_to_a").type, "fixed");
  ASSERT_EQ(robot.notes(NoteKind::kStatic).size(), 1U);
  EXPECT_EQ(robot.notes(NoteKind::kStatic)[0].outcome, Outcome::kRewritten);
  EXPECT_EQ(robot.result.account.counts[static_cast<std::size_t>(Outcome::kCarried)], 0U);
}

TEST(SdfToUrdf, CutsTheSecondOfTwoParents) {
  const Converted robot(kTwoLinks + sdf_link("c") + sdf_joint("i", "fixed", "a", "b") +
                        sdf_joint("j", "fixed", "a", "c") + sdf_joint("k", "fixed", "b", "c"));
  ASSERT_EQ(robot.result.robot->joints.size(), 2U);
  const auto loops = robot.notes(NoteKind::kLoop);
  ASSERT_EQ(loops.size(), 1U);
  EXPECT_EQ(loops[0].written, "c");
  EXPECT_EQ(loops[0].instead, "j");
  EXPECT_EQ(loops[0].count, 5U);  // joint, name, type, parent, child
}

TEST(SdfToUrdf, SaysWhichJointsWereCutInAComment) {
  UrdfOptions options;
  options.loop = LoopPolicy::kComment;
  const Converted robot(
      kTwoLinks + sdf_joint("i", "fixed", "a", "b") + sdf_joint("j", "revolute", "a", "b"), "1.9",
      options);
  ASSERT_EQ(robot.result.robot->links[1].comments.size(), 1U);
  EXPECT_NE(robot.result.robot->links[1].comments[0].text.find("revolute joint j"),
            std::string::npos);
}

TEST(SdfToUrdf, OpensACircleOfJoints) {
  const Converted robot(kTwoLinks + sdf_link("c") + sdf_joint("i", "fixed", "a", "b") +
                        sdf_joint("j", "fixed", "b", "c") + sdf_joint("k", "fixed", "c", "a"));
  ASSERT_TRUE(robot.result.robot);
  EXPECT_EQ(robot.result.robot->joints.size(), 2U);
  ASSERT_EQ(robot.notes(NoteKind::kNoRoot).size(), 1U);
  EXPECT_EQ(robot.notes(NoteKind::kNoRoot)[0].subject, "m/joint k");
}

TEST(SdfToUrdf, LeavesOutAJointThatConnectsNothing) {
  const Converted robot(sdf_link("a") + sdf_joint("i", "fixed", "a", "nowhere") +
                        sdf_joint("j", "fixed", "a", "a") + sdf_joint("k", "fixed", "a", "world"));
  ASSERT_TRUE(robot.result.robot);
  EXPECT_TRUE(robot.result.robot->joints.empty());
  EXPECT_EQ(robot.notes(NoteKind::kDanglingJoint).size(), 3U);
}

TEST(SdfToUrdf, TellsTheModelsPoseOrWritesIt) {
  const std::string model = "<pose>1 2 3 0 0 0</pose>" + sdf_link("a", "0 0 0.5 0 0 0");
  const Converted dropped(model);
  EXPECT_EQ(dropped.link_names(), Names{"a"});
  ASSERT_EQ(dropped.notes(NoteKind::kModelPose).size(), 1U);
  EXPECT_EQ(dropped.notes(NoteKind::kModelPose)[0].written, "1 2 3 0 0 0");
  ASSERT_EQ(dropped.notes(NoteKind::kRootPose).size(), 1U);

  UrdfOptions options;
  options.model_pose = ModelPosePolicy::kWorldLink;
  const Converted kept(model, "1.9", options);
  EXPECT_EQ(kept.link_names(), (Names{"world", "a"}));
  EXPECT_EQ(digits_of(kept.joint("world_to_a").origin.xyz), "1 2 3.5");
  EXPECT_TRUE(kept.notes(NoteKind::kModelPose).empty());
  EXPECT_TRUE(kept.notes(NoteKind::kRootPose).empty());
}

TEST(SdfToUrdf, TheModelsPlaceInTheWorldIsNotInTheRobot) {
  const std::string links = kTwoLinks + sdf_joint("j", "fixed", "a", "b");
  const Converted here(links);
  const Converted there("<pose>10 20 30 0.1 0.2 0.3</pose>" + links);
  EXPECT_EQ(urdf_text(*here.result.robot), urdf_text(*there.result.robot));
}

TEST(SdfToUrdf, FramesAreLinksOnFixedJoints) {
  const std::string model = sdf_link("a", "0 0 1 0 0 0") +
                            "<frame name='tip' attached_to='a'><pose>0 0 .5 0 0 0</pose></frame>";
  const Converted robot(model);
  EXPECT_EQ(robot.link_names(), (Names{"a", "tip"}));
  EXPECT_EQ(robot.joint("tip_joint").parent, "a");
  EXPECT_EQ(digits_of(robot.joint("tip_joint").origin.xyz), "0 0 .5");

  UrdfOptions options;
  options.frames = FramePolicy::kDrop;
  const Converted dropped(model, "1.9", options);
  EXPECT_EQ(dropped.link_names(), Names{"a"});
  ASSERT_EQ(dropped.notes(NoteKind::kFrame).size(), 1U);
  EXPECT_EQ(dropped.notes(NoteKind::kFrame)[0].outcome, Outcome::kLost);
}

TEST(SdfToUrdf, IncludedModelsAreAccountedForWhereTheyStand) {
  const Converted robot(
      Files{{"robot.sdf", "<sdf version='1.9'><model name='m'>" + sdf_link("a") +
                              "<include><uri>hand.sdf</uri><name>h</name><pose>0 0 1 0 0 0</pose>"
                              "</include>" +
                              sdf_joint("j", "fixed", "a", "h::palm") + "</model></sdf>"},
            {"hand.sdf", "<sdf version='1.9'><model name='hand'><pose>9 9 9 0 0 0</pose>" +
                             sdf_link("palm") + "<odd/></model></sdf>"}});
  EXPECT_EQ(robot.link_names(), (Names{"a", "h__palm"}));
  EXPECT_EQ(digits_of(robot.joint("j").origin.xyz), "0 0 1");
  const auto unknown = robot.notes(NoteKind::kUnknown);
  ASSERT_EQ(unknown.size(), 1U);
  EXPECT_EQ(unknown[0].written, "odd");
  EXPECT_EQ(unknown[0].subject, "m::h");
  EXPECT_EQ(robot.source.sources.path(unknown[0].where.source), "hand.sdf");
}

TEST(SdfToUrdf, RefusesWhatLeadsNowhere) {
  const Converted include(sdf_link("a") + "<include><uri>gone.sdf</uri></include>");
  EXPECT_FALSE(include.result.robot);
  EXPECT_EQ(include.notes(NoteKind::kUnresolved).size(), 1U);
  const Converted pose("<link name='a'><pose relative_to='gone'>0 0 0 0 0 0</pose></link>");
  EXPECT_FALSE(pose.result.robot);
  ASSERT_EQ(pose.notes(NoteKind::kUnresolved).size(), 1U);
  EXPECT_EQ(pose.notes(NoteKind::kUnresolved)[0].written, "gone does not exist");
  const Converted circle(
      "<link name='a'><pose relative_to='f'/></link><frame name='f' attached_to='a'/>");
  EXPECT_FALSE(circle.result.robot);
  ASSERT_FALSE(circle.notes(NoteKind::kUnresolved).empty());
  EXPECT_NE(circle.notes(NoteKind::kUnresolved)[0].written.find("is in a cycle"),
            std::string::npos);
}

TEST(SdfToUrdf, ChoosesTheModel) {
  const std::string world =
      "<sdf version='1.9'><world name='w'><physics name='p' type='ode'/>"
      "<model name='one'>" +
      sdf_link("a") + "</model><model name='two'>" + sdf_link("b") + "</model></world></sdf>";
  EXPECT_EQ(Converted(Files{{"robot.sdf", world}}).notes(NoteKind::kSeveralModels).at(0).written,
            "one, two");
  UrdfOptions options;
  options.model = "two";
  const Converted two(Files{{"robot.sdf", world}}, options);
  EXPECT_EQ(two.link_names(), Names{"b"});
  EXPECT_TRUE(two.notes(NoteKind::kWorld).empty());
  options.model = "three";
  EXPECT_EQ(Converted(Files{{"robot.sdf", world}}, options).notes(NoteKind::kNoModel).at(0).written,
            "three");
  EXPECT_EQ(
      Converted(Files{{"robot.sdf", "<sdf version='1.9'/>"}}).notes(NoteKind::kNoModel).size(), 1U);
}

TEST(SdfToUrdf, TellsWhatAWorldHoldsBesideTheModel) {
  const Converted robot(Files{{"robot.sdf",
                               "<sdf version='1.9'><world name='w'><gravity>0 0 -1</gravity>"
                               "<model name='one'>" +
                                   sdf_link("a") + "</model></world></sdf>"}});
  ASSERT_TRUE(robot.result.robot);
  ASSERT_EQ(robot.notes(NoteKind::kWorld).size(), 1U);
  EXPECT_EQ(robot.notes(NoteKind::kWorld)[0].written, "gravity");
}

// --- The account is complete ---

const std::string& rich_model() {
  static const std::string model =
      "<sdf version='1.9'><model name='m'><pose>1 0 0 0 0 0</pose>" + sdf_link("a") +
      "<link name='b'><pose>0 0 1 0 0 0</pose><inertial><mass>2</mass></inertial><collision "
      "name='c'>"
      "<geometry><box><size>1 1 1</size></box></geometry></collision><visual name='v'><geometry>"
      "<sphere><radius>1</radius></sphere></geometry></visual></link><frame name='f'/>" +
      sdf_joint("j", "revolute", "a", "b",
                "<axis><xyz>0 0 1</xyz><limit><lower>-1</lower><upper>1</upper></limit>"
                "<dynamics><damping>1</damping></dynamics></axis>") +
      "<model name='n'>" + sdf_link("d") + "</model>" + sdf_joint("k", "fixed", "a", "n::d") +
      "</model></sdf>";
  return model;
}

TEST(SdfToUrdf, NothingCanVanishUnseen) {
  // An element that nobody knows, put into each element that holds others.
  const std::string& model = rich_model();
  std::size_t tried = 0;
  for (std::size_t at = model.find("<model"); (at = model.find('>', at)) != std::string::npos;) {
    ++at;
    const std::size_t tag = model.rfind('<', at);
    const bool holds_elements = model[at] == '<' && model[at + 1] != '/' && model[at - 2] != '/';
    if (!holds_elements || model[tag + 1] == '/') continue;
    std::string mutated = model;
    mutated.insert(at, "<zebra/>");
    const Converted robot(Files{{"robot.sdf", mutated}});
    ASSERT_TRUE(robot.result.robot) << mutated;
    std::size_t told = 0;
    for (const Note& note : robot.result.account.notes) {
      if (note.written.find("zebra") != std::string::npos) ++told;
    }
    EXPECT_EQ(told, 1U) << mutated;
    ++tried;
  }
  EXPECT_GT(tried, 15U);
}

std::size_t sum_of_counts(const Account& account) {
  return std::accumulate(account.counts.begin(), account.counts.end(), std::size_t{0});
}

TEST(SdfToUrdf, CountsEveryElementAndAttribute) {
  const Converted robot(Files{{"robot.sdf", rich_model()}});
  const xml::Document& document = robot.source.documents.of(robot.source.loaded.root.source);
  std::size_t nodes = document.element_count() - 1;  // without <sdf>
  for (std::uint32_t i = 1; i < document.element_count(); ++i) {
    for ([[maybe_unused]] const auto attribute : document.element(i).attributes()) ++nodes;
  }
  EXPECT_EQ(sum_of_counts(robot.result.account), nodes);
}

TEST(SdfToUrdf, TheCorpusConverts) {
  RIGOR_NEEDS_CORPUS();
  const RealDisk disk;
  std::size_t converted = 0;
  std::size_t refused = 0;
  for (const std::string& path : test::corpus_part()) {
    const test::ReadRobot source(disk, path);
    if (source.loaded.root.format != model::Format::kSdf) continue;
    const UrdfConversion result =
        sdf_to_urdf({source.loaded.root, source.frames, source.documents, source.resolver,
                     test::sdf_schema(), test::workers(), path},
                    {});
    // Whatever is not converted says why.
    EXPECT_EQ(result.robot.has_value(), sum_of_counts(result.account) > 0) << path;
    EXPECT_TRUE(result.robot || !result.account.notes.empty()) << path;
    if (!result.robot) {
      if (path.find("gazebo_models/") != std::string::npos && !source.loaded.root.links.empty()) {
        ++refused;
      }
      continue;
    }
    EXPECT_EQ(result.robot->links.size(), result.robot->joints.size() + 1) << path;  // a tree
    if (path.find("gazebo_models/") != std::string::npos) ++converted;
  }
  EXPECT_GE(static_cast<double>(converted), 0.9 * static_cast<double>(converted + refused));
}

TEST(SdfToUrdf, ARootWithoutMassIsAddedWhenAsked) {
  UrdfOptions options;
  options.root = "base_footprint";
  const Converted converted(
      sdf_link("base", "0 0 0.1 0 0 0") + sdf_link("arm") + sdf_joint("j", "fixed", "base", "arm"),
      "1.9", options);
  const UrdfRobot& robot = converted.result.robot.value();
  EXPECT_EQ(converted.link_names(), (std::vector<std::string>{"base_footprint", "base", "arm"}));
  EXPECT_FALSE(robot.links[0].inertial);
  const UrdfJoint& up = converted.joint("base_footprint_to_base");
  EXPECT_EQ(up.type, "fixed");
  EXPECT_EQ(digits_of(up.origin.xyz), "0 0 0.1");
  // Where the world is the root already, there is none with a mass.
  const Converted fixed(sdf_link("base") + sdf_joint("j", "fixed", "world", "base"), "1.9",
                        options);
  EXPECT_EQ(fixed.link_names(), (std::vector<std::string>{"world", "base"}));
}

TEST(SdfToUrdf, CommentsGoWithWhatTheyStandBefore) {
  const Converted converted("\n  <!-- the base -->\n" + sdf_link("base") +
                            "\n<!--1-->\n<!--2-->\n" + sdf_joint("j", "fixed", "base", "arm") +
                            " <!-- of the joint -->\n" + sdf_link("arm"));
  const UrdfRobot& robot = converted.result.robot.value();
  EXPECT_EQ(robot.links[0].comments, Remarks{Remark{" the base "}});
  EXPECT_TRUE(robot.links[1].comments.empty());
  EXPECT_EQ(converted.joint("j").comments,
            (Remarks{Remark{"1"}, Remark{"2"}, Remark{" of the joint "}}));
}

/// The joint is at (1, 0, 0) of the wing, turned by 90° about z: in its frame the wing's x is -y, and the
/// wing's origin at (0, 1, 0).
TEST(SdfToUrdf, LiftDragIsToldInTheFrameOfTheJoint) {
  const Converted converted(
      sdf_link("base") + sdf_link("wing", "0 0 1 0 0 0") +
      sdf_joint("hinge", "revolute", "base", "wing",
                "<pose>1 0 0 0 0 1.5707963267948966</pose><axis><xyz>0 0 1</xyz><limit><lower>-1"
                "</lower><upper>1</upper><effort>1</effort><velocity>1</velocity></limit></axis>") +
      "<plugin name='lift' filename='gz-sim-lift-drag-system'><link_name>wing</link_name>"
      "<cp>0.5 0 0</cp><forward>1 0 0</forward><upward>0 0 1</upward></plugin>");
  std::string xml;
  for (const UrdfBlock& block : converted.result.robot->blocks) xml += block.xml;
  EXPECT_NE(xml.find("<cp>0 0.5 0</cp>"), std::string::npos) << xml;
  EXPECT_NE(xml.find("<forward>0 -1 0</forward>"), std::string::npos) << xml;
  EXPECT_NE(xml.find("<upward>0 0 1</upward>"), std::string::npos) << xml;
  EXPECT_EQ(converted.notes(NoteKind::kPluginReference).size(), 2U);
  EXPECT_TRUE(converted.notes(NoteKind::kPluginFrame).empty());
}

/// libsdformat takes a mass that equals 0 to 1e-6 for none.
TEST(SdfToUrdf, WarnsOfMassesThatGazeboTakesForNone) {
  const auto of_mass = [](const std::string& mass) {
    return Converted("<link name='l'><inertial><mass>" + mass + "</mass></inertial></link>")
        .notes(NoteKind::kTinyMass)
        .size();
  };
  EXPECT_EQ(of_mass("9e-7"), 1U);
  EXPECT_EQ(of_mass("1.1e-6"), 0U);
}

TEST(SdfToUrdf, SaysWhereARingOfFollowersIsCut) {
  const auto follower = [](const std::string& link, const std::string& leader) {
    return sdf_link(link) +
           sdf_joint("j" + link, "revolute", "base", link,
                     "<axis><xyz>0 0 1</xyz><limit><lower>-1</lower><upper>1</upper><effort>1"
                     "</effort><velocity>1</velocity></limit><mimic joint='" +
                         leader +
                         "'><multiplier>1</multiplier><offset>0</offset><reference>0"
                         "</reference></mimic></axis>");
  };
  const Converted converted(sdf_link("base") + follower("a", "jb") + follower("b", "ja"), "1.11");
  const auto lost = converted.notes(NoteKind::kMimicLost);
  ASSERT_EQ(lost.size(), 1U);
  EXPECT_NE(lost[0].instead.find("a ring, cut at jb"), std::string::npos) << lost[0].instead;
}

/// No comparison with nan is true, so nothing clamps to it: unlimited, for `simulate` as well.
TEST(SdfToUrdf, AnEffortOfNanIsNoLimit) {
  EXPECT_EQ(model::magnitude_limit(std::nan("")), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace rigor::convert
