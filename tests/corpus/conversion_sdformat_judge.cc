// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// URDF to SDF over the corpus, with nothing of rigor between the two ends: what urdfdom reads of the
// source, moved by the tests' own kinematics, against where libsdformat resolves the result to be.
// Built where libsdformat is installed.

#include <console_bridge/console.h>
#include <gtest/gtest.h>
#include <urdf_parser/urdf_parser.h>
#include <sdf/sdf.hh>

#include <algorithm>
#include <cstdio>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "corpus/judged_conversion.h"
#include "corpus/urdfdom_robot.h"

namespace rigor::judge {
namespace {

Rigid rigid_in_sdformat(const ignition::math::Pose3d& X) {
  return {rotation_of(X.Rot().W(), X.Rot().X(), X.Rot().Y(), X.Rot().Z()),
          {X.Pos().X(), X.Pos().Y(), X.Pos().Z()}};
}

template <class Entity>
Rigid in_model(const Entity& entity) {
  ignition::math::Pose3d X;
  const sdf::Errors errors = entity.SemanticPose().Resolve(X, "__model__");
  EXPECT_TRUE(errors.empty()) << entity.Name();
  return rigid_in_sdformat(X);
}

/// What a link without mass may weigh in SDF, which has none, kg.
constexpr double kNextToNothing = 1e-6;

/// A frame, which is where URDF has a link without mass.
struct Marker {
  std::string name;
  std::string link;
  Rigid X;
};

class SdformatRobot {
 public:
  explicit SdformatRobot(const sdf::Model& model) {
    for (std::uint64_t i = 0; i < model.LinkCount(); ++i) add(*model.LinkByIndex(i));
    for (std::uint64_t i = 0; i < model.JointCount(); ++i) add(*model.JointByIndex(i));
    for (std::uint64_t i = 0; i < model.FrameCount(); ++i) add(*model.FrameByIndex(i));
  }

  SdformatRobot(const SdformatRobot&) = delete;  // it points into itself
  SdformatRobot& operator=(const SdformatRobot&) = delete;

  /// By SDF names, in the frame of `base`. Parts stand in their order.
  struct Sight {
    std::map<std::string, Rigid> links;
    std::map<std::string, std::vector<Rigid>> collisions, visuals;
    MassSum sum;
  };
  Sight at(const SourcePositions& positions, const std::string& base,
           const std::set<std::string>& massless) const {
    const std::vector<Rigid> moves = displacements(robot_, carriers_, positions);
    Rigid X_from;
    for (const SourceLink& link : robot_.links) {
      if (link.name == base) X_from = inverse(link.X);
    }
    for (const Marker& marker : markers_) {
      if (marker.name == base) X_from = inverse(marker.X);
    }
    Sight sight;
    sight.links["world"] = X_from;
    for (std::size_t i = 0; i < robot_.links.size(); ++i) {
      const SourceLink& link = robot_.links[i];
      const Rigid D = X_from * moves[i];
      sight.links[link.name] = D * link.X;
      const bool nothing = link.mass <= kNextToNothing && massless.contains(link.name);
      if (!nothing) sight.sum.add(D * link.X, link.mass, link.com, link.inertia);
      for (const SourcePart& part : link.collisions) {
        sight.collisions[link.name].push_back(D * part.X);
      }
      for (const SourcePart& part : link.visuals) sight.visuals[link.name].push_back(D * part.X);
      for (const Marker& marker : markers_) {
        if (marker.link == link.name) sight.links[marker.name] = D * marker.X;
      }
    }
    for (const Marker& marker : markers_) {
      if (marker.link == "world") sight.links[marker.name] = X_from * marker.X;
    }
    return sight;
  }

  const std::vector<SourceJoint>& joints() const { return robot_.joints; }

 private:
  std::size_t link(const std::string& name) const {
    for (std::size_t i = 0; i < robot_.links.size(); ++i) {
      if (robot_.links[i].name == name) return i;
    }
    return kNoLink;
  }

  void add(const sdf::Link& written) {
    SourceLink link{written.Name(), in_model(written)};
    const auto& inertial = written.Inertial();
    const auto M = inertial.Moi();  // about the center of mass, along the link's axes
    const auto c = inertial.Pose().Pos();
    link.mass = inertial.MassMatrix().Mass();
    link.com = {c.X(), c.Y(), c.Z()};
    for (unsigned i = 0; i < 3; ++i) {
      for (unsigned j = 0; j < 3; ++j) link.inertia[i][j] = M(i, j);
    }
    for (std::uint64_t i = 0; i < written.CollisionCount(); ++i) {
      link.collisions.push_back({written.CollisionByIndex(i)->Name(),
                                 link.X * in_link(*written.CollisionByIndex(i), written)});
    }
    for (std::uint64_t i = 0; i < written.VisualCount(); ++i) {
      link.visuals.push_back(
          {written.VisualByIndex(i)->Name(), link.X * in_link(*written.VisualByIndex(i), written)});
    }
    robot_.links.push_back(std::move(link));
    carriers_.push_back(nullptr);
  }

  template <class Part>
  static Rigid in_link(const Part& part, const sdf::Link& link) {
    ignition::math::Pose3d X;
    EXPECT_TRUE(part.SemanticPose().Resolve(X, link.Name()).empty()) << part.Name();
    return rigid_in_sdformat(X);
  }

  void add(const sdf::Joint& written) {
    std::string parent, child;
    EXPECT_TRUE(written.ResolveParentLink(parent).empty()) << written.Name();
    EXPECT_TRUE(written.ResolveChildLink(child).empty()) << written.Name();
    SourceJoint joint{written.Name(), link(parent), link(child)};
    joint.X = in_model(written);
    if (written.Type() != sdf::JointType::FIXED && written.Axis(0) != nullptr) {
      ignition::math::Vector3d axis;
      EXPECT_TRUE(written.Axis(0)->ResolveXyz(axis, "__model__").empty()) << written.Name();
      axis.Normalize();
      const bool slides = written.Type() == sdf::JointType::PRISMATIC;
      joint.motions = {{{axis.X(), axis.Y(), axis.Z()}, slides ? 0.0 : 1.0, slides ? 1.0 : 0.0}};
    }
    robot_.joints.push_back(std::move(joint));
    carriers_.assign(robot_.links.size(), nullptr);
    for (const SourceJoint& one : robot_.joints) {
      if (one.child != kNoLink) carriers_[one.child] = &one;
    }
  }

  void add(const sdf::Frame& written) {
    std::string link;
    EXPECT_TRUE(written.ResolveAttachedToBody(link).empty()) << written.Name();
    markers_.push_back({written.Name(), link, in_model(written)});
  }

  SourceRobot robot_;
  std::vector<const SourceJoint*> carriers_;
  std::vector<Marker> markers_;
};

struct SdformatCounts {
  int files = 0, agree = 0, moments = 0, poses = 0, parts = 0, moving = 0;
};

/// A robot that urdfdom reads, and what came of it.
struct UrdfCase {
  std::string file;
  const urdf::ModelInterface& urdf;
  const author::Conversion& result;

  std::string link(const std::string& name) const {
    const auto found = result.names.links.find(name);
    return found == result.names.links.end() ? name : found->second;
  }

  /// By SDF names.
  std::set<std::string> massless() const {
    std::set<std::string> names;
    for (const auto& [name, one] : urdf.links_) {
      const urdf::Inertial* i = one->inertial.get();
      const bool nothing = i == nullptr || (i->mass == 0 && i->ixx + i->iyy + i->izz == 0);
      if (nothing) names.insert(link(name));
    }
    return names;
  }
};

template <class Parts>
double worst_part(const Rigid& X, const Parts& parts, const std::vector<Rigid>& seen, int& count) {
  double worst = parts.size() == seen.size() ? 0 : 1;
  for (std::size_t i = 0; i < std::min(parts.size(), seen.size()); ++i, ++count) {
    worst = std::max(worst, apart(X * rigid_of(parts[i]->origin), seen[i]));
  }
  return worst;
}

void hold_sdformat(const UrdfCase& one, const sdf::Model& model, SdformatCounts& counts) {
  const SdformatRobot robot(model);
  std::mt19937 generator(20260104);
  double worst = 0, worst_moments = 0;
  std::string worst_name;
  bool moving = false;
  for (unsigned k = 0; k < kConfigurations; ++k) {
    std::map<std::string, double> drawn;
    SourcePositions positions;
    for (const SourceJoint& joint : robot.joints()) {
      positions[joint.name].assign(joint.motions.size(), 0);
    }
    for (const auto& [name, joint] : one.urdf.joints_) {
      if (joint->type == urdf::Joint::FIXED || joint->type == urdf::Joint::FLOATING ||
          joint->type == urdf::Joint::PLANAR) {
        continue;
      }
      drawn[name] = static_cast<double>(generator()) / 2147483648.0 - 1;
      const auto names = one.result.names.joints.find(name);
      positions[names == one.result.names.joints.end() ? name : names->second.at(0)].assign(
          1, drawn[name]);
      moving = true;
    }
    const Seen wanted = look_at(one.urdf, drawn);
    const SdformatRobot::Sight seen =
        robot.at(positions, one.link(one.urdf.getRoot()->name), one.massless());
    for (const auto& [name, X] : wanted.links) {
      const std::string sdf_name = one.link(name);
      const auto found = seen.links.find(sdf_name);
      double by = found == seen.links.end() ? 1 : apart(X, found->second);
      ++counts.poses;
      const auto link = one.urdf.getLink(name);
      const auto list = [&](const auto& map) {
        const auto at = map.find(sdf_name);
        return at == map.end() ? std::vector<Rigid>() : at->second;
      };
      by = std::max(by, worst_part(X, link->collision_array, list(seen.collisions), counts.parts));
      by = std::max(by, worst_part(X, link->visual_array, list(seen.visuals), counts.parts));
      if (by > worst) {
        worst = by;
        worst_name = name;
      }
    }
    worst_moments = std::max(worst_moments, apart(wanted.sum, seen.sum));
  }
  EXPECT_LE(worst, kAgreement) << one.file << " " << worst_name;
  EXPECT_LE(worst_moments, kAgreement) << one.file;
  counts.agree += worst <= kAgreement ? 1 : 0;
  counts.moments += worst_moments <= kAgreement ? 1 : 0;
  counts.moving += moving ? 1 : 0;
}

/// Files that it complains of are read only in part.
class Complaints final : public console_bridge::OutputHandler {
 public:
  Complaints() { console_bridge::useOutputHandler(this); }
  ~Complaints() override { console_bridge::restorePreviousOutputHandler(); }
  Complaints(const Complaints&) = delete;
  Complaints& operator=(const Complaints&) = delete;

  void log(const std::string&, console_bridge::LogLevel level, const char*, int) override {
    any_ = any_ || level >= console_bridge::CONSOLE_BRIDGE_LOG_WARN;
  }
  bool any() const { return any_; }

 private:
  bool any_ = false;
};

/// Nothing when urdfdom does not read all of it.
urdf::ModelInterfaceSharedPtr whole_urdf(const std::string& text) {
  const Complaints complaints;
  const urdf::ModelInterfaceSharedPtr urdf = urdf::parseURDF(text);
  return complaints.any() ? nullptr : urdf;
}

TEST(CorpusConversionSdformat, SeesTheSource) {
  RIGOR_NEEDS_CORPUS();
  sdf::Console::Instance()->SetQuiet(true);
  const RealDisk disk;
  const Environment environment(disk, {});
  SdformatCounts counts;
  for (const std::string& path : test::corpus_models()) {
    if (!path.ends_with(".urdf")) continue;
    const std::string file = path.substr(test::corpus().size() + 1);
    const urdf::ModelInterfaceSharedPtr urdf = whole_urdf(test::read_file(path));
    if (!urdf) continue;
    Sources sources;
    read::Workspace workspace(disk, sources);
    const read::Loaded loaded = read::load(
        {workspace, environment.resolver, environment.sdf, environment.urdf}, workspace.open(path));
    const author::Conversion result = author::to_sdf(environment, sources, workspace, loaded, {},
                                                     {.proof = author::Proof::kNone,
                                                      .losses = author::Losses::kAllowed,
                                                      .out = "/nowhere/a.sdf"});
    ++counts.files;
    EXPECT_TRUE(result.text) << file;
    if (!result.text) continue;
    sdf::Root root;
    const sdf::Errors errors = root.LoadSdfString(*result.text);
    for (const sdf::Error& error : errors) {  // inertia that no body has, as in the source
      EXPECT_EQ(error.Code(), sdf::ErrorCode::LINK_INERTIA_INVALID) << file << error.Message();
    }
    ASSERT_NE(root.Model(), nullptr) << file;
    hold_sdformat({file, *urdf, result}, *root.Model(), counts);
  }
  std::printf("%d files, %d agree (%d move) in %d poses of links and %d of parts, %d in mass\n",
              counts.files, counts.agree, counts.moving, counts.poses, counts.parts,
              counts.moments);
  EXPECT_GT(counts.files, 120);
}

/// What `urdf2sdf` would write without `--allow-loss` is what libsdformat loads; with `--inertia nearest` it
/// writes each file with a robot in it that only an impossible inertia keeps from that.
TEST(CorpusConversionSdformat, LoadsWhatIsCalledASuccess) {
  RIGOR_NEEDS_CORPUS();
  sdf::Console::Instance()->SetQuiet(true);
  const RealDisk disk;
  const Environment environment(disk, {});
  int written = 0, nearest = 0, refused = 0, runs = 0;
  for (const std::string& path : test::corpus_models()) {
    if (!path.ends_with(".urdf")) continue;
    const std::string file = path.substr(test::corpus().size() + 1);
    Sources sources;
    read::Workspace workspace(disk, sources);
    const read::Loaded loaded = read::load(
        {workspace, environment.resolver, environment.sdf, environment.urdf}, workspace.open(path));
    if (loaded.root.format != model::Format::kUrdf) continue;
    const auto loads = [&](convert::InertiaPolicy inertia) {
      const author::Conversion result =
          author::to_sdf(environment, sources, workspace, loaded, {.inertia = inertia},
                         {.out = "/nowhere/" + std::to_string(++runs) + ".sdf"});
      if (!result.text || result.diagnostics.count(Severity::kError) > 0) return false;
      sdf::Root root;
      for (const sdf::Error& error : root.LoadSdfString(*result.text)) {
        ADD_FAILURE() << file << ": " << error.Message();
      }
      return true;
    };
    if (loads(convert::InertiaPolicy::kKeep)) {
      ++written;
    } else if (loads(convert::InertiaPolicy::kNearest)) {
      ++nearest;
    } else {
      ++refused;
    }
  }
  std::printf("%d written and loaded, %d with the nearest inertia, %d refused\n", written, nearest,
              refused);
  EXPECT_GT(written, 100);
  EXPECT_GT(nearest, 15);
}

/// Its own reader of URDF drops a link without mass and all that hangs on it.
TEST(CorpusConversionSdformat, KeepsWhatHangsOnLinksBetweenJoints) {
  RIGOR_NEEDS_CORPUS();
  if (!has_oracle()) GTEST_SKIP() << "no oracle beside the corpus";
  sdf::Console::Instance()->SetQuiet(true);
  int rows = 0, refused = 0;
  for_each_conversion([&](const Converted& converted) {
    const auto& joints = converted.result.names.joints;
    const bool has_row = std::any_of(joints.begin(), joints.end(),
                                     [](const auto& joint) { return joint.second.size() > 1; });
    if (!has_row) return;
    ++rows;
    sdf::Root root;
    const sdf::Errors errors = root.LoadSdfString(*converted.result.text);
    std::size_t moving = 0, kept = 0;
    for (const auto& [name, joint] : converted.urdf.joints_) {
      if (joint->type == urdf::Joint::FIXED) continue;
      ++moving;
      kept += root.Model() != nullptr && root.Model()->JointByName(name) != nullptr ? 1 : 0;
    }
    if (kept == moving) return;
    ++refused;  // for what the source says: a friction of -1, a sensor of 2011
    EXPECT_FALSE(errors.empty()) << named(converted) << ": " << kept << " of " << moving;
  });
  std::printf("%d with joints in a row, %d refused for something else\n", rows, refused);
  EXPECT_GT(rows, 50);
  EXPECT_LE(refused, rows / 20);
}

}  // namespace
}  // namespace rigor::judge
