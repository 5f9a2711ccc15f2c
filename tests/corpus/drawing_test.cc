// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Models of the corpus, drawn with everything that can be shown of them.

#include <rigor/view/drawing/drawing.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/mass/mesh/reads.h>
#include <rigor/mass/shapes.h>
#include <rigor/model/frames.h>
#include <rigor/read/load.h>
#include <rigor/rules/environment.h>
#include <rigor/view/drawing/files.h>
#include <rigor/view/trace.h>

#include "support/corpus.h"

namespace rigor::view {
namespace {

/// Of the 2,000 files of the corpus every so manyth is drawn, and of every so manyth its meshes are read.
constexpr std::size_t kDrawnStride = 4;
constexpr std::size_t kMeshStride = 100;
/// Of every so manyth a picture is made.
constexpr std::size_t kTracedStride = 20;

/// With a closed form, so that nothing stands in the way of drawing them.
template <class Part>
std::size_t count_solids(const std::vector<Part>& parts, const model::Frames& frames) {
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < parts.size(); ++i) {
    const auto pose = frames.pose(model::Id<Part>{i});
    if (!pose || !mass::solid_of(parts[i].geometry.shape)) continue;
    ++count;
  }
  return count;
}

/// Of those shapes, the ones that a layer of the drawing has, told by where they stand.
template <class Part>
std::size_t count_drawn(const Drawing& drawing, Layer layer, const std::vector<Part>& parts) {
  using Key = std::pair<model::Id<model::Link>, std::uint32_t>;
  std::map<Key, bool> is_solid;
  for (const Part& part : parts) {
    is_solid[{part.link, part.site.tag.begin}] = mass::solid_of(part.geometry.shape).has_value();
  }
  std::size_t count = 0;
  for (const Body& body : drawing.bodies) {
    if (body.layer != layer) continue;
    const auto found = is_solid.find({body.link, body.where.begin});
    EXPECT_NE(found, is_solid.end()) << body.name;
    if (found != is_solid.end() && found->second) ++count;
  }
  return count;
}

/// `<empty/>` is no shape on purpose.
std::size_t count_empty(const std::vector<model::Visual>& visuals) {
  return static_cast<std::size_t>(
      std::count_if(visuals.begin(), visuals.end(),
                    [](const model::Visual& visual) { return visual.geometry.explicitly_empty; }));
}

void expect_sound(const Drawing& drawing) {
  for (const Body& body : drawing.bodies) {
    ASSERT_TRUE(body.mesh) << body.name;
    ASSERT_FALSE(body.surfaces.empty()) << body.name;
    if (body.surfaces.size() > 1) {
      EXPECT_EQ(body.surfaces.size(), body.mesh->parts.size()) << body.name;
    }
    const model::Vector3& p = body.pose.translation;
    EXPECT_TRUE(std::isfinite(p.x + p.y + p.z)) << body.name;
  }
  for (const NotDrawn& each : drawing.not_drawn) EXPECT_FALSE(each.reason.empty()) << each.name;
  const mesh::Bounds& bounds = drawing.bounds;
  if (bounds.min.x <= bounds.max.x) {
    EXPECT_LE(mesh::diagonal(bounds), 4 * kFarthest);
  }
}

std::set<Layer> all_layers() {
  std::set<Layer> layers;
  for (const std::string_view name : layer_names()) layers.insert(*layer_named(name));
  return layers;
}

TEST(CorpusDrawing, DrawsWhateverLoads) {
  RIGOR_NEEDS_CORPUS();
  const RealDisk disk;
  const Environment environment(disk, {});
  const std::vector<std::string> paths = test::corpus_models();
  std::size_t drawn = 0;
  for (std::size_t i = 0; i < paths.size(); i += kDrawnStride) {
    SCOPED_TRACE(paths[i]);
    Sources sources;
    read::Workspace workspace(disk, sources);
    const read::File& file = workspace.open(paths[i]);
    if (!file.document) continue;
    const read::Reader reader{workspace, environment.resolver, environment.sdf, environment.urdf};
    const read::Loaded loaded = read::load(reader, file);
    const model::Root& root = loaded.root;
    const model::Frames frames(root);
    mass::MeshReads reads(disk, environment.workers);
    Files files = files_of(environment.resolver, sources, reads);
    if (i % kMeshStride != 0) files = {};

    const Drawing visuals = draw(root, frames, sources, files, {.layers = {Layer::kVisual}});
    EXPECT_EQ(visuals.bodies.size() + visuals.not_drawn.size() + count_empty(root.visuals),
              root.visuals.size());
    const Drawing drawing = draw(root, frames, sources, files, {.layers = all_layers()});
    EXPECT_EQ(count_drawn(drawing, Layer::kVisual, root.visuals),
              count_solids(root.visuals, frames));
    EXPECT_EQ(count_drawn(drawing, Layer::kCollision, root.collisions),
              count_solids(root.collisions, frames));
    expect_sound(drawing);
    drawn += visuals.bodies.empty() ? 0U : 1U;
  }
  EXPECT_GT(drawn, 0U);
}

bool can_be_seen(const Body& body) {
  const auto is_opaque = [](const Surface& s) { return s.color.a > 0.01F; };
  const model::Vector3& s = body.scale;
  return std::any_of(body.surfaces.begin(), body.surfaces.end(), is_opaque) &&
         !body.mesh->triangles.empty() && s.x * s.y * s.z != 0;
}

TEST(CorpusDrawing, HasNoBlankPicture) {
  RIGOR_NEEDS_CORPUS();
  if (tracer().empty()) GTEST_SKIP() << "Embree is not installed: no pictures are made";
  const RealDisk disk;
  const Environment environment(disk, {});
  const std::vector<std::string> paths = test::corpus_models();
  std::size_t pictures = 0;
  for (std::size_t i = 0; i < paths.size(); i += kTracedStride) {
    SCOPED_TRACE(paths[i]);
    Sources sources;
    read::Workspace workspace(disk, sources);
    const read::File& file = workspace.open(paths[i]);
    if (!file.document) continue;
    const read::Reader reader{workspace, environment.resolver, environment.sdf, environment.urdf};
    const read::Loaded loaded = read::load(reader, file);
    const model::Frames frames(loaded.root);
    mass::MeshReads reads(disk, environment.workers);
    const Drawing drawing =
        draw(loaded.root, frames, sources, files_of(environment.resolver, sources, reads),
             {{Layer::kVisual}});
    const Traced traced = trace(drawing, framing(drawing.bounds, View::kPerspective, 1.5),
                                {.width = 150, .height = 100});
    ASSERT_TRUE(traced.picture) << traced.problem;
    const auto is_drawn = [](const Pixel& pixel) { return pixel != Pixel{255, 255, 255, 255}; };
    const std::vector<Pixel>& pixels = traced.picture->pixels;
    const bool any = std::any_of(drawing.bodies.begin(), drawing.bodies.end(), can_be_seen);
    EXPECT_EQ(std::any_of(pixels.begin(), pixels.end(), is_drawn), any);
    pictures += any ? 1U : 0U;
  }
  EXPECT_GT(pictures, 0U);
}

}  // namespace
}  // namespace rigor::view
