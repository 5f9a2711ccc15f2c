// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a judge must see in the URDF that a model of the corpus was converted to: links, collisions,
// visuals and moments at given joint positions, from the oracle's poses and the conversion's names.
//
//   for_each_conversion([](const Converted& converted) {
//     const Expectation expectation(converted);
//     …expect_same(expectation.at(positions), seen)…
//   });

#pragma once

#include <gtest/gtest.h>
#include <tinyxml2.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <rigor/author/conversion.h>
#include <rigor/read/load.h>
#include <rigor/rules/environment.h>

#include "corpus/source_robot.h"
#include "support/part.h"

namespace rigor::judge {

/// Poses (m, rad) and moments (relative) agree up to this.
inline constexpr double kAgreement = 1e-9;
inline constexpr unsigned kConfigurations = 20;

struct Converted {
  const SourceRobot& source;
  const read::Loaded& loaded;
  const author::Conversion& result;
  const urdf::ModelInterface& urdf;
};

/// All in the frame of the URDF's root; parts by "link/name".
struct Seen {
  std::map<std::string, Rigid> links, collisions, visuals;
  MassSum sum;
};

/// One configuration, in the source's words and in the URDF's.
struct Positions {
  SourcePositions source;
  std::map<std::string, double> urdf;  ///< by joint
};

class Expectation {
 public:
  explicit Expectation(const Converted& converted)
      : converted_(converted), robot_(converted.source) {
    carriers_.resize(robot_.links.size());
    for (const SourceJoint& joint : robot_.joints) {
      const auto names = converted.result.names.joints.find(joint.name);
      if (names == converted.result.names.joints.end()) {
        left_out_.push_back(&joint);
      } else if (joint.child != kNoLink) {
        EXPECT_EQ(carriers_[joint.child], nullptr) << joint.name;
        carriers_[joint.child] = &joint;
      }
    }
    X_base_ = robot_.X;  // where the root is a link that was added
    for (std::size_t i = 0; i < robot_.links.size(); ++i) {
      if (urdf_name(i) == converted.urdf.getRoot()->name) X_base_ = robot_.links[i].X;
    }
  }

  /// Joints that are not in the URDF though their child is not carried by another one.
  std::vector<std::string> lost_joints() const {
    std::vector<std::string> names;
    for (const SourceJoint* joint : left_out_) {
      const bool carried = joint->child == kNoLink || carriers_[joint->child] != nullptr;
      if (!carried && !closes_circle(*joint) && joint->type != SourceJointType::kGearbox)
        names.push_back(joint->name);
    }
    return names;
  }

  /// The joint's names in the URDF, one for each of its motions. A screw's second one follows.
  Positions draw(std::mt19937& generator) const {
    Positions positions;
    for (const SourceJoint& joint : robot_.joints) {
      const auto names = converted_.result.names.joints.find(joint.name);
      if (names == converted_.result.names.joints.end()) continue;
      std::vector<double>& drawn = positions.source[joint.name];
      for (std::size_t i = 0; i < joint.motions.size(); ++i) {
        drawn.push_back(static_cast<double>(generator()) / 2147483648.0 - 1);
        positions.urdf[names->second.at(i)] = drawn.back();
      }
      if (joint.type != SourceJointType::kScrew) continue;
      const auto slide = converted_.urdf.getJoint(names->second.at(1));
      positions.urdf[names->second[1]] = slide->mimic->multiplier * drawn[0] + slide->mimic->offset;
    }
    return positions;
  }

  Seen at(const SourcePositions& positions) const {
    const Rigid X_from = inverse(X_base_);
    const std::vector<Rigid> moves = displacements(robot_, carriers_, positions);
    Seen seen;
    for (std::size_t i = 0; i < robot_.links.size(); ++i) {
      const SourceLink& link = robot_.links[i];
      const Rigid D = X_from * moves[i];
      const std::string name = urdf_name(i);
      // URDF's frame of a link is that of its joint.
      seen.links[name] = D * (carriers_[i] != nullptr ? carriers_[i]->X : link.X);
      for (const SourcePart& part : link.collisions) {
        seen.collisions[name + "/" + part.name] = D * part.X;
      }
      for (const SourcePart& part : link.visuals) seen.visuals[name + "/" + part.name] = D * part.X;
      seen.sum.add(D * link.X, link.mass, link.com, link.inertia);
    }
    return seen;
  }

  /// At rest, by the name that a link in their place has.
  std::map<std::string, Rigid> frames() const {
    std::map<std::string, Rigid> frames;
    for (const SourcePart& frame : robot_.frames) {
      std::string name = frame.name;
      for (std::size_t at = 0; (at = name.find("::", at)) != std::string::npos;) {
        name.replace(at, 2, "__");
      }
      frames[name] = inverse(X_base_) * frame.X;
    }
    return frames;
  }

 private:
  std::string urdf_name(std::size_t link) const {
    const auto found = converted_.result.names.links.find(robot_.links[link].name);
    return found == converted_.result.names.links.end() ? "" : found->second;
  }

  /// Its parent hangs on its child.
  bool closes_circle(const SourceJoint& joint) const {
    std::size_t link = joint.parent;
    while (link != kNoLink && link != joint.child) {
      link = carriers_[link] == nullptr ? kNoLink : carriers_[link]->parent;
    }
    return link == joint.child;
  }

  const Converted& converted_;
  const SourceRobot& robot_;
  std::vector<const SourceJoint*> carriers_;
  std::vector<const SourceJoint*> left_out_;
  Rigid X_base_;
};

/// A thread's pitch is not in the oracle. `<screw_thread_pitch>` is meters per turn;
/// `<thread_pitch>` radians per meter, left-handed, as Gazebo has it.
inline double meters_per_radian(const std::string& text, const model::Joint& joint) {
  const Span where = joint.site.span;
  const std::string tag = "<screw_thread_pitch>";
  const std::size_t at = text.find(tag, where.begin);
  if (at >= where.end) return -1 / joint.thread_pitch.value;
  return std::strtod(text.c_str() + at + tag.size(), nullptr) / (2 * std::acos(-1.0));
}

inline void complete_screws(SourceRobot& robot, const read::Loaded& loaded) {
  const std::string text = test::read_file(test::corpus() + "/" + robot.file);
  for (SourceJoint& joint : robot.joints) {
    if (joint.type != SourceJointType::kScrew) continue;
    for (const model::Joint& written : loaded.root.joints) {
      if (written.type != model::JointType::kScrew) continue;
      if (!("::" + joint.name).ends_with("::" + written.name.value)) continue;
      EXPECT_EQ(written.site.span.source, loaded.root.site.span.source) << "a screw is included";
      joint.motions.at(0).slide = meters_per_radian(text, written);
    }
  }
}

/// libsdformat 12 knows no `auto="true"`.
inline bool has_automatic_masses(const SourceRobot& robot, const model::Root& root) {
  return std::any_of(root.links.begin(), root.links.end(), [&](const model::Link& link) {
    return link.inertial.automatic.value &&
           model::scoped_name(root, link.model).starts_with(robot.name);
  });
}

inline std::map<std::string, read::SearchPaths> oracle_folders() {
  std::map<std::string, read::SearchPaths> folders;
  for (const Words& row : oracle_rows("model-paths.tsv")) {
    if (row.size() != 2 || row[0] == "set") continue;
    folders[row[0]].given.push_back({test::corpus() + "/" + row[1], "--model-path"});
  }
  return folders;
}

/// What it came to.
struct ConversionCounts {
  int models = 0;
  int converted = 0;
};

/// Calls back with each model that is converted, losses allowed and one root for several trees.
template <class Callback>
ConversionCounts for_each_conversion(const Callback& callback) {
  const RealDisk disk;
  auto folders = oracle_folders();
  std::map<std::string, Environment> environments;
  ConversionCounts counts;
  for (SourceRobot& source : source_robots(oracle_rows("poses.tsv.gz"))) {
    if (!test::in_part(source.file)) continue;
    const std::string set = source.file.substr(0, source.file.find('/'));
    const Environment& environment =
        environments.try_emplace(set, disk, folders[set]).first->second;
    Sources sources;
    read::Workspace workspace(disk, sources);
    const read::Loaded loaded =
        read::load({workspace, environment.resolver, environment.sdf, environment.urdf},
                   workspace.open(test::corpus() + "/" + source.file));
    ++counts.models;
    complete_screws(source, loaded);
    source.masses_known = !has_automatic_masses(source, loaded.root);
    const author::Conversion result =
        author::to_urdf(environment, sources, workspace, loaded,
                        {.model = source.name, .roots = convert::RootPolicy::kAddRoot},
                        {.proof = author::Proof::kNone,
                         .losses = author::Losses::kAllowed,
                         .out = "/nowhere/a.urdf"});
    if (!result.text) continue;
    ++counts.converted;
    const urdf::ModelInterfaceSharedPtr urdf = urdf::parseURDF(*result.text);
    if (!urdf) {
      ADD_FAILURE() << source.file << " " << source.name << ": urdfdom refuses it";
      continue;
    }
    callback(Converted{source, loaded, result, *urdf});
  }
  return counts;
}

inline std::string named(const Converted& converted) {
  return converted.source.file + " " + converted.source.name;
}

/// A URDF for simulators, which would open meshes; `add` may add what one of them wants.
template <class Add>
std::string without_shapes(const std::string& urdf, const Add& add) {
  tinyxml2::XMLDocument document;
  document.Parse(urdf.c_str(), urdf.size());
  tinyxml2::XMLElement* robot = document.RootElement();
  for (auto* link = robot->FirstChildElement("link"); link != nullptr;
       link = link->NextSiblingElement("link")) {
    for (const char* shape : {"visual", "collision"}) {
      while (auto* child = link->FirstChildElement(shape)) link->DeleteChild(child);
    }
  }
  add(*robot);
  tinyxml2::XMLPrinter printer;
  document.Print(&printer);
  return printer.CStr();
}

struct JudgedCounts {
  int poses = 0;
  int poses_agree = 0, moments_agree = 0;  ///< models
};

/// Holds a simulator's robot, which has `Seen at(positions by joint)`, against the source.
template <class Robot>
void hold(const Converted& converted, Robot& robot, double moments, JudgedCounts& counts) {
  const Expectation expectation(converted);
  std::mt19937 generator(20260102);
  double worst = 0, worst_moments = 0;
  for (unsigned k = 0; k < kConfigurations; ++k) {
    const Positions positions = expectation.draw(generator);
    const Seen wanted = expectation.at(positions.source);
    const Seen seen = robot.at(positions.urdf);
    for (const auto& [name, X] : wanted.links) {
      const auto found = seen.links.find(name);
      ASSERT_NE(found, seen.links.end()) << named(converted) << ": no " << name;
      worst = std::max(worst, apart(X, found->second));
      ++counts.poses;
    }
    worst_moments = std::max(worst_moments, apart(wanted.sum, seen.sum));
  }
  EXPECT_LE(worst, kAgreement) << named(converted);
  EXPECT_TRUE(worst_moments <= moments || !converted.source.masses_known) << named(converted);
  counts.poses_agree += worst <= kAgreement ? 1 : 0;
  counts.moments_agree += worst_moments <= moments ? 1 : 0;
}

}  // namespace rigor::judge
