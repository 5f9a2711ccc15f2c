// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What stands in the `<gazebo>` blocks of a URDF: keys that libsdformat turns into SDF, and SDF, which
// it copies into the link, the joint or the model as it stands.

#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/model/frames.h>
#include <rigor/read/conformance.h>
#include <rigor/rules/context.h>
#include <rigor/schema/schema.h>

namespace rigor::rules {

/// How libsdformat reads the value of a key.
enum class GazeboValue : std::uint8_t {
  kAny,     ///< a name, or elements
  kNumber,  ///< by stod
  kWhole,   ///< by stoi
  kTruth,   ///< true, yes, 1, false, no or 0; what is none of these counts as false
  kVector,  ///< copied into SDF
};

struct GazeboKey {
  std::string_view name;
  GazeboValue value;
};

/// What libsdformat converts (ParseSDFExtension in its parser_urdf.cc).
constexpr GazeboKey kGazeboKeys[] = {{"material", GazeboValue::kAny},
                                     {"collision", GazeboValue::kAny},
                                     {"visual", GazeboValue::kAny},
                                     {"static", GazeboValue::kTruth},
                                     {"turnGravityOff", GazeboValue::kTruth},
                                     {"dampingFactor", GazeboValue::kNumber},
                                     {"maxVel", GazeboValue::kNumber},
                                     {"minDepth", GazeboValue::kNumber},
                                     {"mu1", GazeboValue::kNumber},
                                     {"mu2", GazeboValue::kNumber},
                                     {"fdir1", GazeboValue::kVector},
                                     {"kp", GazeboValue::kNumber},
                                     {"kd", GazeboValue::kNumber},
                                     {"selfCollide", GazeboValue::kTruth},
                                     {"maxContacts", GazeboValue::kWhole},
                                     {"laserRetro", GazeboValue::kNumber},
                                     {"springReference", GazeboValue::kNumber},
                                     {"springStiffness", GazeboValue::kNumber},
                                     {"stopCfm", GazeboValue::kNumber},
                                     {"stopErp", GazeboValue::kNumber},
                                     {"fudgeFactor", GazeboValue::kNumber},
                                     {"provideFeedback", GazeboValue::kTruth},
                                     {"canonicalBody", GazeboValue::kAny},
                                     {"cfmDamping", GazeboValue::kTruth},
                                     {"implicitSpringDamper", GazeboValue::kTruth},
                                     {"disableFixedJointLumping", GazeboValue::kTruth},
                                     {"preserveFixedJoint", GazeboValue::kTruth}};

inline std::optional<GazeboKey> gazebo_key(std::string_view name) {
  const auto* key = std::find_if(std::begin(kGazeboKeys), std::end(kGazeboKeys),
                                 [name](const GazeboKey& known) { return known.name == name; });
  if (key == std::end(kGazeboKeys)) return std::nullopt;
  return *key;
}

/// What in SDF the children of the block become children of.
inline std::vector<schema::Node> parents_of_copied(const model::GazeboBlock& block,
                                                   const Context& context) {
  const schema::Schema& sdf = context.sdf_schema();
  const schema::Node model = *sdf.root("sdf", sdf.latest())->child("model");
  const std::string& name = block.reference.value;
  if (name.empty()) return {model};
  std::vector<schema::Node> parents;
  const model::Names& names = context.frames().names();
  if (names.find_link({0}, name)) parents.push_back(*model.child("link"));
  if (names.find_joint({0}, name)) parents.push_back(*model.child("joint"));
  return parents;  // none: gazebo-reference-missing
}

/// Holds what libsdformat copies against the schema of SDF. What a `<collision>` or `<visual>` of the
/// block holds comes into each of the link's, so what such a one must have is there already.
inline void check_copied(const model::GazeboBlock& block, const Context& context,
                         const std::function<void(const read::SchemaFact&)>& tell) {
  const auto parents = parents_of_copied(block, context);
  if (parents.empty()) return;
  for (const xml::Element child : context.element(block.site).children()) {
    const std::string_view name = child.name();
    const auto key = gazebo_key(name);
    if (key && name != "collision" && name != "visual") continue;
    for (const schema::Node& parent : parents) {
      const auto node = parent.child(name);
      if (!node) continue;
      read::check_conformance(child, *node, tell);
      break;
    }
  }
}

}  // namespace rigor::rules
