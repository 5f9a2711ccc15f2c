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

bool has_ground(const robot::Robot& robot) {
  return std::any_of(robot.bodies.begin(), robot.bodies.end(), [](const robot::Body& body) {
    return std::any_of(body.collisions.begin(), body.collisions.end(),
                       [](const robot::Part& part) { return part.shape.kind == "plane"; });
  });
}

}  // namespace

SideFile mjcf_scene(const robot::Robot& robot, const std::string& model, const std::string& file) {
  const double extent = extent_of(robot);
  MjcfElement root{"mujoco", {{"model", model + " scene"}}};
  root.add({"include", {{"file", file + ".xml"}}});
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
  if (!has_ground(robot)) {
    world.add(
        {"geom",
         {{"name", "ground"}, {"type", "plane"}, {"size", "0 0 0.05"}, {"material", "ground"}}});
  }
  root.add(std::move(world));
  return {"scene.xml", mjcf_text(root)};
}

}  // namespace rigor::convert
