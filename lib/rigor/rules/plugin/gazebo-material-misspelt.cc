// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/rules/plugin/systems.h>
#include <rigor/rules/rule.h>
#include <rigor/schema/suggest.h>

namespace rigor::rules::gazebo_material_misspelt {

constexpr std::string_view kPrefix = "Gazebo/";

/// The materials of Gazebo's own script, which new Gazebo knows by name, too.
constexpr std::string_view kMaterials =
    "Black BlackTransparent Blue BlueGlow BlueLaser BlueTransparent "
    "BlueTransparentOverlay Bricks BuildingFrame CameraDistortionMap CameraLensFlare "
    "CeilingTiled CloudySky CoM DarkGray DarkGrey DarkMagentaTransparent "
    "DarkOrangeTransparentOverlay DarkYellow DepthMap Editor EditorPlane FlatBlack "
    "Footway GaussianCameraNoise Gold Grass Gray Green GreenGlow GreenTransparent "
    "GreenTransparentOverlay Grey GreyGradientSky GreyTransparent Indigo JointAnchor "
    "Lane_1 Lanes_2 Lanes_4 Lanes_6 LaserScan1st LaserScan2nd LightBlueLaser LightOff "
    "LightOn Motorway Orange OrangeTransparent OrangeTransparentOverlay PaintedWall "
    "Pedestrian Pioneer2Body PioneerBody PointCloud PointHandle Primary Purple "
    "PurpleGlow Red RedBright RedGlow RedTransparent RedTransparentOverlay "
    "Reflectance Residential Road Runway Secondary SkyBlue Steps Tertiary Trunk "
    "Turquoise TurquoiseGlow TurquoiseGlowOutline White WhiteGlow WideLensMap Wood "
    "WoodFloor WoodPallet XYZNormals XYZPoints Yellow YellowGlow YellowTransparent "
    "ZincYellow";

/// `visual` is null where a <gazebo> block holds the name.
void check_name(const model::Field<std::string>& name, const model::Visual* visual,
                Context& context) {
  if (!name.value.starts_with(kPrefix) || !context.may_suggest()) return;
  const std::string_view inner = std::string_view(name.value).substr(kPrefix.size());
  if (has_word(kMaterials, inner)) return;
  std::vector<std::string_view> known;
  some_word(kMaterials, [&known](std::string_view word) {
    known.push_back(word);
    return false;
  });
  context.compared(known.size());
  const auto near = schema::near(inner, known);
  if (near.empty()) return;  // of a script of the author's own
  const std::string meant = std::string(kPrefix) + std::string(near.front());
  std::optional<Fix> fix;
  if (context.bytes(name.span) == name.value) {
    fix = Fix{"name '" + meant + "'", Applicability::kUnsafe, {{name.span, meant}}};
  }
  context.report({.where = name.span,
                  .message = "Gazebo has no material '" + name.value + "'",
                  .subject = visual ? context.subject(*visual) : std::string(),
                  .help = "did you mean '" + meant + "'?",
                  .fix = std::move(fix)});
}

void check(const model::Root& root, Context& context) {
  for (const model::Visual& visual : root.visuals) {
    if (!root.own(visual.site) || !visual.material.written) continue;
    check_name(visual.material.name, &visual, context);
  }
  for (const model::GazeboBlock& block : root.gazebo_blocks) {
    if (!root.own(block.site)) continue;
    const model::Parameter* material = find(block.content, "material");
    if (material != nullptr) check_name(material->value, nullptr, context);
  }
}

Rule rule() {
  return {
      .name = "gazebo-material-misspelt",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "the name of a material is nearly one of Gazebo's",
      .why = "Gazebo finds no such material and draws the visual white or gray. Names that are "
             "not near to those of Gazebo's own script are taken for an author's, and not "
             "reported.",
      .what_to_do = "Write the name of the material.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::gazebo_material_misspelt
