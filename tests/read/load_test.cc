// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/load.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <rigor/model/frames.h>
#include <rigor/read/sdf_reader.h>
#include <rigor/rules/environment.h>

namespace rigor::read {
namespace {

/// A file of an in-memory disk, loaded; what it is made of lives as long.
struct Case {
  explicit Case(std::map<std::string, std::string> files, const std::string& path = "a.sdf")
      : disk(std::move(files)), environment(disk, {}), workspace(disk, sources) {
    const Reader reader{workspace, environment.resolver, environment.sdf, environment.urdf};
    loaded = load(reader, workspace.open(path));
  }
  const model::Root& root() const { return loaded.root; }
  std::vector<FactKind> kinds() const {
    std::vector<FactKind> result;
    for (const Fact& fact : loaded.facts) result.push_back(fact.kind);
    return result;
  }

  MemoryDisk disk;
  Environment environment;
  Sources sources;
  Workspace workspace;
  Loaded loaded;
};

std::map<std::string, std::string> one(std::string text) { return {{"a.sdf", std::move(text)}}; }

/// Every file of it is refused.
class RefusingDisk final : public Disk {
 public:
  explicit RefusingDisk(ReadResult answer) : answer_(std::move(answer)) {}
  std::unique_ptr<OpenFile> open(const std::string&) const override { return nullptr; }
  ReadResult read(const std::string&, std::uint64_t) const override { return answer_; }
  PathKind kind(const std::string&) const override { return PathKind::kFile; }
  std::vector<std::string> list(const std::string&) const override { return {}; }

 private:
  ReadResult answer_;
};

TEST(Load, ATooLargeFileIsKnownByItsErrorNotByItsWords) {
  const auto kind = [](ReadResult answer) {
    const RefusingDisk disk(std::move(answer));
    const Environment environment(disk, {});
    Sources sources;
    Workspace workspace(disk, sources);
    const Reader reader{workspace, environment.resolver, environment.sdf, environment.urdf};
    return load(reader, workspace.open("a.sdf")).facts.at(0).kind;
  };
  EXPECT_EQ(kind({{}, "reply is larger than the network's packets"}), FactKind::kFileUnreadable);
  EXPECT_EQ(kind({{}, "over 64 MiB", ReadError::kTooLarge}), FactKind::kFileTooLarge);
  const MemoryDisk real(one("<sdf/>"));
  EXPECT_EQ(real.read("a.sdf", 5).error, ReadError::kTooLarge);
  EXPECT_EQ(real.read("b.sdf", 5).error, ReadError::kOther);
}

std::string joint(const std::string& version, const std::string& axis) {
  return "<sdf version='" + version +
         "'><model name='m'><link name='a'/><link name='b'><pose>1 0 0 0 0 1.5</pose></link>"
         "<joint name='j' type='revolute'><parent>a</parent><child>b</child><axis>" +
         axis + "</axis></joint></model></sdf>";
}

/// Up to SDF 1.5 gravity stands in <physics>, up to 1.3 the step in <ode>.
TEST(Load, GravityAndStepAreWhereTheVersionHasThem) {
  const auto world = [](const std::string& version, const std::string& inside) {
    return Case(one("<sdf version='" + version + "'><world name='w'>" + inside + "</world></sdf>"));
  };
  const std::string in_physics =
      "<physics type='ode'><gravity>0 0 -1.6</gravity><max_step_size>0.004</max_step_size>"
      "<ode><solver><dt>0.002</dt></solver></ode></physics>";
  const std::string in_world = "<gravity>0 0 -3.7</gravity>";
  for (const char* old : {"1.2", "1.3", "1.4", "1.5"}) {
    const Case c = world(old, in_physics);
    EXPECT_EQ(c.root().worlds[0].gravity.value.z, -1.6) << old;
    EXPECT_TRUE(c.root().worlds[0].gravity.written) << old;
    const bool has_dt = std::string(old) < "1.4";
    EXPECT_EQ(c.root().physics[0].max_step_size.value, has_dt ? 0.002 : 0.004) << old;
  }
  const Case now = world("1.6", in_world + in_physics);
  EXPECT_EQ(now.root().worlds[0].gravity.value.z, -3.7);
  EXPECT_EQ(now.root().physics[0].max_step_size.value, 0.004);
  // Of two, the one marked as default.
  const std::string second = "<physics type='ode' default='1'><gravity>0 0 -2</gravity></physics>";
  EXPECT_EQ(world("1.5", in_physics + second).root().worlds[0].gravity.value.z, -2);
  const Case none = world("1.5", "");
  EXPECT_EQ(none.root().worlds[0].gravity.value.z, -9.8);
  EXPECT_FALSE(none.root().worlds[0].gravity.written);
  // SDF 1.0 has attributes.
  const Case first(
      one("<gazebo version='1.0'><world name='w'><physics type='ode'><gravity "
          "xyz='0 0 -5'/><ode><solver type='quick' dt='0.003' iters='10' sor='1.3'/>"
          "</ode></physics></world></gazebo>"));
  ASSERT_EQ(first.root().worlds.size(), 1U);
  EXPECT_EQ(first.root().worlds[0].gravity.value.z, -5);
  EXPECT_EQ(first.root().physics[0].max_step_size.value, 0.003);
}

TEST(Load, AnAxisIsInTheFrameThatItsVersionSays) {
  const auto axis = [](const std::string& version, const std::string& text) {
    const Case one_case(one(joint(version, text)));
    return *model::Frames(one_case.root()).axis({0}, 0);
  };
  // The child is turned by 1.5 rad about z: in its frame x points along (cos 1.5, sin 1.5, 0).
  const double c = std::cos(1.5);
  const std::string x = "<xyz>1 0 0</xyz>";
  const std::string flag = "<use_parent_model_frame>true</use_parent_model_frame>";
  EXPECT_NEAR(axis("1.4", x).x, 1, 1e-12);
  EXPECT_NEAR(axis("1.5", x).x, c, 1e-12);
  EXPECT_NEAR(axis("1.6", x + flag).x, 1, 1e-12);
  EXPECT_NEAR(axis("1.7", x).x, c, 1e-12);
  EXPECT_NEAR(axis("1.9", "<xyz expressed_in='a'>1 0 0</xyz>").x, 1, 1e-12);
}

TEST(Load, AbsentLimitsMeanWhatTheirVersionSays) {
  const auto limits = [](const std::string& version) {
    return Case(one(joint(version, "<limit/>"))).root().joints[0].axes[0];
  };
  EXPECT_EQ(limits("1.2").effort.value, 0);
  EXPECT_EQ(limits("1.4").effort.value, -1);
  EXPECT_EQ(limits("1.9").upper.value, 1e16);
  EXPECT_EQ(limits("1.10").upper.value, std::numeric_limits<double>::infinity());
  EXPECT_FALSE(limits("1.10").upper.written);
}

TEST(Load, KeepsWhereAValueWasWritten) {
  const std::string text =
      "<sdf version='1.9'><model name='m'><link name='l'><inertial><mass>2.5</mass></inertial>"
      "</link></model></sdf>";
  const Case one_case(one(text));
  const auto& mass = one_case.root().links[0].inertial.mass;
  EXPECT_EQ(mass.value, 2.5);
  EXPECT_EQ(text.substr(mass.span.begin, mass.span.size()), "2.5");
  const auto& ixx = one_case.root().links[0].inertial.ixx;
  EXPECT_EQ(ixx.value, 1);
  EXPECT_FALSE(ixx.written);
  EXPECT_TRUE(ixx.span.nowhere());
}

TEST(Load, AValueThatIsNoneKeepsTheDefault) {
  const Case one_case(
      one("<sdf version='1.9'><model name='m'><link name='l'><inertial><mass>1,5</mass></inertial>"
          "</link></model></sdf>"));
  EXPECT_EQ(one_case.root().links[0].inertial.mass.value, 1);
  EXPECT_FALSE(one_case.root().links[0].inertial.mass.written);
}

const char* const kPartConfig =
    "<model><name>p</name><sdf version='1.5'>old.sdf</sdf>"
    "<sdf version='1.9'>model.sdf</sdf></model>";

TEST(Load, AnIncludeBringsTheNewestFileUnderItsOwnTerms) {
  const Case one_case({{"a.sdf",
                        "<sdf version='1.9'><world name='w'><include><uri>model://p</uri>"
                        "<name>q</name><static>true</static><pose>1 2 3 0 0 0</pose></include>"
                        "</world></sdf>"},
                       {"p/model.config", kPartConfig},
                       {"p/old.sdf", "<sdf version='1.5'><model name='old'/></sdf>"},
                       {"p/model.sdf",
                        "<sdf version='1.9'><model name='p'><pose>9 9 9 0 0 0</pose>"
                        "<link name='l'/></model></sdf>"}});
  EXPECT_TRUE(one_case.loaded.facts.empty());
  const model::Root& root = one_case.root();
  ASSERT_EQ(root.models.size(), 1U);
  EXPECT_EQ(root.models[0].name.value, "q");
  EXPECT_TRUE(root.models[0].is_static.value);
  EXPECT_FALSE(root.own(root.links[0].site)) << "the link is written in the included file";
  EXPECT_EQ(model::Frames(root).pose(model::Id<model::Link>{0})->translation,
            (model::Vector3{1, 2, 3}));
}

std::string including(const std::string& uri) {
  return "<sdf version='1.9'><model name='m'><link name='l'/><include><uri>" + uri +
         "</uri></include></model></sdf>";
}

TEST(Load, ACycleOfIncludesEndsAndIsShown) {
  const Case one_case({{"a.sdf", including("b.sdf")}, {"b.sdf", including("a.sdf")}});
  ASSERT_EQ(one_case.kinds(), std::vector<FactKind>{FactKind::kIncludeCycle});
  EXPECT_EQ(one_case.loaded.facts[0].tried, (std::vector<std::string>{"a.sdf", "b.sdf", "a.sdf"}));
}

/// `count` files, each of which includes the next one `times` times, and a last one with a link.
std::map<std::string, std::string> multiplying(int count, int times, const std::string& last) {
  std::map<std::string, std::string> files;
  const auto name = [](int i) { return i == 0 ? "a.sdf" : "f" + std::to_string(i) + ".sdf"; };
  for (int i = 0; i < count; ++i) {
    std::string text = "<sdf version='1.9'><model name='m'><link name='l'/>";
    for (int k = 0; k < times; ++k) {
      text += "<include><uri>" + name(i + 1) + "</uri><name>x" + std::to_string(k) +
              "</name></include>";
    }
    files[name(i)] = text + "</model></sdf>";
  }
  files[name(count)] =
      "<sdf version='1.9'><model name='m'><link name='l'/>" + last + "</model></sdf>";
  return files;
}

std::size_t parts(const model::Root& root) {
  return root.models.size() + root.links.size() + root.includes.size();
}

TEST(Load, IncludesThatMultiplyAreNotRead) {
  // 4^20 links, if nothing stopped it; every file of the chain is loaded on its own.
  Case one_case(multiplying(20, 4, ""));
  EXPECT_EQ(one_case.kinds(), std::vector<FactKind>{FactKind::kTooMuchIncluded});
  const Reader reader{one_case.workspace, one_case.environment.resolver, one_case.environment.sdf,
                      one_case.environment.urdf};
  std::size_t all = parts(one_case.root());
  std::size_t too_large = 1;
  for (int i = 1; i <= 20; ++i) {
    const Loaded loaded = load(reader, one_case.workspace.open("f" + std::to_string(i) + ".sdf"));
    all += parts(loaded.root);
    too_large += loaded.facts.empty() ? 0 : 1;
  }
  // n files from the end bring 2 + 7 + 28 + ... parts: eight of them fit, and cost what they hold.
  EXPECT_EQ(too_large, 13U);
  EXPECT_LT(all, 2 * kMaxIncludedParts);
}

TEST(Load, IncludesThatMultiplyInACircleEnd) {
  const std::string back = "<include><uri>a.sdf</uri></include>";
  const Case one_case(multiplying(20, 4, back), "f20.sdf");
  EXPECT_EQ(one_case.kinds().back(), FactKind::kTooMuchIncluded);
  EXPECT_LT(parts(one_case.root()), 2 * kMaxIncludedParts);
}

TEST(Load, WhatAFileHoldsItselfIsNotCountedAsIncluded) {
  std::string text = "<sdf version='1.9'><model name='m'><link name='l'/>";
  for (std::size_t i = 0; i < kMaxIncludedParts; ++i) text += "<frame name='f'/>";
  text += "<include><uri>b.sdf</uri></include></model></sdf>";
  const Case one_case(
      {{"a.sdf", text},
       {"b.sdf", "<sdf version='1.9'><model name='b'><link name='l'/></model></sdf>"}});
  EXPECT_TRUE(one_case.loaded.facts.empty());
  EXPECT_EQ(one_case.root().frames.size(), kMaxIncludedParts);
  EXPECT_EQ(one_case.root().links.size(), 2U);
}

TEST(Load, IncludesThatNestTooDeepAreToldWhereTheyBegin) {
  const Case one_case(multiplying(40, 1, ""));
  ASSERT_EQ(one_case.kinds(), std::vector<FactKind>{FactKind::kIncludeTooDeep});
  EXPECT_EQ(one_case.loaded.facts[0].where.source, one_case.root().source);
  EXPECT_EQ(one_case.root().links.size(), kMaxIncludeDepth);
}

TEST(Load, WhatCannotBeIncludedIsAFact) {
  EXPECT_EQ(Case(one(including("model://none"))).kinds(),
            std::vector<FactKind>{FactKind::kIncludeNotFound});
  EXPECT_EQ(Case(one(including("https://fuel.gazebosim.org/1.0/a/models/b"))).kinds(),
            std::vector<FactKind>{FactKind::kUnfollowedInclude});
  EXPECT_EQ(Case({{"a.sdf", including("b.sdf")}, {"b.sdf", "<sdf"}}).kinds(),
            std::vector<FactKind>{FactKind::kIncludeUnreadable});
  EXPECT_EQ(Case({{"a.sdf", including("b")}, {"b/model.config", "<model/>"}}).kinds(),
            std::vector<FactKind>{FactKind::kConfigWithoutSdf});
}

TEST(Load, VersionsAreHeldAgainstTheKnownOnes) {
  const auto kinds = [](const std::string& root) {
    return Case(one("<" + root + "><world name='w'/></sdf>")).kinds();
  };
  EXPECT_TRUE(kinds("sdf version='1.9'").empty());
  EXPECT_EQ(kinds("sdf"), std::vector<FactKind>{FactKind::kVersionMissing});
  EXPECT_EQ(kinds("sdf version='1.1'"), std::vector<FactKind>{FactKind::kVersionUnknown});
  EXPECT_EQ(kinds("sdf version='1.99'"), std::vector<FactKind>{FactKind::kVersionTooNew});
  EXPECT_EQ(Case(one("<gazebo version='1.0'/>")).kinds(),
            std::vector<FactKind>{FactKind::kOldRoot});
  EXPECT_EQ(Case(one("<skeleton/>")).kinds(), std::vector<FactKind>{FactKind::kUnknownRoot});
}

TEST(Load, SdfOneZeroHasItsValuesInAttributes) {
  const Case one_case(
      one("<gazebo version='1.0'><model name='m'><link name='l'><origin pose='1 2 3 0 0 0'/>"
          "<inertial mass='4'><inertia ixx='5' ixy='0' ixz='0' iyy='5' iyz='0' izz='5'/></inertial>"
          "<collision name='c'><geometry><box size='1 2 3'/></geometry></collision></link>"
          "</model></gazebo>"));
  const model::Link& link = one_case.root().links[0];
  EXPECT_EQ(link.pose.pose.value.translation, (model::Vector3{1, 2, 3}));
  EXPECT_EQ(link.inertial.mass.value, 4);
  EXPECT_EQ(link.inertial.ixx.value, 5);
  const auto& shape = one_case.root().collisions[0].geometry.shape;
  EXPECT_EQ(std::get<model::Box>(shape).size.value, (model::Vector3{1, 2, 3}));
}

/// `ign sdf -p` has the defaults for each of them, and refuses a joint whose ends are attributes.
TEST(Load, NoLaterVersionHasThemThere) {
  for (const std::string version : {"1.2", "1.4", "1.6", "1.9"}) {
    const Case one_case(one(
        "<sdf version='" + version +
        "'><world name='w'><gravity xyz='0 0 -5'/><include uri='model://a'/><model name='m'>"
        "<link name='l'><inertial mass='4'><inertia ixx='5' iyy='5' izz='5'/></inertial>"
        "<collision name='c'><geometry><box size='1 2 3'/></geometry></collision>"
        "<visual name='v'><geometry><mesh filename='a.stl'/></geometry></visual></link>"
        "<joint name='j' type='revolute'><parent link='a'/><child>l</child>"
        "<axis xyz='1 0 0'><limit lower='-1' upper='1'/></axis></joint></model></world></sdf>"));
    SCOPED_TRACE(version);
    const model::Root& root = one_case.root();
    EXPECT_EQ(root.worlds[0].gravity.value.z, -9.8);
    EXPECT_EQ(root.includes[0].uri.value, "");
    EXPECT_TRUE(one_case.loaded.facts.empty());
    EXPECT_FALSE(root.links[0].inertial.mass.written);
    EXPECT_EQ(root.links[0].inertial.ixx.value, 1);
    const auto& shape = root.collisions[0].geometry.shape;
    EXPECT_EQ(std::get<model::Box>(shape).size.value, (model::Vector3{1, 1, 1}));
    EXPECT_EQ(std::get<model::Mesh>(root.visuals[0].geometry.shape).uri.value, "");
    EXPECT_EQ(root.joints[0].parent.value, "");
    EXPECT_EQ(root.joints[0].axes[0].xyz.value, (model::Vector3{0, 0, 1}));
    EXPECT_FALSE(root.joints[0].axes[0].lower.written);
  }
}

const char* const kArm =
    "<robot name='arm'><link name='base'/><link name='upper'/><link name='hand'/>"
    "<joint name='shoulder' type='revolute'><parent link='base'/><child link='upper'/>"
    "<origin xyz='0 0 1' rpy='0 0 0'/><axis xyz='0 2 0'/>"
    "<limit lower='-1' upper='1' effort='5' velocity='1'/></joint>"
    "<joint name='hand' type='prismatic'><parent link='upper'/><child link='hand'/>"
    "<origin xyz='1 0 0' rpy='0 0 0'/><axis xyz='1 0 0'/>"
    "<limit lower='0' upper='1' effort='5' velocity='1'/></joint>"
    "<gazebo reference='hand'><plugin name='p' filename='libp.so'/></gazebo>"
    "<transmission name='t'><joint name='shoulder'/></transmission></robot>";

TEST(Load, AUrdfLinkStandsWhereItsJointDoes) {
  const Case one_case({{"arm.urdf", kArm}}, "arm.urdf");
  const model::Root& root = one_case.root();
  const model::Frames frames(root);
  EXPECT_TRUE(frames.problems().empty()) << "a link and a joint of one name are legal in URDF";
  EXPECT_EQ(frames.pose(model::Id<model::Link>{2})->translation, (model::Vector3{1, 0, 1}));
  EXPECT_EQ(*frames.axis({0}, 0), (model::Vector3{0, 1, 0}));
  EXPECT_EQ(root.links[0].inertial.mass.value, 0) << "nothing written is no mass in URDF";
  EXPECT_EQ(root.plugins[0].gazebo_reference, "hand");
  EXPECT_EQ(root.controlled_joints[0].joint.value, "shoulder");
}

TEST(Load, ForwardKinematicsMovesWhatHangsOnAJoint) {
  const Case one_case({{"arm.urdf", kArm}}, "arm.urdf");
  const double q = 0.3;
  const double d = 0.2;
  const model::Frames frames(one_case.root(), {{"arm::shoulder", {q, 0}}, {"arm::hand", {d, 0}}});
  // The hand is 1 + d along the upper arm, which the shoulder at (0, 0, 1) turns about y.
  const model::Vector3 hand = frames.pose(model::Id<model::Link>{2})->translation;
  EXPECT_NEAR(hand.x, (1 + d) * std::cos(q), 1e-12);
  EXPECT_NEAR(hand.y, 0, 1e-12);
  EXPECT_NEAR(hand.z, 1 - (1 + d) * std::sin(q), 1e-12);
  EXPECT_EQ(frames.pose(model::Id<model::Link>{0})->translation, (model::Vector3{}));
}

TEST(Frames, SaysWhyThereIsNoPose) {
  const Case one_case(
      one("<sdf version='1.9'><model name='m'><link name='l'/>"
          "<frame name='a'><pose relative_to='b'/></frame><frame name='b'><pose "
          "relative_to='a'/></frame>"
          "<frame name='c'><pose relative_to='lost'/></frame></model></sdf>"));
  const model::Frames frames(one_case.root());
  ASSERT_EQ(frames.problems().size(), 2U);
  EXPECT_EQ(frames.problems()[0].kind, model::FrameProblemKind::kRelativeToMissing);
  EXPECT_EQ(frames.problems()[0].name, "lost");
  EXPECT_EQ(frames.problems()[1].kind, model::FrameProblemKind::kRelativeToCycle);
  EXPECT_EQ(frames.problems()[1].members, (std::vector<std::string>{"a", "b", "a"}));
  for (std::uint32_t i = 0; i < 3; ++i) EXPECT_FALSE(frames.pose(model::Id<model::Frame>{i}));
  EXPECT_TRUE(frames.pose(model::Id<model::Link>{0}));
}

TEST(Frames, ALongChainOfAttachmentsTakesOneWalk) {
  std::string text = "<sdf version='1.9'><model name='m'><link name='l'/>";
  constexpr int kLength = 150'000;
  for (int i = 0; i < kLength; ++i) {
    const std::string next = i + 1 == kLength ? "l" : "f" + std::to_string(i + 1);
    text += "<frame name='f" + std::to_string(i) + "' attached_to='" + next + "'/>";
  }
  const Case one_case(one(text + "</model></sdf>"));
  const model::Frames frames(one_case.root());
  EXPECT_EQ(frames.carrier({0}), model::Id<model::Link>{0});
  EXPECT_EQ(frames.carrier({kLength - 1}), model::Id<model::Link>{0});
}

TEST(Frames, ALongChainNeedsNoDeepStack) {
  std::string text = "<sdf version='1.9'><model name='m'><link name='l'/><frame name='f0'/>";
  constexpr int kLength = 150'000;
  for (int i = 1; i < kLength; ++i) {
    text += "<frame name='f" + std::to_string(i) + "'><pose relative_to='f" +
            std::to_string(i - 1) + "'>1 0 0 0 0 0</pose></frame>";
  }
  const Case one_case(one(text + "</model></sdf>"));
  const model::Frames frames(one_case.root());
  EXPECT_EQ(frames.pose(model::Id<model::Frame>{kLength - 1})->translation.x, kLength - 1);
}

}  // namespace
}  // namespace rigor::read
