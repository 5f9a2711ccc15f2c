// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/model/model.h>

namespace rigor::model {
namespace {

std::string joined(std::string scope, const std::string& name) {
  return scope.empty() ? name : std::move(scope.append("::").append(name));
}

}  // namespace

std::string_view shape_name(const Shape& shape) {
  constexpr std::string_view kNames[] = {"none",    "box",       "sphere",    "cylinder",
                                         "capsule", "cone",      "ellipsoid", "plane",
                                         "mesh",    "heightmap", "image",     "polyline"};
  static_assert(std::size(kNames) == std::variant_size_v<Shape>);
  return kNames[shape.index()];
}

std::string_view to_string(JointType type) {
  switch (type) {
    case JointType::kUnknown: break;
    case JointType::kFixed: return "fixed";
    case JointType::kRevolute: return "revolute";
    case JointType::kContinuous: return "continuous";
    case JointType::kPrismatic: return "prismatic";
    case JointType::kBall: return "ball";
    case JointType::kUniversal: return "universal";
    case JointType::kRevolute2: return "revolute2";
    case JointType::kScrew: return "screw";
    case JointType::kGearbox: return "gearbox";
    case JointType::kFloating: return "floating";
    case JointType::kPlanar: return "planar";
  }
  return "unknown";
}

std::string scoped_name(const Root& root, Id<Model> id) {
  if (!id) return {};
  const Model& model = root[id];
  return joined(scoped_name(root, model.parent), model.name.value);
}

std::string scoped_name(const Root& root, Id<Link> id) {
  return joined(scoped_name(root, root[id].model), root[id].name.value);
}

std::string scoped_name(const Root& root, Id<Joint> id) {
  const Joint& joint = root[id];
  return joined(scoped_name(root, joint.model),
                joint.alias.empty() ? joint.name.value : joint.alias);
}

std::string scoped_name(const Root& root, Id<Frame> id) {
  const Frame& frame = root[id];
  return joined(scoped_name(root, frame.model),
                frame.alias.empty() ? frame.name.value : frame.alias);
}

std::string scoped_name(const Root& root, Id<Collision> id) {
  return joined(scoped_name(root, root[id].link), root[id].name.value);
}

std::string scoped_name(const Root& root, Id<Visual> id) {
  return joined(scoped_name(root, root[id].link), root[id].name.value);
}

std::string name_in(const Root& root, Id<Model> scope, Id<Link> id) {
  std::string name = root[id].name.value;
  for (Id<Model> at = root[id].model; at && at != scope; at = root[at].parent) {
    name = root[at].name.value + "::" + name;
  }
  return name;
}

bool is_static(const Root& root, Id<Model> id) {
  for (; id; id = root[id].parent) {
    if (root[id].is_static.value) return true;
  }
  return false;
}

}  // namespace rigor::model
