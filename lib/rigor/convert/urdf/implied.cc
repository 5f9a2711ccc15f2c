// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What no code converted: whether it says anything, and what kind of thing is lost with it.

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <rigor/convert/urdf/draft.h>
#include <rigor/read/values.h>
#include <rigor/schema/schema.h>
#include <rigor/schema/value.h>
#include <rigor/schema/version.h>
#include <rigor/write/numbers.h>

namespace rigor::convert {
namespace {

/// The schema's node of an element, in the version that its document states; nothing where the schema
/// knows none, or looks no further.
std::optional<schema::Node> node_of(const schema::Schema& schema, xml::Element element) {
  std::vector<xml::Element> way{element};  // no longer than XML may nest
  while (const auto parent = way.back().parent()) way.push_back(*parent);
  const xml::Element top = way.back();
  const auto written = top.attribute("version");
  const auto version =
      written ? schema::parse_version(read::trimmed(written->value())) : std::nullopt;
  auto node = schema.root(top.name(), schema.nearest(version.value_or(schema.latest())));
  way.pop_back();
  while (node && !way.empty()) {
    if (node->open()) return std::nullopt;
    node = node->child(way.back().name());
    way.pop_back();
  }
  return node;
}

/// An opacity of one may be left out of a color.
std::vector<double> with_opacity(std::vector<double> color) {
  if (color.size() == 3) color.push_back(1);
  return color;
}

bool equals_default(const schema::Node& node, std::string_view text) {
  const auto fallback = node.default_value();
  if (!fallback) return false;
  const std::string_view value = read::trimmed(text);
  // Of a value that is missing, consumers take the default.
  if (value.empty() && node.type() != schema::Type::kString) return true;
  switch (node.type()) {
    case schema::Type::kString:
    case schema::Type::kChar: return value == read::trimmed(*fallback);
    case schema::Type::kBool: {
      const auto given = schema::parse_bool(value);
      return std::holds_alternative<bool>(given) && given == schema::parse_bool(*fallback);
    }
    default: break;
  }
  const auto given = write::numbers_in(value);
  const auto taken = write::numbers_in(*fallback);
  if (!given || !taken) return false;
  if (node.type() == schema::Type::kColor) return with_opacity(*given) == with_opacity(*taken);
  return *given == *taken;
}

/// Of a `<pose>`: three zeros, and no turn in either form.
bool is_identity_pose(xml::Element element) {
  const auto numbers = write::numbers_in(element.text());
  if (!numbers) return false;
  const std::vector<double>& n = *numbers;
  const bool quaternion = n.size() == 7 && n[6] != 0;
  if (n.size() != 6 && !quaternion) return false;
  return std::all_of(n.begin(), n.begin() + 6, [](double number) { return number == 0; });
}

struct NamedKind {
  std::string_view name;
  NoteKind kind;
};

/// By the element's own name, or that of the nearest element around it that has one here.
constexpr std::array kKindsByName{NamedKind{"sensor", NoteKind::kSensor},
                                  NamedKind{"light", NoteKind::kLight},
                                  NamedKind{"plugin", NoteKind::kPlugin},
                                  NamedKind{"script", NoteKind::kMaterialScript},
                                  NamedKind{"material", NoteKind::kMaterialLook},
                                  NamedKind{"submesh", NoteKind::kSubmesh},
                                  NamedKind{"geometry", NoteKind::kShapeLost},
                                  NamedKind{"surface", NoteKind::kSurface},
                                  NamedKind{"max_contacts", NoteKind::kSurface},
                                  NamedKind{"cast_shadows", NoteKind::kVisualExtra},
                                  NamedKind{"transparency", NoteKind::kVisualExtra},
                                  NamedKind{"laser_retro", NoteKind::kVisualExtra},
                                  NamedKind{"visibility_flags", NoteKind::kVisualExtra},
                                  NamedKind{"meta", NoteKind::kVisualExtra},
                                  NamedKind{"density", NoteKind::kInertialAutomatic},
                                  NamedKind{"auto_inertia_params", NoteKind::kInertialAutomatic},
                                  NamedKind{"fluid_added_mass", NoteKind::kLinkPhysics},
                                  NamedKind{"velocity_decay", NoteKind::kLinkPhysics},
                                  NamedKind{"damping", NoteKind::kLinkPhysics},
                                  NamedKind{"kinematic", NoteKind::kLinkPhysics},
                                  NamedKind{"must_be_base_link", NoteKind::kLinkPhysics},
                                  NamedKind{"enable_wind", NoteKind::kLinkPhysics},
                                  NamedKind{"battery", NoteKind::kLinkPhysics},
                                  NamedKind{"particle_emitter", NoteKind::kLinkPhysics},
                                  NamedKind{"projector", NoteKind::kLinkPhysics},
                                  NamedKind{"audio_sink", NoteKind::kLinkPhysics},
                                  NamedKind{"audio_source", NoteKind::kLinkPhysics},
                                  NamedKind{"allow_auto_disable", NoteKind::kLinkPhysics},
                                  NamedKind{"self_collide", NoteKind::kSelfCollide},
                                  NamedKind{"gravity", NoteKind::kGravity},
                                  NamedKind{"static", NoteKind::kStatic},
                                  NamedKind{"frame", NoteKind::kFrame},
                                  NamedKind{"include", NoteKind::kUnresolved}};

constexpr std::array kKindsInJoint{NamedKind{"axis2", NoteKind::kSecondAxis},
                                   NamedKind{"mimic", NoteKind::kMimicLost},
                                   NamedKind{"physics", NoteKind::kPhysics},
                                   NamedKind{"stiffness", NoteKind::kStiffness},
                                   NamedKind{"dissipation", NoteKind::kStiffness},
                                   NamedKind{"spring_reference", NoteKind::kSpring},
                                   NamedKind{"spring_stiffness", NoteKind::kSpring},
                                   NamedKind{"gearbox_ratio", NoteKind::kJointTypeLost},
                                   NamedKind{"gearbox_reference_body", NoteKind::kJointTypeLost},
                                   NamedKind{"thread_pitch", NoteKind::kJointTypeLost},
                                   NamedKind{"screw_thread_pitch", NoteKind::kJointTypeLost},
                                   NamedKind{"sensor", NoteKind::kSensor}};

template <std::size_t N>
std::optional<NoteKind> kind_by_name(const std::array<NamedKind, N>& kinds, std::string_view name) {
  const auto* const found = std::find_if(kinds.begin(), kinds.end(),
                                         [name](const NamedKind& k) { return k.name == name; });
  return found == kinds.end() ? std::nullopt : std::optional(found->kind);
}

/// Of what stands in an element of these names nothing is known by the names around them.
bool is_own_scope(std::string_view name) {
  return name == "model" || name == "link" || name == "world" || name == "joint";
}

}  // namespace

bool is_implied(const schema::Schema& schema, xml::Element element) {
  if (!element.children().empty() || !element.lost_text().nowhere()) return false;
  if (element.name() == "pose" && is_identity_pose(element)) return true;
  const auto node = node_of(schema, element);
  if (!node || node->open()) return false;
  if (node->type() != schema::Type::kNone) return equals_default(*node, element.text());
  return element.attributes().empty() && read::trimmed(element.text()).empty();
}

bool is_implied(const Source& source, const model::Site& /*opened*/, xml::Element element) {
  return is_implied(source.schema, element);
}

bool is_implied(const Source& source, xml::Element element, xml::Attribute attribute) {
  return is_implied(source.schema, element, attribute);
}

bool is_implied(const schema::Schema& schema, xml::Element element, xml::Attribute attribute) {
  const std::string_view name = attribute.name();
  if (name == "xmlns" || name.starts_with("xmlns:")) return true;
  const bool of_pose = name == "rotation_format" || name == "degrees";
  if (of_pose && element.name() == "pose" && is_identity_pose(element)) return true;
  const auto node = node_of(schema, element);
  const auto known = node ? node->attribute(name) : std::nullopt;
  return known && equals_default(*known, attribute.value());
}

NoteKind kind_of(xml::Element element) {
  if (element.name() == "model") {
    const auto parent = element.parent();
    return parent && parent->name() == "model" ? NoteKind::kNested : NoteKind::kUnknown;
  }
  bool in_joint = false;
  for (auto at = std::optional(element); at && !in_joint; at = at->parent()) {
    in_joint = at->name() == "joint";
  }
  for (auto at = std::optional(element); at && !is_own_scope(at->name()); at = at->parent()) {
    const auto kind =
        in_joint ? kind_by_name(kKindsInJoint, at->name()) : kind_by_name(kKindsByName, at->name());
    if (kind) return *kind;
    if (at->name() == "visual") return NoteKind::kVisualExtra;
    if (at->name() == "collision") return NoteKind::kSurface;
  }
  const auto parent = element.parent();
  const bool of_model = parent && parent->name() == "model";
  return of_model && element.name() == "pose" ? NoteKind::kModelPose : NoteKind::kUnknown;
}

}  // namespace rigor::convert
