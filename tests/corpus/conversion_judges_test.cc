// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// SDF to URDF over the corpus, with nothing of rigor between the two ends: where libsdformat says
// that everything is, moved by the tests' own kinematics, against what urdfdom reads from the
// result.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <map>
#include <random>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "corpus/judged_conversion.h"
#include "corpus/urdfdom_robot.h"
#include "support/part.h"

namespace rigor::judge {
namespace {

template <class Parts>
void add_parts(const std::string& link, const Rigid& X, const Parts& parts,
               std::map<std::string, Rigid>& seen) {
  for (const auto& part : parts) {
    const bool added = seen.emplace(link + "/" + part->name, X * rigid_of(part->origin)).second;
    EXPECT_TRUE(added) << link << " has two parts named " << part->name;
  }
}

Seen look_at_all(const urdf::ModelInterface& model,
                 const std::map<std::string, double>& positions) {
  Seen seen = look_at(model, positions);
  for (const auto& [name, link] : model.links_) {
    add_parts(name, seen.links.at(name), link->collision_array, seen.collisions);
    add_parts(name, seen.links.at(name), link->visual_array, seen.visuals);
  }
  return seen;
}

std::map<std::string, double> rest(const urdf::ModelInterface& model) {
  std::map<std::string, double> positions;
  for (const auto& [name, joint] : model.joints_) {
    if (joint->type != urdf::Joint::FIXED) positions[name] = 0;
  }
  return positions;
}

/// What moves turns or slides, along an axis of unit length: not all readers normalize it.
std::string odd_joints(const urdf::ModelInterface& model) {
  std::string told;
  for (const auto& [name, joint] : model.joints_) {
    if (joint->type == urdf::Joint::FIXED) continue;
    const bool moves = joint->type == urdf::Joint::REVOLUTE ||
                       joint->type == urdf::Joint::CONTINUOUS ||
                       joint->type == urdf::Joint::PRISMATIC;
    const double size = length({joint->axis.x, joint->axis.y, joint->axis.z});
    if (!moves || std::abs(size - 1) > kAgreement) told += " joint " + name + " is odd;";
  }
  return told;
}

/// "link/name" of those whose shape URDF has a word for.
template <class Parts>
std::set<std::string> with_urdf_shape(const Converted& converted, const Parts& parts) {
  const model::Root& root = converted.loaded.root;
  std::set<std::string> names;
  for (std::uint32_t i = 0; i < parts.size(); ++i) {
    const auto& shape = parts[i].geometry.shape;
    const auto* mesh = std::get_if<model::Mesh>(&shape);
    const bool plain_mesh =
        mesh != nullptr && mesh->submesh.value.empty() && !mesh->uri.value.empty();
    if (!plain_mesh && !std::holds_alternative<model::Box>(shape) &&
        !std::holds_alternative<model::Sphere>(shape) &&
        !std::holds_alternative<model::Cylinder>(shape)) {
      continue;
    }
    const std::string link = model::scoped_name(root, parts[i].link);
    const std::string prefix = converted.source.name + "::";
    if (!link.starts_with(prefix)) continue;
    const auto name = converted.result.names.links.find(link.substr(prefix.size()));
    if (name != converted.result.names.links.end())
      names.insert(name->second + "/" + parts[i].name.value);
  }
  return names;
}

/// "link/link_name": what a `<gazebo>` block refers to has a name that is the only one in the robot.
std::string with_link(const std::string& name) {
  const std::size_t slash = name.find('/');
  return name.substr(0, slash + 1) + name.substr(0, slash) + "_" + name.substr(slash + 1);
}

/// The counterparts that are apart, or that are only on one side though they are `needed` there.
std::string differences(const std::map<std::string, Rigid>& wanted,
                        const std::map<std::string, Rigid>& seen,
                        const std::set<std::string>& needed, int& agreed) {
  std::string told;
  for (const auto& [name, X] : wanted) {
    auto found = seen.find(name);
    if (found == seen.end()) found = seen.find(with_link(name));
    if (found == seen.end()) {
      if (needed.contains(name)) told += " " + name + " is missing;";
    } else if (const double by = apart(X, found->second); !(by <= kAgreement)) {
      told += " " + name + " is off by " + std::to_string(by) + ";";
    } else {
      ++agreed;
    }
  }
  return told;
}

struct Agreed {
  int models = 0, links = 0, collisions = 0, visuals = 0, frames = 0, moving = 0, masses = 0;
};

std::string hold_urdfdom(const Converted& converted, Agreed& agreed) {
  const Expectation expectation(converted);
  std::string told = odd_joints(converted.urdf);
  for (const std::string& name : expectation.lost_joints()) told += " joint " + name + " is lost;";
  const auto collisions = with_urdf_shape(converted, converted.loaded.root.collisions);
  const auto visuals = with_urdf_shape(converted, converted.loaded.root.visuals);
  std::mt19937 generator(20260101);
  bool moving = false;
  for (unsigned k = 0; k < kConfigurations; ++k) {
    Positions positions = expectation.draw(generator);
    moving = moving || !positions.urdf.empty();
    const Seen wanted = expectation.at(positions.source);
    const Seen seen = look_at_all(converted.urdf, positions.urdf);
    std::set<std::string> links;
    for (const auto& [name, X] : wanted.links) links.insert(name);
    told += differences(wanted.links, seen.links, links, agreed.links);
    told += differences(wanted.collisions, seen.collisions, collisions, agreed.collisions);
    told += differences(wanted.visuals, seen.visuals, visuals, agreed.visuals);
    const double by = apart(wanted.sum, seen.sum);
    if (converted.source.masses_known && !(by <= kAgreement)) {
      told += " moments are off by " + std::to_string(by) + " of them, mass " +
              std::to_string(wanted.sum.mass) + " and " + std::to_string(seen.sum.mass) + ";";
    }
    if (!told.empty()) return told;
  }
  told += differences(expectation.frames(), look_at(converted.urdf, rest(converted.urdf)).links, {},
                      agreed.frames);
  agreed.moving += moving ? 1 : 0;
  agreed.masses += converted.source.masses_known ? 1 : 0;
  ++agreed.models;
  return told;
}

TEST(CorpusConversionJudges, LibsdformatAndUrdfdomSeeOneRobot) {
  RIGOR_NEEDS_CORPUS();
  if (!has_oracle()) GTEST_SKIP() << "no oracle beside the corpus";
  Agreed agreed;
  const ConversionCounts counts = for_each_conversion([&agreed](const Converted& converted) {
    const std::string told = hold_urdfdom(converted, agreed);
    EXPECT_TRUE(told.empty()) << converted.source.file << " " << converted.source.name << ":"
                              << told;
  });
  std::printf("%d models, %d converted, %d agree, %d in mass: %d move\n", counts.models,
              counts.converted, agreed.models, agreed.masses, agreed.moving);
  std::printf(
      "poses at %u configurations: %d of links, %d of collisions, %d of visuals; frames %d\n",
      kConfigurations, agreed.links, agreed.collisions, agreed.visuals, agreed.frames);
  EXPECT_GT(counts.models, static_cast<int>(test::part_of(1900)));
  EXPECT_GE(counts.converted, counts.models * 99 / 100);
  EXPECT_GT(agreed.moving, static_cast<int>(test::part_of(300)));
}

}  // namespace
}  // namespace rigor::judge
