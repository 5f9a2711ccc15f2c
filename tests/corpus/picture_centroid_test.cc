// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Robots of the corpus: each link is seen in the picture where its shapes are projected to.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <rigor/mass/mesh/reads.h>
#include <rigor/model/frames.h>
#include <rigor/read/load.h>
#include <rigor/rules/environment.h>
#include <rigor/view/drawing/files.h>
#include <rigor/view/trace.h>

#include "corpus/link_silhouettes.h"
#include "support/corpus.h"
#include "support/part.h"

namespace rigor::view {
namespace {

using judge::PixelSum;

constexpr std::uint32_t kWide = 480;
constexpr std::uint32_t kHigh = 320;
constexpr double kAspect = double(kWide) / kHigh;
/// Pixels. Balls and cylinders are drawn with flats that differ from the judge's.
constexpr double kCentroidWithin = 1;
/// A link that less is seen of has no centroid to speak of.
constexpr double kFewPixels = 40;

/// Full and no light, by the bits of red, green and blue: derived from each other under any light.
constexpr std::uint32_t kHues = 6;
constexpr Color kOther{1, 1, 1, 1};

Color hue(std::uint32_t index) {
  const std::uint32_t bits = index + 1;
  return {(bits & 1U) != 0 ? 1.0F : 0, (bits & 2U) != 0 ? 1.0F : 0, (bits & 4U) != 0 ? 1.0F : 0, 1};
}

/// Of a pixel that is lit, whatever gloss lies on it; `kHues` for others.
std::uint32_t hue_of(const Pixel& pixel) {
  constexpr int kApart = 20;
  const int least = std::min({pixel[0], pixel[1], pixel[2]});
  std::uint32_t bits = 0;
  for (std::uint32_t i = 0; i < 3; ++i) {
    if (pixel[i] > least + kApart) bits |= 1U << i;
  }
  return bits == 0 || pixel[3] < 255 ? kHues : bits - 1;
}

/// Its links from `first` on in plain colors, one each; the others white.
Drawing painted(Drawing drawing, const std::vector<std::uint32_t>& links, std::size_t first) {
  for (Body& body : drawing.bodies) {
    const auto at = std::find(links.begin(), links.end(), body.link.value);
    const auto index = static_cast<std::size_t>(at - links.begin());
    const bool chosen = index >= first && index < first + kHues;
    body.surfaces = {{chosen ? hue(static_cast<std::uint32_t>(index - first)) : kOther}};
    if (body.mesh->corners.colors.empty()) continue;
    auto plain = std::make_shared<mesh::TriangleMesh>(*body.mesh);
    plain->corners.colors.clear();
    body.mesh = std::move(plain);
  }
  return drawing;
}

struct CorpusRobot {
  explicit CorpusRobot(const std::string& file)
      : environment(disk, {}), reads(disk, environment.workers) {
    read::Workspace workspace(disk, sources);
    const read::Reader reader{workspace, environment.resolver, environment.sdf, environment.urdf};
    loaded = read::load(reader, workspace.open(test::corpus() + '/' + file));
    frames = std::make_unique<model::Frames>(loaded.root);
  }

  Drawing drawing() {
    return draw(loaded.root, *frames, sources, files_of(environment.resolver, sources, reads),
                {.layers = {Layer::kVisual}});
  }

  std::vector<mesh::Facet> facets(const model::Visual& visual) {
    std::shared_ptr<const mesh::LoadedMesh> file;
    if (const auto* mesh = std::get_if<model::Mesh>(&visual.geometry.shape)) {
      EXPECT_EQ(mesh->submesh.value, "") << "the judge knows whole files only";
      const auto found =
          environment.resolver.resolve(mesh->uri.value, sources.path(mesh->uri.span.source));
      if (found.path) file = reads.find(*found.path);
    }
    return judge::facets_of(visual.geometry, file ? &file->mesh : nullptr);
  }

  RealDisk disk;
  Environment environment;
  Sources sources;
  mass::MeshReads reads;
  read::Loaded loaded;
  std::unique_ptr<model::Frames> frames;
};

judge::LinkSilhouettes projected(CorpusRobot& robot, const Camera& camera, std::size_t bodies) {
  judge::LinkSilhouettes seen(camera, kWide, kHigh);
  const model::Root& root = robot.loaded.root;
  std::size_t found = 0;
  for (std::uint32_t i = 0; i < root.visuals.size(); ++i) {
    const auto X_WV = robot.frames->pose(model::Id<model::Visual>{i});
    if (!X_WV) continue;
    const std::vector<mesh::Facet> facets = robot.facets(root.visuals[i]);
    found += facets.empty() ? 0U : 1U;
    for (mesh::Facet facet : facets) {
      for (mesh::Vector3& p : facet) p = transform(*X_WV, p);
      seen.add(root.visuals[i].link.value, facet);
    }
  }
  EXPECT_EQ(found, bodies) << "what is there is drawn";
  return seen;
}

/// Of up to `kHues` links, from `first` on.
std::array<PixelSum, kHues + 1> traced(const Drawing& drawing, const Camera& camera,
                                       const std::vector<std::uint32_t>& links, std::size_t first) {
  std::array<PixelSum, kHues + 1> sums;
  const Traced traced =
      trace(painted(drawing, links, first), camera,
            {.width = kWide, .height = kHigh, .samples = 1, .background = {0, 0, 0, 0}});
  EXPECT_TRUE(traced.picture) << traced.problem;
  if (!traced.picture) return sums;
  for (std::uint32_t y = 0; y < kHigh; ++y) {
    for (std::uint32_t x = 0; x < kWide; ++x) {
      sums[hue_of(traced.picture->at(x, y))].add(x + 0.5, y + 0.5);
    }
  }
  return sums;
}

/// How many links had pixels enough to be compared.
std::size_t compare_links(const std::string& file, View view) {
  SCOPED_TRACE(file + " from " + std::string(to_string(view)));
  CorpusRobot robot(file);
  const Drawing drawing = robot.drawing();
  std::vector<std::uint32_t> links;
  for (const Body& body : drawing.bodies) links.push_back(body.link.value);
  std::sort(links.begin(), links.end());
  links.erase(std::unique(links.begin(), links.end()), links.end());

  const Camera camera = framing(drawing.bounds, view, kAspect);
  const judge::LinkSilhouettes seen = projected(robot, camera, drawing.bodies.size());
  std::size_t compared = 0;
  for (std::size_t first = 0; first < links.size(); first += kHues) {
    const auto sums = traced(drawing, camera, links, first);
    for (std::size_t i = first; i < std::min(first + kHues, links.size()); ++i) {
      SCOPED_TRACE(robot.loaded.root.links[links[i]].name.value);
      const PixelSum expected = seen.of(links[i]);
      const PixelSum& drawn = sums[i - first];
      // The rim's pixels may fall to either side.
      EXPECT_NEAR(drawn.count, expected.count, 10 + 0.05 * expected.count);
      if (expected.count < kFewPixels || drawn.count == 0) continue;
      EXPECT_NEAR(drawn.centroid()[0], expected.centroid()[0], kCentroidWithin);
      EXPECT_NEAR(drawn.centroid()[1], expected.centroid()[1], kCentroidWithin);
      ++compared;
    }
  }
  return compared;
}

// Arms, hands, legs, wheels, wings; meshes as STL, Collada, OBJ and glTF, boxes, balls and cylinders; URDF
// and SDF.
TEST(CorpusPicture, ShowsEachLinkWhereItsShapesAreProjectedTo) {
  RIGOR_NEEDS_CORPUS();
  if (tracer().empty()) GTEST_SKIP() << "Embree is not installed: no pictures are made";
  const std::vector<std::string> robots{
      "SO-ARM100/Simulation/SO100/so100.urdf",
      "anymal_c_simple_description/urdf/anymal.urdf",
      "dex-urdf/robots/hands/allegro_hand/allegro_hand_right_glb.urdf",
      "dex-urdf/robots/hands/ability_hand/ability_hand_left_glb.urdf",
      "example-robot-data/robots/double_pendulum_description/urdf/double_pendulum.urdf",
      "example-robot-data/robots/iris_description/robots/iris.urdf",
      "example-robot-data/robots/quadruped_description/urdf/quadruped.urdf",
      "gazebo_models/cart_soft_suspension/model.sdf",
      "gazebo_models/cessna/model.sdf",
      "gazebo_models/demo_joint_types/model.sdf",
      "gazebo_models/husky/model.sdf",
      "gazebo_models/mpl_right_arm/model.sdf",
      "gazebo_models/pioneer2dx/model.sdf",
      "gazebo_models/pioneer3at/model-1_3.sdf",
      "gazebo_models/ragdoll/model.sdf",
      "moveit_resources/fanuc_description/urdf/fanuc.urdf",
      "turtlebot3/turtlebot3_description/urdf/turtlebot3_waffle.urdf",
      "urdf-loaders/urdf/TriATHLETE_Climbing/urdf/TriATHLETE.URDF",
      "urdf_tutorial/urdf/07-physics.urdf",
      "pinocchio/models/baxter_simple.urdf",
  };
  for (std::size_t i = 0; i < robots.size(); ++i) {
    if (!test::in_part(robots[i])) continue;
    const View view = i % 2 == 0 ? View::kPerspective : View::kSide;
    EXPECT_GT(compare_links(robots[i], view), 1U) << robots[i];
  }
}

}  // namespace
}  // namespace rigor::view
