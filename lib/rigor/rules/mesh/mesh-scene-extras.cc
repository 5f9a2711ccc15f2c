// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <string_view>

#include <rigor/rules/mesh/file_fault.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_scene_extras {

void check(const MeshFile& file, Context& context) {
  const auto& collada = file.facts.asset.collada;
  if (file.use != nullptr || !collada) return;
  std::string found;
  const auto add = [&found](const mesh::Sighting& sighting, std::string_view one) {
    if (sighting.count == 0) return;
    found += (found.empty() ? "" : ", ") + how_many(sighting.count, one) + in_line(sighting.first);
  };
  add(collada->cameras, "camera");
  add(collada->lights, "light");
  add(collada->animations, "animation");
  add(collada->controllers, "controller");
  if (!found.empty()) report_mesh(file, context, "the scene also holds " + found);
}

Rule rule() {
  return {
      .name = "mesh-scene-extras",
      .severity = Severity::kInfo,
      .summary = "a mesh file holds cameras, lights or animations",
      .why = "Robots do without: Gazebo takes some of it, as animations of actors, RViz none. "
             "Reported "
             "of a file that is checked by itself only.",
      .what_to_do = "Leave them out when exporting, or write the mesh alone: `rigor mesh-check "
                    "FILE -o OUT.dae`.",
      .checks = {on<MeshFile>(check)},
  };
}

}  // namespace rigor::rules::mesh_scene_extras
