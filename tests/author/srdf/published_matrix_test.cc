// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Collision matrices of robots that MoveIt configurations are published for, against those: Franka's Panda, two of
// it, Fanuc's M-10iA and Universal Robots' UR10. What differs is named here, and explained in docs/srdf.md.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <rigor/author/srdf/semantics.h>
#include <rigor/mass/mesh/reads.h>
#include <rigor/read/load.h>
#include <rigor/robot/collision/self_collisions.h>
#include <rigor/robot/collision/surfaces.h>
#include <rigor/robot/lookups.h>
#include <rigor/robot/semantic/soft_limits.h>
#include <rigor/rules/environment.h>

#include <support/corpus.h>

namespace rigor::test {
namespace {

namespace fs = std::filesystem;

using PublishedPair = std::pair<std::string, std::string>;
using PublishedMatrix = std::map<PublishedPair, std::string>;  // to the reason

PublishedPair published_pair(const std::string& a, const std::string& b) {
  return a < b ? PublishedPair{a, b} : PublishedPair{b, a};
}

PublishedMatrix published_matrix(const std::string& path) {
  const std::string text = read_file(path);
  const xml::Document document = xml::parse(text, SourceId{0});
  PublishedMatrix matrix;
  for (const xml::Element child : document.root()->children()) {
    if (child.name() != "disable_collisions") continue;
    matrix[published_pair(std::string(child.attribute("link1")->value()),
                          std::string(child.attribute("link2")->value()))] =
        child.attribute("reason")->value();
  }
  return matrix;
}

struct ComputedMatrix {
  PublishedMatrix disabled;
  std::set<PublishedPair> pairs;  ///< of all links with a collision
};

ComputedMatrix computed_matrix(const std::string& path,
                               const std::map<std::string, std::string>& packages) {
  const RealDisk disk;
  read::SearchPaths paths;
  paths.packages = packages;
  const Environment environment(disk, paths);
  Sources sources;
  read::Workspace workspace(environment.resolver, sources);
  const read::Loaded loaded = read::load(
      {workspace, environment.resolver, environment.sdf, environment.urdf}, workspace.open(path));
  if (loaded.root.models.empty()) {
    ADD_FAILURE() << path << " has no model";
    return {};
  }
  const model::Frames frames(loaded.root);
  const robot::Robot robot = within_soft_limits(
      robot::robot_of(loaded.root, frames, {0},
                      robot::lookups_in(loaded.root, workspace, environment.resolver)),
      loaded.root);
  mass::MeshReads reads(disk, environment.workers);
  const robot::CollisionBodies bodies(robot, robot::surface_finder(reads));
  EXPECT_TRUE(bodies.unknown().empty()) << path;
  Turns turns(0);
  const robot::SelfCollisions found = self_collisions(robot, bodies, {}, turns);
  ComputedMatrix matrix;
  for (const robot::LinkPair& pair : found.pairs)
    matrix.pairs.insert(published_pair(robot.bodies[pair.a].name, robot.bodies[pair.b].name));
  for (const author::DisabledPair& pair : author::disabled_pairs(robot, found.pairs))
    matrix.disabled[published_pair(pair.link1, pair.link2)] = pair.reason;
  return matrix;
}

struct PublishedRobot {
  std::string model;
  std::map<std::string, std::string> packages;
  std::string srdf;
  std::set<PublishedPair> more_default = {};     ///< ours, removed by hand from what is published
  std::set<PublishedPair> never_published = {};  ///< published, and not found
  std::set<PublishedPair> never_ours = {};       ///< found, and not published
  std::vector<std::string> arms = {""};  ///< of two arms each has a matrix: prefixes of names
};

class PublishedMatrices : public testing::Test {
 protected:
  void SetUp() override {
    if (corpus().empty()) GTEST_SKIP() << "RIGOR_CORPUS is not set";
    corpus_ = fs::weakly_canonical(corpus()).string();
    xacro_ = fs::weakly_canonical(fs::path(corpus_) / ".." / "corpus-xacro").string();
    if (!fs::exists(xacro_ + "/moveit_resources")) GTEST_SKIP() << "there is no corpus-xacro";
  }

  /// Of all pairs, those on which both say the same of "Never".
  void compare(const PublishedRobot& robot) {
    const PublishedMatrix published = published_matrix(robot.srdf);
    const ComputedMatrix ours = computed_matrix(robot.model, robot.packages);
    const auto reason = [](const PublishedMatrix& matrix, const PublishedPair& pair) {
      const auto found = matrix.find(pair);
      return found == matrix.end() ? std::string() : found->second;
    };
    for (const PublishedPair& pair : ours.pairs) {
      const bool within =
          std::any_of(robot.arms.begin(), robot.arms.end(), [&](const std::string& arm) {
            return pair.first.starts_with(arm) && pair.second.starts_with(arm);
          });
      if (!within) continue;
      const std::string a = reason(ours.disabled, pair), b = reason(published, pair);
      const std::string shown =
          pair.first + ' ' + pair.second + ": '" + a + "', published '" + b + "'";
      EXPECT_EQ(a == "Adjacent", b == "Adjacent") << shown;
      EXPECT_EQ(a == "Default" && !robot.more_default.contains(pair), b == "Default") << shown;
      ++all_;
      if ((a == "Never") == (b == "Never")) {
        ++agreed_;
        continue;
      }
      EXPECT_TRUE(a == "Never" ? robot.never_ours.contains(pair)
                               : robot.never_published.contains(pair))
          << shown;
    }
    for (const auto& [pair, why] : published)
      EXPECT_TRUE(ours.pairs.contains(pair)) << pair.first << ' ' << pair.second << ' ' << why;
  }

  std::string corpus_, xacro_;
  double all_ = 0, agreed_ = 0;
};

TEST_F(PublishedMatrices, AreFoundAgain) {
  const std::string resources = corpus_ + "/moveit_resources";
  const std::string configs = xacro_ + "/moveit_resources";
  compare({.model = resources + "/panda_description/urdf/panda.urdf",
           .srdf = configs + "/panda_moveit_config/config/panda.srdf",
           .more_default = {{"panda_link5", "panda_link7"}, {"panda_hand", "panda_link5"}},
           .never_published = {{"panda_link2", "panda_link6"}}});
  PublishedRobot two{
      .model = configs + "/dual_arm_panda_moveit_config/config/panda.urdf.xacro",
      .packages = {{"moveit_resources_panda_description", resources + "/panda_description"}},
      .srdf = configs + "/dual_arm_panda_moveit_config/config/panda.srdf",
      .arms = {"left_", "right_"}};
  for (const std::string& arm : two.arms) {
    two.more_default.insert({arm + "panda_link5", arm + "panda_link7"});
    two.more_default.insert({arm + "panda_hand", arm + "panda_link5"});
    two.never_published.insert({arm + "panda_link2", arm + "panda_link6"});
  }
  compare(two);
  compare({.model = resources + "/fanuc_description/urdf/fanuc.urdf",
           .srdf = configs + "/fanuc_moveit_config/config/fanuc.srdf"});

  // The description is in one repository of the corpus, its meshes in another.
  const std::string description = xacro_ + "/universal_robot/ur_description";
  const fs::path package = fs::path(testing::TempDir()) / "rigor_published_matrices";
  fs::remove_all(package);
  fs::create_directories(package);
  for (const char* part : {"config", "urdf", "package.xml"})
    fs::create_symlink(fs::path(description) / part, package / part);
  fs::create_symlink(corpus_ + "/example-robot-data/robots/ur_description/meshes",
                     package / "meshes");
  compare({.model = (package / "urdf/ur10.xacro").string(),
           .packages = {{"ur_description", package.string()}},
           .srdf = xacro_ + "/universal_robot/ur10_moveit_config/config/ur10.srdf",
           .never_ours = {{"base_link_inertia", "wrist_2_link"}}});
  fs::remove_all(package);

  RecordProperty("pairs", static_cast<int>(all_));
  RecordProperty("agreed", static_cast<int>(agreed_));
  EXPECT_GE(agreed_, 0.97 * all_) << agreed_ << " of " << all_;
}

/// Adjacency needs no mesh: every SRDF of the corpus whose robot is beside it.
TEST_F(PublishedMatrices, HaveTheNeighborsThatJointsConnect) {
  const std::map<std::string, std::string> robots{
      {"universal_robot/ur5_moveit_config/config/ur5.srdf",
       "universal_robot/ur_description/urdf/ur5.xacro"},
      {"universal_robot/ur3_moveit_config/config/ur3.srdf",
       "universal_robot/ur_description/urdf/ur3.xacro"},
      {"universal_robot/ur16e_moveit_config/config/ur16e.srdf",
       "universal_robot/ur_description/urdf/ur16e.xacro"},
  };
  for (const auto& [srdf, model] : robots) {
    const PublishedMatrix published = published_matrix(xacro_ + '/' + srdf);
    const RealDisk disk;
    read::SearchPaths paths;
    paths.packages["ur_description"] = xacro_ + "/universal_robot/ur_description";
    const Environment environment(disk, paths);
    Sources sources;
    read::Workspace workspace(environment.resolver, sources);
    const read::Loaded loaded =
        read::load({workspace, environment.resolver, environment.sdf, environment.urdf},
                   workspace.open(xacro_ + '/' + model));
    const model::Frames frames(loaded.root);
    ASSERT_FALSE(loaded.root.models.empty()) << model;
    const robot::Robot robot = robot::robot_of(loaded.root, frames, {0});
    std::vector<bool> with_shape;
    for (const robot::Body& body : robot.bodies) with_shape.push_back(!body.collisions.empty());
    std::set<PublishedPair> ours, theirs;
    for (const robot::LinkPair& pair : adjacent_pairs(robot, with_shape))
      ours.insert(published_pair(robot.bodies[pair.a].name, robot.bodies[pair.b].name));
    for (const auto& [pair, why] : published) {
      if (why == "Adjacent") theirs.insert(pair);
    }
    EXPECT_EQ(ours, theirs) << srdf;
  }
}

}  // namespace
}  // namespace rigor::test
