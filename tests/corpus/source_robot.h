// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The models of the corpus as libsdformat resolved them at rest (the oracle beside the corpus), and
// their motion by the product of exponentials, which needs no frame of a link. Neither rigor's
// reader nor its kinematics have a part in it.
//
//   for (const SourceRobot& robot : source_robots(oracle_rows()))
//     std::vector<Rigid> moved = displacements(robot, carriers, positions);

#pragma once

#include <array>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "corpus/rigid.h"
#include "support/corpus.h"

namespace rigor::judge {

inline constexpr std::size_t kNoLink = static_cast<std::size_t>(-1);

/// What one position does: turns about a line through the joint, slides along it, or both.
struct Motion {
  Triple axis{};     ///< unit vector in the frame of the file
  double turn = 1;   ///< rad per unit of position
  double slide = 0;  ///< m per unit of position
};

/// As the oracle numbers them.
enum class SourceJointType {
  kBall = 1,
  kContinuous,
  kFixed,
  kGearbox,
  kPrismatic,
  kRevolute,
  kRevolute2,
  kScrew,
  kUniversal,
};

struct SourceJoint {
  std::string name;              ///< as all names here inside the model: "arm::elbow"
  std::size_t parent = kNoLink;  ///< kNoLink: the world
  std::size_t child = kNoLink;
  SourceJointType type{};
  Rigid X;  ///< at rest in the frame of the file, as all poses here
  std::vector<Motion> motions;
};

struct SourcePart {
  std::string name;  ///< inside its link
  Rigid X;
};

struct SourceLink {
  std::string name;
  Rigid X;
  double mass = 0;
  Triple com{};
  Matrix inertia{};  ///< about the center of mass, along the link's axes
  std::vector<SourcePart> collisions, visuals;
};

struct SourceRobot {
  std::string file;  ///< inside the corpus
  std::string name;
  Rigid X;
  bool masses_known = true;
  std::vector<SourceLink> links;
  std::vector<SourceJoint> joints;
  std::vector<SourcePart> frames;
};

using Words = std::vector<std::string>;

inline Words split_at(const std::string& line, char separator) {
  Words parts;
  std::stringstream stream(line);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

inline bool has_oracle() {
  return std::filesystem::exists(test::corpus() + "/../oracle/poses.tsv.gz");
}

/// The rows of a tab-separated file beside the corpus; gzip reads it.
inline std::vector<Words> oracle_rows(const std::string& name) {
  const std::string command = "gzip -dcf '" + test::corpus() + "/../oracle/" + name + "'";
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::string text;
  std::array<char, 65536> buffer{};
  while (const std::size_t count = fread(buffer.data(), 1, buffer.size(), pipe.get())) {
    text.append(buffer.data(), count);
  }
  std::vector<Words> rows;
  for (const std::string& line : split_at(text, '\n')) rows.push_back(split_at(line, '\t'));
  return rows;
}

/// Makes a robot of the rows of one model at the top, which come together.
class SourceRobotReader {
 public:
  explicit SourceRobotReader(const Words& model) {
    robot_.file = model[0];
    robot_.name = model[2];
    robot_.X = pose(model);
  }

  void add(const Words& row) {
    if (row[1] == "link") add_link(row);
    if (row[1] == "collision") parts(row, &SourceLink::collisions);
    if (row[1] == "visual") parts(row, &SourceLink::visuals);
    if (row[1] == "frame") robot_.frames.push_back({inside(row[2]), pose(row)});
    if (row[1] == "joint") joints_.push_back(row);
  }

  SourceRobot take() && {
    for (const Words& row : joints_) add_joint(row);
    return std::move(robot_);
  }

 private:
  static double number(const std::string& word) { return std::strtod(word.c_str(), nullptr); }

  static Rigid pose(const Words& row) {
    return {rotation_of(number(row[6]), number(row[7]), number(row[8]), number(row[9])),
            {number(row[3]), number(row[4]), number(row[5])}};
  }

  std::string inside(const std::string& scoped) const {
    return scoped.substr(robot_.name.size() + 2);
  }

  void add_link(const Words& row) {
    std::array<double, 10> n{};
    const Words words = split_at(row.at(10), ' ');
    for (std::size_t i = 0; i < n.size(); ++i) n[i] = number(words.at(i));
    SourceLink link{inside(row[2]), pose(row), n[0], {n[1], n[2], n[3]}};
    link.inertia = {{{n[4], n[5], n[6]}, {n[5], n[7], n[8]}, {n[6], n[8], n[9]}}};
    robot_.links.push_back(std::move(link));
  }

  /// They follow their link.
  void parts(const Words& row, std::vector<SourcePart> SourceLink::*list) {
    SourceLink& link = robot_.links.back();
    (link.*list).push_back({inside(row[2]).substr(link.name.size() + 2), pose(row)});
  }

  /// The parent and the child are named inside the model that the joint stands in.
  void add_joint(const Words& row) {
    const Words words = split_at(row.at(10), ' ');
    SourceJoint joint{.name = inside(row[2]),
                      .type = static_cast<SourceJointType>(std::stoi(words.at(2))),
                      .X = pose(row)};
    const std::size_t end = joint.name.rfind("::");
    const std::string scope = end == std::string::npos ? "" : joint.name.substr(0, end + 2);
    joint.parent = link(scope + words[0]);
    joint.child = link(scope + words[1]);
    for (std::size_t i = 3; i + 2 < words.size(); i += 3) {
      joint.motions.push_back({{number(words[i]), number(words[i + 1]), number(words[i + 2])}});
    }
    complete(joint);
    robot_.joints.push_back(std::move(joint));
  }

  std::size_t link(const std::string& name) const {
    const auto found = std::find_if(robot_.links.begin(), robot_.links.end(),
                                    [&name](const SourceLink& one) { return one.name == name; });
    return found == robot_.links.end() ? kNoLink
                                       : static_cast<std::size_t>(found - robot_.links.begin());
  }

  static void complete(SourceJoint& joint) {
    using Type = SourceJointType;
    const Type type = joint.type;
    const auto along = [&joint](const Triple& axis) { return Motion{joint.X.R * axis}; };
    if (type == Type::kFixed || type == Type::kGearbox) {
      joint.motions.clear();
    } else if (type == Type::kBall) {  // every turn of it is one about z, then y, then x
      joint.motions = {along({0, 0, 1}), along({0, 1, 0}), along({1, 0, 0})};
    } else {
      const std::size_t axes = type == Type::kUniversal || type == Type::kRevolute2 ? 2 : 1;
      joint.motions.resize(axes, along({0, 0, 1}));  // an axis that is not written
    }
    if (type == Type::kPrismatic) joint.motions[0] = {joint.motions[0].axis, 0, 1};
  }

  SourceRobot robot_;
  std::vector<Words> joints_;
};

/// All models at the top of valid files, each with what is nested in it.
inline std::vector<SourceRobot> source_robots(const std::vector<Words>& rows) {
  std::vector<SourceRobot> robots;
  std::set<std::string> valid;
  std::optional<SourceRobotReader> reader;
  const auto finish = [&] {
    if (reader) robots.push_back(std::move(*reader).take());
    reader.reset();
  };
  for (const Words& row : rows) {
    if (row.size() > 2 && row[1] == "verdict" && row[2] == "valid") valid.insert(row[0]);
    if (row.size() < 10 || !valid.contains(row[0])) continue;
    if (row[1] == "model" && row[2].find("::") == std::string::npos) {
      finish();
      reader.emplace(row);
    }
    reader.value().add(row);
  }
  finish();
  return robots;
}

/// rad or m of each motion, by the joint's name.
using SourcePositions = std::map<std::string, std::vector<double>>;

/// The motion of the joint's child in the frame of the file.
inline Rigid moved(const SourceJoint& joint, const std::vector<double>& positions) {
  Rigid D;
  for (std::size_t i = 0; i < joint.motions.size(); ++i) {
    const Motion& motion = joint.motions[i];
    const Matrix R = turned(motion.axis, motion.turn * positions.at(i));
    // About a line through the joint's origin.
    const Triple p = joint.X.p - R * joint.X.p + (motion.slide * positions[i]) * motion.axis;
    D = D * Rigid{R, p};
  }
  return D;
}

/// How far each link has moved from where it rests. `carriers[i]` carries link i; null: nothing
/// does. They form a tree.
inline std::vector<Rigid> displacements(const SourceRobot& robot,
                                        const std::vector<const SourceJoint*>& carriers,
                                        const SourcePositions& positions) {
  std::vector<Rigid> result(robot.links.size());
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    const SourceJoint* joint = carriers[i];
    for (std::size_t steps = 0; joint != nullptr && steps <= robot.links.size(); ++steps) {
      result[i] = moved(*joint, positions.at(joint->name)) * result[i];
      joint = joint->parent == kNoLink ? nullptr : carriers[joint->parent];
    }
  }
  return result;
}

}  // namespace rigor::judge
