// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Both conversions over real models: what is written is taken by urdfdom, is the same robot, and comes
// back as it went.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <rigor/author/conversion.h>
#include <rigor/model/frames.h>
#include <rigor/read/load.h>
#include <rigor/rules/environment.h>

#include "support/corpus.h"
#include "support/part.h"

namespace rigor {
namespace {

using author::Conversion;

/// One run: what is read stays as long as it.
class Converter {
 public:
  explicit Converter(const Environment& environment)
      : environment_(environment), workspace_(environment.disk, sources_) {}

  read::Loaded load(const read::File& file) {
    return read::load({workspace_, environment_.resolver, environment_.sdf, environment_.urdf},
                      file);
  }
  read::Loaded open(const std::string& path) { return load(workspace_.open(path)); }
  read::Loaded put(const std::string& path, std::string text) {
    return load(workspace_.put(path, std::move(text)));
  }

  Conversion to_urdf(const read::Loaded& loaded) {
    return author::to_urdf(environment_, sources_, workspace_, loaded, {}, allowed("robot.urdf"));
  }
  /// As `sdf2urdf -o` does: shapes that URDF lacks become mesh files.
  Conversion to_urdf_without_loss(const read::Loaded& loaded, const std::string& model) {
    convert::UrdfOptions options;
    options.model = model;
    options.shapes = convert::ShapePolicy::kMesh;
    return author::to_urdf(environment_, sources_, workspace_, loaded, options,
                           {.out = next_out("robot.urdf")});
  }
  Conversion to_sdf(const read::Loaded& loaded) {
    return author::to_sdf(environment_, sources_, workspace_, loaded, {}, allowed("robot.sdf"));
  }

 private:
  static author::ConversionOptions allowed(const std::string& out) {
    return {.losses = author::Losses::kAllowed, .out = next_out(out)};
  }

  static std::string next_out(const std::string& name) {
    return "/nowhere/" + std::to_string(++runs_) + name;
  }

  inline static int runs_ = 0;
  const Environment& environment_;
  Sources sources_;
  read::Workspace workspace_;
};

/// What the proof says against the result.
std::string against(const Conversion& result) {
  for (const Diagnostic& found : result.diagnostics.list()) {
    if (found.rule == "convert-not-the-same" || found.rule == "convert-rejected") {
      return found.message;
    }
  }
  return {};
}

std::string first_error(const Conversion& result) {
  for (const Diagnostic& found : result.diagnostics.list()) {
    if (found.severity == Severity::kError) return std::string(found.rule) + ": " + found.message;
  }
  return {};
}

/// Told of these, and told rightly.
const std::set<std::string> kNotTheSame{
    // Two joints of one name, which urdfdom refuses.
    "urdf-usd-converter/tests/data/error_duplicate_joint_names.urdf",
};

TEST(CorpusConversion, UrdfOfRealModelsIsTakenAndIsTheSameRobot) {
  RIGOR_NEEDS_CORPUS();
  const RealDisk disk;
  const Environment environment(disk, {});
  int models = 0, written = 0;
  for (const std::string& path : test::corpus_part()) {
    const std::string name = path.substr(test::corpus().size() + 1);
    if (!name.starts_with("gazebo_models/") || !name.ends_with(".sdf")) continue;
    Converter converter(environment);
    const read::Loaded loaded = converter.open(path);
    if (!loaded.file->document->complete() || loaded.root.links.empty()) continue;
    ++models;
    const Conversion result = converter.to_urdf(loaded);
    if (!result.text) continue;
    ++written;
    EXPECT_EQ(against(result).empty(), !kNotTheSame.contains(name))
        << name << ": " << against(result);
  }
  EXPECT_GT(models, static_cast<int>(test::part_of(400)));
  EXPECT_GE(written, models * 95 / 100);
}

/// The SDF files that libsdformat calls valid, by its verdict in the corpus' list.
std::vector<std::string> valid_sdf_files() {
  std::vector<std::string> paths;
  std::istringstream list(test::read_file(test::corpus() + "/MANIFEST.tsv"));
  for (std::string line; std::getline(list, line);) {
    std::vector<std::string> columns;
    std::istringstream fields(line);
    for (std::string field; std::getline(fields, field, '\t');) columns.push_back(field);
    const bool sdf = columns.size() > 6 && (columns[5] == "sdf" || columns[5] == "gazebo");
    if (sdf && columns[6].starts_with("valid")) paths.push_back(test::corpus() + '/' + columns[0]);
  }
  return paths;
}

/// Whether the joints of a model, all of one degree or none, connect its links, and the world if one
/// leads there, without a loop.
bool is_plain_tree(const model::Root& root, const model::Frames& frames,
                   model::Id<model::Model> top) {
  const auto inside = [&](model::Id<model::Model> id) {
    while (id && id != top) id = root[id].parent;
    return id == top;
  };
  std::vector<std::size_t> group(root.links.size() + 1);  // the last is the world
  std::iota(group.begin(), group.end(), std::size_t{0});
  std::size_t groups = 0;
  for (const model::Link& link : root.links) groups += inside(link.model) ? 1 : 0;
  if (groups == 0) return false;
  bool on_world = false;
  for (std::uint32_t i = 0; i < root.joints.size(); ++i) {
    const model::Joint& joint = root.joints[i];
    if (!inside(joint.model)) continue;
    const model::Frames::Ends ends = frames.ends({i});
    const bool plain =
        joint.type == model::JointType::kRevolute || joint.type == model::JointType::kContinuous ||
        joint.type == model::JointType::kPrismatic || joint.type == model::JointType::kFixed;
    if (!plain || !ends.child || !(ends.parent || ends.parent_is_world)) return false;
    if (ends.parent_is_world && !on_world) ++groups;
    on_world |= ends.parent_is_world;
    const std::size_t a = group[ends.parent_is_world ? root.links.size() : ends.parent.value];
    const std::size_t b = group[ends.child.value];
    if (a == b) return false;
    std::replace(group.begin(), group.end(), b, a);
    --groups;
  }
  return groups == 1;
}

/// Whether something of a model collides as a plane or a heightmap, for which URDF has nothing.
bool collides_as_ground(const model::Root& root, model::Id<model::Model> top) {
  return std::any_of(root.collisions.begin(), root.collisions.end(), [&](const auto& collision) {
    auto id = root[collision.link].model;
    while (id && id != top) id = root[id].parent;
    const auto& shape = collision.geometry.shape;
    return id == top && (std::holds_alternative<model::Plane>(shape) ||
                         std::holds_alternative<model::Heightmap>(shape));
  });
}

/// One world has 3000 boxes, and some a hundred.
constexpr int kMaxOfAFile = 10;

/// Trees that do not convert without leave to lose something, and why that is right.
const std::set<std::string> kLosesSomething{
    // Its joint slides along nothing: there is no axis, and libsdformat makes none up.
    "sdformat_urdf/sdformat_test_files/models/joint_prismatic_no_axis/joint_prismatic_no_axis.sdf "
    "joint_prismatic_no_axis",
    // They collide as parts of a mesh file that is not among the corpus' files.
    "gazebo_classic_2014/test/worlds/concave_submesh_collision_test.world polaris_ranger_ev",
    "gazebo_classic_2014/test/worlds/concave_submesh_no_collision_test.world polaris_ranger_ev",
    "rmf_demos/rmf_demos_assets/models/Caddy/model.sdf caddy",
};

TEST(CorpusConversion, EveryTreeOfPlainJointsConvertsWithoutALoss) {
  RIGOR_NEEDS_CORPUS();
  const RealDisk disk;
  const Environment environment(disk, {});
  int models = 0;
  for (const std::string& path : valid_sdf_files()) {
    if (!test::in_part(path)) continue;
    Converter converter(environment);
    const read::Loaded loaded = converter.open(path);
    const model::Frames frames(loaded.root);
    int of_file = 0;
    for (std::uint32_t i = 0; i < loaded.root.models.size() && of_file < kMaxOfAFile; ++i) {
      const model::Model& model = loaded.root.models[i];
      if (model.parent || model.merged || !is_plain_tree(loaded.root, frames, {i})) continue;
      ++models;
      ++of_file;
      const std::string name = path.substr(test::corpus().size() + 1) + ' ' + model.name.value;
      const Conversion result = converter.to_urdf_without_loss(loaded, model.name.value);
      const bool whole = result.text && result.diagnostics.count(Severity::kError) == 0;
      const bool ground = collides_as_ground(loaded.root, {i});
      EXPECT_EQ(whole, !ground && !kLosesSomething.contains(name))
          << name << ": " << first_error(result);
      if (ground) {
        EXPECT_TRUE(first_error(result).starts_with("convert-collision-lost")) << name;
      }
    }
  }
  RecordProperty("models", models);
  EXPECT_GT(models, static_cast<int>(test::part_of(900)));
}

TEST(CorpusConversion, UrdfComesBackByteForByte) {
  RIGOR_NEEDS_CORPUS();
  const RealDisk disk;
  const Environment environment(disk, {});
  int models = 0, returned = 0;
  for (const std::string& path : test::corpus_part()) {
    const std::string name = path.substr(test::corpus().size() + 1);
    if (!name.ends_with(".urdf")) continue;
    Converter converter(environment);
    const read::Loaded loaded = converter.open(path);
    if (!loaded.file->document->complete()) continue;
    const Conversion sdf = converter.to_sdf(loaded);
    if (!sdf.text) continue;
    ++models;
    EXPECT_EQ(against(sdf).empty(), !kNotTheSame.contains(name)) << name << ": " << against(sdf);
    const Conversion back = converter.to_urdf(converter.put("/nowhere/a.sdf", *sdf.text));
    if (!back.text) continue;
    ++returned;
    const Conversion second = converter.to_sdf(converter.put("/nowhere/b.urdf", *back.text));
    ASSERT_TRUE(second.text) << name;
    const Conversion third = converter.to_urdf(converter.put("/nowhere/c.sdf", *second.text));
    ASSERT_TRUE(third.text) << name;
    EXPECT_EQ(*third.text, *back.text) << name;
  }
  EXPECT_GT(models, static_cast<int>(test::part_of(140)));
  EXPECT_GE(returned, models - 10);
}

}  // namespace
}  // namespace rigor
