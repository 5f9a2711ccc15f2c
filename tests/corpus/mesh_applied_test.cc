// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `mesh-check --apply` over every model of the corpus: each mesh gets another unit, up axis, origin
// and name, and afterwards every shape names the new file and places it where the old one was.

#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include <rigor/author/apply_mesh.h>
#include <rigor/read/load.h>
#include <rigor/rules/environment.h>
#include <rigor/text/edit.h>

#include "support/corpus.h"
#include "support/part.h"

namespace rigor {
namespace {

using mesh::Vector3;

constexpr const char* kNew = ".new.glb";

/// The corpus, as it would be with the new meshes written beside the old ones.
class WithNewMeshes final : public Disk {
 public:
  std::unique_ptr<OpenFile> open(const std::string& path) const override {
    return disk_.open(path);
  }
  ReadResult read(const std::string& path, std::uint64_t max_bytes) const override {
    return disk_.read(path, max_bytes);
  }
  PathKind kind(const std::string& path) const override {
    if (!path.ends_with(kNew)) return disk_.kind(path);
    return disk_.kind(path.substr(0, path.size() - std::string_view(kNew).size()));
  }
  std::vector<std::string> list(const std::string& folder) const override {
    return disk_.list(folder);
  }

 private:
  RealDisk disk_;
};

struct Shape {
  std::string path;  ///< of the mesh
  Vector3 scale;
  model::Pose pose;
};

struct PlacedShapes {
  PlacedShapes(const Environment& environment, const std::string& path, const std::string& bytes)
      : workspace(environment.disk, sources) {
    const read::File& file = bytes.empty() ? workspace.open(path) : workspace.put(path, bytes);
    loaded = load({workspace, environment.resolver, environment.sdf, environment.urdf}, file);
    for (const auto& part : loaded.root.visuals) add(environment, part);
    for (const auto& part : loaded.root.collisions) add(environment, part);
  }

  template <class Part>
  void add(const Environment& environment, const Part& part) {
    const auto* mesh = std::get_if<model::Mesh>(&part.geometry.shape);
    if (mesh == nullptr || !loaded.root.own(part.site)) return;
    const auto found = environment.resolver.resolve(mesh->uri.value, loaded.file->path);
    shapes.push_back({found.path.value_or(""), mesh->scale.value, part.pose.pose.value});
  }

  Sources sources;
  read::Workspace workspace;
  read::Loaded loaded;
  std::vector<Shape> shapes;
};

/// By the mesh's path, so that a failure can be examined again.
author::MeshReplacement replacement(const std::string& path) {
  std::mt19937 dice(static_cast<std::mt19937::result_type>(path.size()));
  const auto number = [&dice] { return static_cast<double>(dice()) / 4294967296.0; };
  constexpr double kUnits[] = {1, 0.001, 0.0254};
  mesh::Transform by{.unit = kUnits[dice() % 3]};
  if (dice() % 2 == 0) by.up = mesh::UpAxis::kY;
  return {path, path + kNew, by,
          before_centering(by, {number() - 0.5, number() - 0.5, number() - 0.5})};
}

Vector3 place(const Shape& shape, const Vector3& p) {
  const Vector3& s = shape.scale;
  return transform(shape.pose, {s.x * p.x, s.y * p.y, s.z * p.z});
}

TEST(CorpusMesh, WhatIsAppliedLeavesAllInItsPlace) {
  RIGOR_NEEDS_CORPUS();
  const WithNewMeshes disk;
  const Environment environment(disk, {});
  std::size_t files = 0;
  std::size_t shapes = 0;
  std::map<std::string_view, std::size_t> left;
  double worst = 0;
  for (const std::string& path : test::corpus_part()) {
    SCOPED_TRACE(path);
    const PlacedShapes before(environment, path, {});
    std::set<std::string> meshes;
    for (const Shape& shape : before.shapes) meshes.insert(shape.path);
    meshes.erase("");
    if (meshes.empty() || !before.loaded.file->document->complete()) continue;

    std::vector<author::MeshReplacement> replacements;
    for (const std::string& mesh : meshes) replacements.push_back(replacement(mesh));
    const auto change =
        author::apply_mesh(environment, before.sources, before.loaded, replacements);
    for (const author::LeftUse& use : change.left) ++left[words(use.why)];
    const auto text = apply_edits(before.sources.bytes(before.loaded.root.source), change.edits);
    ASSERT_TRUE(text);

    const PlacedShapes after(environment, path, *text);
    ASSERT_EQ(after.shapes.size(), before.shapes.size());
    std::size_t changed = 0;
    for (std::size_t i = 0; i < before.shapes.size(); ++i) {
      const Shape& was = before.shapes[i];
      const Shape& is = after.shapes[i];
      if (is.path == was.path) continue;
      ++changed;
      const author::MeshReplacement by = replacement(was.path);
      ASSERT_EQ(is.path, by.new_file);
      for (const Vector3& p : {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}, Vector3{}}) {
        const Vector3 moved = before_centering(by.transform, p) + by.translation;
        const double off = length(place(was, p) - place(is, moved));
        EXPECT_LT(off, 1e-9);
        worst = std::max(worst, off);
      }
    }
    EXPECT_GE(changed + change.left.size(), change.uses);
    ++files;
    shapes += changed;
  }
  EXPECT_GT(files, test::part_of(100));
  std::printf("%zu files, %zu shapes; worst displacement %.3g m\n", files, shapes, worst);
  for (const auto& [why, count] : left) {
    std::printf("%zu left: %.*s\n", count, static_cast<int>(why.size()), why.data());
  }
}

}  // namespace
}  // namespace rigor
