// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/mjcf/scene.h>

#include <algorithm>
#include <cmath>

#include <rigor/convert/mjcf/element.h>

namespace rigor::convert {
namespace {

/// m: of a robot of one body.
constexpr double kMinExtent = 0.5;

double extent_of(const robot::Robot& robot) {
  double extent = kMinExtent;
  for (const robot::Body& body : robot.bodies) {
    const double reach = length(body.X_MB.translation);
    if (std::isfinite(reach)) extent = std::max(extent, reach);
  }
  return extent;
}

/// MuJoCo 2.2.2 runs out of a buffer where a plane and bodies that never move are all there is.
bool needs_no_ground(const MjcfAssembly& assembly) {
  const robot::Robot& robot = assembly.robot;
  const std::vector<bool> fixed = fixed_to_world(robot, assembly.world);
  const bool nothing_moves =
      std::all_of(fixed.begin(), fixed.end(), [](bool each) { return each; });
  return assembly.any_static || nothing_moves ||
         std::any_of(robot.bodies.begin(), robot.bodies.end(), [](const robot::Body& body) {
           return std::any_of(body.collisions.begin(), body.collisions.end(),
                              [](const robot::Part& part) { return part.shape.kind == "plane"; });
         });
}

}  // namespace

SideFile mjcf_scene(const MjcfAssembly& assembly, const std::string& model,
                    const std::string& file) {
  const double extent = extent_of(assembly.robot);
  MjcfElement root{"mujoco", {{"model", model + " scene"}}};
  root.add({"include", {{"file", file}}});
  root.add({"statistic",
            {{"center", mjcf_numbers({0, 0, extent / 2})}, {"extent", mjcf_number(extent)}}});
  MjcfElement asset{"asset"};
  asset.add({"texture",
             {{"type", "skybox"},
              {"builtin", "gradient"},
              {"rgb1", "0.3 0.5 0.7"},
              {"rgb2", "0 0 0"},
              {"width", "512"},
              {"height", "3072"}}});
  asset.add({"texture",
             {{"type", "2d"},
              {"name", "ground"},
              {"builtin", "checker"},
              {"rgb1", "0.2 0.3 0.4"},
              {"rgb2", "0.1 0.2 0.3"},
              {"width", "300"},
              {"height", "300"}}});
  asset.add({"material",
             {{"name", "ground"},
              {"texture", "ground"},
              {"texuniform", "true"},
              {"texrepeat", "5 5"},
              {"reflectance", "0.2"}}});
  root.add(std::move(asset));
  MjcfElement world{"worldbody"};
  world.add(
      {"light",
       {{"pos", mjcf_numbers({0, 0, 3 * extent})}, {"dir", "0 0 -1"}, {"directional", "true"}}});
  if (!needs_no_ground(assembly)) {
    world.add(
        {"geom",
         {{"name", "ground"}, {"type", "plane"}, {"size", "0 0 0.05"}, {"material", "ground"}}});
  }
  root.add(std::move(world));
  return {"scene.xml", mjcf_text(root)};
}

}  // namespace rigor::convert
