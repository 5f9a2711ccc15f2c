// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/parameter/described_element.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <set>
#include <vector>

#include <rigor/read/conformance.h>
#include <rigor/schema/value.h>

namespace rigor::read {
namespace {

/// Those of the files in sdformat12/1.9 whose name is that of the element in them (`box_shape.sdf` has a
/// `<box>`), in order.
constexpr std::string_view kDescribedByThemselves[] = {"actor",
                                                       "air_pressure",
                                                       "altimeter",
                                                       "atmosphere",
                                                       "audio_sink",
                                                       "audio_source",
                                                       "battery",
                                                       "camera",
                                                       "collision",
                                                       "contact",
                                                       "frame",
                                                       "geometry",
                                                       "gps",
                                                       "gripper",
                                                       "gui",
                                                       "imu",
                                                       "inertial",
                                                       "joint",
                                                       "lidar",
                                                       "light",
                                                       "link",
                                                       "logical_camera",
                                                       "magnetometer",
                                                       "material",
                                                       "model",
                                                       "noise",
                                                       "particle_emitter",
                                                       "physics",
                                                       "plugin",
                                                       "population",
                                                       "pose",
                                                       "projector",
                                                       "ray",
                                                       "rfid",
                                                       "rfidtag",
                                                       "road",
                                                       "scene",
                                                       "sensor",
                                                       "sonar",
                                                       "spherical_coordinates",
                                                       "state",
                                                       "surface",
                                                       "transceiver",
                                                       "visual",
                                                       "world"};

using FaultOfValue = schema::ValueFault::Kind;

bool is_fatal(FaultOfValue kind, const schema::Node& node) {
  switch (kind) {
    case FaultOfValue::kEmpty:  // else the default is taken
      return node.cardinality() == schema::Cardinality::kOne ||
             node.cardinality() == schema::Cardinality::kOneOrMore;
    case FaultOfValue::kNotANumber:
    case FaultOfValue::kTooFew:
    case FaultOfValue::kBadBool:
    case FaultOfValue::kBadColor:
    case FaultOfValue::kBadTime: return true;
    default: return false;
  }
}

std::string tag_of(std::string_view name) { return "<" + std::string(name) + ">"; }

/// A missing child is fatal in a joint alone; elsewhere libsdformat adds an empty one.
bool is_joint_with_child(xml::Element element) {
  const auto type = element.attribute("type");
  return element.name() == "joint" && (!type || type->value() != "ball");
}

std::optional<std::string> fatal_fault(const SchemaFact& fact) {
  const std::string tag = tag_of(fact.element.name());
  switch (fact.kind) {
    case SchemaFactKind::kMissingAttribute:
      return tag + " has no attribute '" + std::string(fact.node->name()) + "'";
    case SchemaFactKind::kMissingElement:
      if (!is_joint_with_child(fact.element)) return std::nullopt;
      return tag + " has no " + tag_of(fact.node->name());
    case SchemaFactKind::kBadValue:
      if (!fact.node || !is_fatal(fact.value_fault->kind, *fact.node)) return std::nullopt;
      return "'" + std::string(fact.text) + "' is not a value of " +
             (fact.attribute ? std::string(fact.attribute->name()) : tag);
    default: return std::nullopt;
  }
}

}  // namespace

std::optional<schema::Node> description_of(const schema::Node& sdf, std::string_view name) {
  if (std::find(std::begin(kDescribedByThemselves), std::end(kDescribedByThemselves), name) ==
      std::end(kDescribedByThemselves)) {
    return std::nullopt;
  }
  // The nearest to the root is the one: a <material> is of a visual.
  std::vector<schema::Node> nodes{sdf};
  std::set<std::uint32_t> known{sdf.declaration()};
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const schema::Node parent = nodes[i];  // the vector grows
    for (const schema::Node child : parent.children()) {
      if (child.name() == name) return child;
      if (known.insert(child.declaration()).second) nodes.push_back(child);
    }
  }
  return std::nullopt;
}

std::optional<schema::Node> description_of(const schema::Node& sdf, xml::Element element) {
  std::vector<xml::Element> path;
  for (std::optional<xml::Element> at = element; at; at = at->parent()) path.push_back(*at);
  std::optional<schema::Node> node = sdf;
  for (auto at = path.rbegin() + 1; at != path.rend() && node; ++at) node = node->child(at->name());
  return node;
}

std::optional<std::string> unreadable_content(xml::Element element, const schema::Node& node) {
  std::optional<std::string> first;
  check_conformance(element, node, [&first](const SchemaFact& fact) {
    if (!first) first = fatal_fault(fact);
  });
  return first;
}

bool takes_value(const schema::Node& node, std::string_view text) {
  const auto fault = schema::check(node.type(), text);
  return !fault || !is_fatal(fault->kind, node);
}

}  // namespace rigor::read
