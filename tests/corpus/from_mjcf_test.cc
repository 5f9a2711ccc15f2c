// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// MJCF files of public repositories as URDF and SDF, from the folder `corpus-mjcf` beside RIGOR_CORPUS: what is
// written is taken by urdfdom and is the same robot. And real SDF and URDF models to MJCF and back.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <rigor/author/conversion.h>
#include <rigor/model/frames.h>
#include <rigor/read/load.h>
#include <rigor/robot/compare.h>
#include <rigor/robot/lookups.h>
#include <rigor/rules/environment.h>

#include "support/corpus.h"
#include "support/part.h"

namespace rigor {
namespace {

using author::Conversion;

std::vector<std::string> mjcf_files() {
  const std::filesystem::path folder = std::filesystem::weakly_canonical(
      std::filesystem::path(test::corpus()) / ".." / "corpus-mjcf");
  std::vector<std::string> paths;
  if (test::corpus().empty() || !std::filesystem::is_directory(folder)) return paths;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().extension() == ".xml" && test::in_part(entry.path().string())) {
      paths.push_back(entry.path().string());
    }
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

class MjcfConverter {
 public:
  explicit MjcfConverter(const Environment& environment)
      : environment_(environment), workspace_(environment.disk, sources_) {}

  read::Loaded open(const std::string& path) { return load(workspace_.open(path)); }
  read::Loaded put(const std::string& path, const std::string& text) {
    return load(workspace_.put(path, text));
  }

  Conversion to_mjcf(const read::Loaded& loaded) {
    convert::MjcfOptions how;
    how.files = convert::MjcfFiles::kNone;
    return author::to_mjcf(environment_, sources_, workspace_, loaded, how, {.out = "/nowhere/a"});
  }
  Conversion to_urdf(const read::Loaded& loaded) {
    return author::from_mjcf_to_urdf(environment_, sources_, workspace_, loaded, {}, allowed());
  }
  Conversion to_sdf(const read::Loaded& loaded) {
    return author::from_mjcf_to_sdf(environment_, sources_, workspace_, loaded, {}, allowed());
  }

  robot::Robot robot(const read::Loaded& loaded) {
    const model::Frames frames(loaded.root);
    return robot::robot_of(loaded.root, frames, {0},
                           robot::lookups_in(loaded.root, workspace_, environment_.resolver));
  }

 private:
  read::Loaded load(const read::File& file) {
    return read::load({workspace_, environment_.resolver, environment_.sdf, environment_.urdf},
                      file);
  }
  static author::ConversionOptions allowed() {
    return {.losses = author::Losses::kAllowed,
            .out = "/nowhere/" + std::to_string(++runs_) + "/robot"};
  }

  inline static int runs_ = 0;
  const Environment& environment_;
  Sources sources_;
  read::Workspace workspace_;
};

/// What the proof says against the result.
std::string proof_against(const Conversion& result) {
  for (const Diagnostic& found : result.diagnostics.list()) {
    for (const char* rule :
         {"convert-not-the-same", "convert-rejected", "convert-rejected-by-libsdformat"}) {
      if (found.rule == rule) return found.message;
    }
  }
  return {};
}

TEST(CorpusFromMjcf, ResultsOfRealModelsAreTakenAndAreTheSameRobots) {
  const std::vector<std::string> files = mjcf_files();
  if (files.empty()) GTEST_SKIP() << "there is no corpus-mjcf beside the corpus";
  const RealDisk disk;
  const Environment environment(disk, {});
  int models = 0, urdf = 0, sdf = 0;
  for (const std::string& path : files) {
    MjcfConverter converter(environment);
    const read::Loaded loaded = converter.open(path);
    if (loaded.root.format != model::Format::kMjcf || loaded.root.links.empty()) continue;
    ++models;
    const Conversion as_urdf = converter.to_urdf(loaded);
    const Conversion as_sdf = converter.to_sdf(loaded);
    if (as_urdf.text && proof_against(as_urdf).empty()) ++urdf;
    if (as_sdf.text && proof_against(as_sdf).empty()) ++sdf;
  }
  RecordProperty("models", models);
  EXPECT_GT(models, static_cast<int>(test::part_of(300)));
  EXPECT_GE(urdf, models * 95 / 100);
  EXPECT_GE(sdf, models * 95 / 100);
}

/// What MJCF has no place for: names of shapes, meshes that are other files, velocities, what a plane is.
bool is_of_mjcf(robot::DifferenceKind kind) {
  using Kind = robot::DifferenceKind;
  static const std::set<Kind> kKinds{Kind::kPartRenamed,
                                     Kind::kCollisionOnlyInA,
                                     Kind::kCollisionOnlyInB,
                                     Kind::kVisualOnlyInA,
                                     Kind::kVisualOnlyInB,
                                     Kind::kMesh,
                                     Kind::kShape,
                                     Kind::kSize,
                                     Kind::kColor,
                                     Kind::kVelocity,
                                     Kind::kEffort,
                                     Kind::kFrameOnlyInA,
                                     Kind::kFrameOnlyInB,
                                     Kind::kCollisionMoved,
                                     Kind::kVisualMoved,
                                     Kind::kJointOnlyInA,
                                     Kind::kJointOnlyInB,
                                     Kind::kJointRenamed};
  return kKinds.contains(kind);
}

TEST(CorpusFromMjcf, UrdfComesBackFromMjcfAsTheSameRobot) {
  RIGOR_NEEDS_CORPUS();
  const RealDisk disk;
  const Environment environment(disk, {});
  int models = 0, same = 0;
  for (const std::string& path : test::corpus_part()) {
    if (!path.ends_with(".urdf")) continue;
    MjcfConverter converter(environment);
    const read::Loaded loaded = converter.open(path);
    if (!loaded.file->document->complete()) continue;
    const Conversion out = converter.to_mjcf(loaded);
    if (!out.text || out.diagnostics.count(Severity::kError) > 0) continue;
    const Conversion back = converter.to_urdf(converter.put("/nowhere/back.xml", *out.text));
    ++models;
    if (!back.text) continue;
    const robot::Robot before = converter.robot(loaded);
    const robot::Robot after = converter.robot(converter.put("/nowhere/back.urdf", *back.text));
    robot::Correspondence names;
    names.unlimited = 1e16;
    const auto differences = robot::compare(before, after, names);
    same += std::all_of(differences.begin(), differences.end(),
                        [](const robot::Difference& d) { return is_of_mjcf(d.kind); })
                ? 1
                : 0;
  }
  RecordProperty("models", models);
  EXPECT_GT(models, static_cast<int>(test::part_of(100)));
  EXPECT_GE(same, models * 80 / 100);  // planar joints and inertias that moved are in the account
}

}  // namespace
}  // namespace rigor
