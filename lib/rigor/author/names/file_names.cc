// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/names/file_names.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include <rigor/text/letter_case.h>

namespace rigor::author {
namespace {

constexpr NameKinds kFrameKinds{NameKind::kLink, NameKind::kJoint, NameKind::kFrame,
                                NameKind::kModel};
constexpr NameKinds kLinks{NameKind::kLink};
constexpr NameKinds kJoints{NameKind::kJoint};
constexpr NameKinds kLinksAndJoints{NameKind::kLink, NameKind::kJoint};
constexpr NameKinds kTransformNames{NameKind::kLink, NameKind::kFrame};

/// An attribute, or the text of an element where `attribute` is empty, that names something.
struct ReferencePlace {
  std::string_view parent;   ///< name of the element around; any when empty
  std::string_view element;  ///< any when empty
  std::string_view attribute;
  NameKinds kinds;
};

constexpr ReferencePlace kSdfReferences[] = {
    {"", "", "relative_to", kFrameKinds},     {"", "pose", "frame", kFrameKinds},
    {"", "", "attached_to", kFrameKinds},     {"", "", "expressed_in", kFrameKinds},
    {"joint", "parent", "", kFrameKinds},     {"joint", "child", "", kFrameKinds},
    {"joint", "parent", "link", kLinks},      {"joint", "child", "link", kLinks},
    {"", "mimic", "joint", kJoints},          {"", "gearbox_reference_body", "", kFrameKinds},
    {"gripper", "gripper_link", "", kLinks},  {"gripper", "palm_link", "", kLinks},
    {"", "", "gz:expressed_in", kFrameKinds}, {"", "", "ignition:expressed_in", kFrameKinds},
};

constexpr ReferencePlace kUrdfReferences[] = {
    {"joint", "parent", "link", kLinks},          {"joint", "child", "link", kLinks},
    {"joint", "mimic", "joint", kJoints},         {"sensor", "parent", "link", kLinks},
    {"transmission", "joint", "name", kJoints},   {"ros2_control", "joint", "name", kJoints},
    {"", "gazebo", "reference", kLinksAndJoints}, {"", "", "relative_to", kFrameKinds},
    {"", "", "attached_to", kFrameKinds},         {"sensor", "parent", "joint", kJoints},
    {"", "", "gz:expressed_in", kFrameKinds},     {"", "", "ignition:expressed_in", kFrameKinds},
};

/// Parameters of plugins whose names do not tell that they are a model's: levels and DetachableJoint of gz-sim.
constexpr ReferencePlace kPluginReferences[] = {
    {"performer", "ref", "", {NameKind::kModel}},
    {"level", "ref", "", {NameKind::kModel}},
    {"", "child_model", "", {NameKind::kModel}},
    {"", "parent_model", "", {NameKind::kModel}},
};

constexpr ReferencePlace kSrdfReferences[] = {
    {"group", "link", "name", kLinks},
    {"group", "joint", "name", kJoints},
    {"group", "chain", "base_link", kLinks},
    {"group", "chain", "tip_link", kLinks},
    {"group_state", "joint", "name", kJoints},
    {"", "end_effector", "parent_link", kLinks},
    {"", "virtual_joint", "child_link", kLinks},
    {"", "passive_joint", "name", kJoints},
    {"", "joint_property", "joint_name", kJoints},
    {"", "disable_collisions", "link1", kLinks},
    {"", "disable_collisions", "link2", kLinks},
    {"", "enable_collisions", "link1", kLinks},
    {"", "enable_collisions", "link2", kLinks},
    {"", "disable_default_collisions", "link", kLinks},
    {"", "link_sphere_approximation", "link", kLinks},
};

/// Elements of sensors that name a frame of tf2, which may be a link.
constexpr std::array<std::string_view, 4> kFrameIds{"gz_frame_id", "ignition_frame_id",
                                                    "frame_name", "frameName"};

/// Words in the name of a plugin's parameter whose value is a link or a frame.
constexpr std::array<std::string_view, 3> kLinkWords{"link", "body", "frame"};

bool has_word(std::string_view name, std::string_view word) {
  return lowered(name).find(word) != std::string::npos;
}

class NameCollector {
 public:
  explicit NameCollector(const xml::Document& document) : document_(document) {}

  FileNames collect() && {
    const auto root = document_.root();
    if (!root) return {};
    names_.scopes.push_back({});
    if (root->name() == "sdf" || root->name() == "gazebo") {
      for (const xml::Element child : root->children()) sdf(child, 0);
    } else if (root->name() == "robot") {
      names_.shared_kinds = false;
      robot(*root);
    } else {
      names_.scopes.clear();
    }
    refer_to_other_models();
    return std::move(names_);
  }

 private:
  /// The value's bytes without the blanks around it; nowhere where they are not what is read.
  static Span trimmed(std::string_view value, Span span, bool verbatim) {
    if (!verbatim) return {};
    const std::size_t begin = value.find_first_not_of(" \t\r\n");
    if (begin == std::string_view::npos) return {};
    const std::size_t end = value.find_last_not_of(" \t\r\n") + 1;
    return {span.source, span.begin + static_cast<std::uint32_t>(begin),
            span.begin + static_cast<std::uint32_t>(end)};
  }

  std::string_view bytes(Span span) const {
    return document_.bytes().substr(span.begin, span.size());
  }

  Span name_of(xml::Element element, std::string_view attribute = "name") const {
    const auto name = element.attribute(attribute);
    return name ? trimmed(name->value(), name->value_span(), name->verbatim()) : Span{};
  }

  static Span text_of(xml::Element element) {
    return trimmed(element.text(), element.text_span(), element.text_verbatim());
  }

  std::uint32_t define(NameKind kind, xml::Element element, Span name, std::uint32_t scope) {
    NamedEntity entity;
    entity.kind = kind;
    entity.where = name;
    if (!name.nowhere()) entity.name = bytes(name);
    entity.element = element.span();
    entity.scope = scope;
    names_.entities.push_back(std::move(entity));
    return static_cast<std::uint32_t>(names_.entities.size() - 1);
  }

  std::uint32_t open_scope(std::uint32_t outer, std::uint32_t model) {
    names_.scopes.push_back({outer, model});
    return static_cast<std::uint32_t>(names_.scopes.size() - 1);
  }

  NameReference* refer(Span where, std::uint32_t scope, NameKinds kinds) {
    if (where.nowhere()) return nullptr;
    NameReference reference;
    reference.text = bytes(where);
    reference.where = where;
    reference.scope = scope;
    reference.kinds = kinds;
    names_.references.push_back(std::move(reference));
    return &names_.references.back();
  }

  void perhaps_refer(Span where, std::uint32_t scope, NameKinds kinds) {
    if (NameReference* reference = refer(where, scope, kinds)) reference->certain = false;
  }

  template <std::size_t Count>
  void take_references(const ReferencePlace (&places)[Count], xml::Element element,
                       std::uint32_t scope) {
    const auto parent = element.parent();
    for (const ReferencePlace& place : places) {
      if (!place.element.empty() && place.element != element.name()) continue;
      if (!place.parent.empty() && (!parent || parent->name() != place.parent)) continue;
      refer(place.attribute.empty() ? text_of(element) : name_of(element, place.attribute), scope,
            place.kinds);
    }
  }

  void sdf(xml::Element element, std::uint32_t scope) {
    const std::string_view name = element.name();
    if (name == "world") return sdf_children(element, open_scope(scope, kNoEntity));
    if (name == "model") return model(element, scope);
    if (name == "include") return include(element, scope);
    if (name == "state") return state(element, scope);
    if (name == "plugin") return plugin(element, scope);
    if (name == "link") define(NameKind::kLink, element, name_of(element), scope);
    if (name == "joint") define(NameKind::kJoint, element, name_of(element), scope);
    if (name == "frame" && element.attribute("name"))
      define(NameKind::kFrame, element, name_of(element), scope);
    take_references(kSdfReferences, element, scope);
    if (std::find(kFrameIds.begin(), kFrameIds.end(), name) != kFrameIds.end())
      perhaps_refer(text_of(element), scope, kTransformNames);
    sdf_children(element, scope);
  }

  void sdf_children(xml::Element element, std::uint32_t scope) {
    for (const xml::Element child : element.children()) sdf(child, scope);
  }

  /// Its own pose is in the scope around it.
  void model(xml::Element element, std::uint32_t scope) {
    const std::uint32_t entity = define(NameKind::kModel, element, name_of(element), scope);
    const std::uint32_t inside = open_scope(scope, entity);
    names_.entities[entity].inside = inside;
    for (const std::string_view attribute : {"canonical_link", "placement_frame"})
      refer(name_of(element, attribute), inside, kFrameKinds);
    for (const xml::Element child : element.children())
      sdf(child, child.name() == "pose" ? scope : inside);
  }

  void include(xml::Element element, std::uint32_t scope) {
    const auto name = element.child("name");
    const std::uint32_t entity =
        define(NameKind::kModel, element, name ? text_of(*name) : Span{}, scope);
    if (const auto uri = element.child("uri")) {
      const Span where = text_of(*uri);
      if (!where.nowhere()) names_.entities[entity].uri = bytes(where);
    }
    const auto merge = element.attribute("merge");
    names_.entities[entity].merged = merge && (merge->value() == "true" || merge->value() == "1");
    for (const xml::Element child : element.children()) {
      if (child.name() == "placement_frame") {
        if (NameReference* reference = refer(text_of(child), scope, kFrameKinds))
          reference->within = entity;
      } else if (child.name() != "name" && child.name() != "uri") {
        sdf(child, scope);
      }
    }
  }

  /// Of a world: what it says of models, links and joints has their names.
  void state(xml::Element element, std::uint32_t scope) {
    for (const xml::Element child : element.children()) {
      if (child.name() != "model") continue;
      refer(name_of(child), scope, {NameKind::kModel});
      const Span model = name_of(child);
      if (model.nowhere()) continue;
      for (const xml::Element part : child.children()) {
        const NameKinds kinds = part.name() == "link" ? kLinks : kJoints;
        if (part.name() != "link" && part.name() != "joint") continue;
        if (NameReference* reference = refer(name_of(part), scope, kinds))
          reference->within = entity_named(bytes(model), scope);
      }
    }
  }

  std::uint32_t entity_named(std::string_view name, std::uint32_t scope) const {
    for (std::uint32_t i = 0; i < names_.entities.size(); ++i) {
      if (names_.entities[i].scope == scope && names_.entities[i].name == name) return i;
    }
    return kNoEntity;
  }

  /// Leaves and attributes whose name says that they hold a name, and whatever is scoped.
  void plugin(xml::Element element, std::uint32_t scope) {
    for (const xml::Attribute attribute : element.attributes()) {
      if (element.name() == "plugin") break;  // its own name and its library's
      parameter(attribute.name(),
                trimmed(attribute.value(), attribute.value_span(), attribute.verbatim()),
                element.name(), scope);
    }
    if (element.children().empty() && element.name() != "plugin" &&
        !takes_model_reference(element, scope))
      parameter(element.name(), text_of(element), element.name(), scope);
    for (const xml::Element child : element.children()) plugin(child, scope);
  }

  /// Whether its text is the name of a model, or of a link of another model.
  bool takes_model_reference(xml::Element element, std::uint32_t scope) {
    const auto parent = element.parent();
    for (const ReferencePlace& place : kPluginReferences) {
      if (place.element != element.name()) continue;
      if (!place.parent.empty() && (!parent || parent->name() != place.parent)) continue;
      perhaps_refer(text_of(element), scope, place.kinds);
      return true;
    }
    if (element.name() != "child_link" || !parent || !parent->child("child_model")) return false;
    const Span model = text_of(*parent->child("child_model"));
    others_.push_back({text_of(element), model.nowhere() ? "" : std::string(bytes(model)), scope});
    return true;
  }

  /// The model may be defined behind what refers to its link; of one that is in no model of the file nothing is known.
  void refer_to_other_models() {
    for (const LinkOfOther& each : others_) {
      const std::uint32_t model = model_seen_from(each.model, each.scope);
      if (model == kNoEntity) continue;
      if (NameReference* reference = refer(each.link, each.scope, kLinks)) {
        reference->within = model;
        reference->certain = false;
      }
    }
  }

  /// As gz-sim has it: `__model__` is the plugin's own.
  std::uint32_t model_seen_from(std::string_view name, std::uint32_t scope) const {
    if (name == "__model__") return names_.scopes[scope].model;
    while (true) {
      const std::uint32_t found = entity_named(name, scope);
      if (found != kNoEntity && names_.entities[found].kind == NameKind::kModel) return found;
      if (names_.scopes[scope].outer == scope) return kNoEntity;
      scope = names_.scopes[scope].outer;
    }
  }

  void parameter(std::string_view name, Span value, std::string_view element, std::uint32_t scope) {
    if (value.nowhere()) return;
    const bool scoped = bytes(value).find("::") != std::string_view::npos;
    const bool names_joint =
        has_word(name, "joint") || (name == "name" && has_word(element, "joint"));
    const bool names_link =
        std::any_of(kLinkWords.begin(), kLinkWords.end(), [&](std::string_view word) {
          return has_word(name, word) || (name == "name" && has_word(element, word));
        });
    if (scoped || (names_joint && names_link)) return perhaps_refer(value, scope, kFrameKinds);
    if (names_joint) return perhaps_refer(value, scope, kJoints);
    if (names_link) return perhaps_refer(value, scope, kTransformNames);
  }

  void robot(xml::Element root) {
    const std::uint32_t entity = define(NameKind::kModel, root, name_of(root), 0);
    names_.entities[entity].inside = 0;
    names_.scopes[0].model = entity;
    for (const xml::Element child : root.children()) {
      if (child.name() == "link") define(NameKind::kLink, child, name_of(child), 0);
      if (child.name() == "joint") define(NameKind::kJoint, child, name_of(child), 0);
      robot_part(child);
    }
  }

  void robot_part(xml::Element element) {
    if (element.name() == "plugin") return plugin(element, 0);
    take_references(kUrdfReferences, element, 0);
    take_references(kSrdfReferences, element, 0);
    if (std::find(kFrameIds.begin(), kFrameIds.end(), element.name()) != kFrameIds.end())
      perhaps_refer(text_of(element), 0, kTransformNames);
    for (const xml::Element child : element.children()) robot_part(child);
  }

  /// What a plugin tells of a link of a model that it names, too.
  struct LinkOfOther {
    Span link;
    std::string model;
    std::uint32_t scope;
  };

  const xml::Document& document_;
  FileNames names_;
  std::vector<LinkOfOther> others_;
};

}  // namespace

std::string_view to_string(NameKind kind) {
  switch (kind) {
    case NameKind::kLink: return "link";
    case NameKind::kJoint: return "joint";
    case NameKind::kFrame: return "frame";
    case NameKind::kModel: return "model";
  }
  return "";
}

std::optional<NameKinds> referenced_kinds(std::string_view root, std::string_view parent,
                                          std::string_view element, std::string_view attribute) {
  const auto find = [&](const auto& places) -> std::optional<NameKinds> {
    for (const ReferencePlace& place : places) {
      const bool fits = (place.element.empty() || place.element == element) &&
                        (place.parent.empty() || place.parent == parent) &&
                        place.attribute == attribute;
      if (fits && !(place.element.empty() && attribute.empty())) return place.kinds;
    }
    return std::nullopt;
  };
  if (root == "sdf") {
    if (element == "model" && attribute == "canonical_link") return kLinks;
    if (element == "model" && attribute == "placement_frame") return kFrameKinds;
    return find(kSdfReferences);
  }
  if (auto kinds = find(kUrdfReferences)) return kinds;
  return find(kSrdfReferences);
}

FileNames file_names(const xml::Document& document) { return NameCollector(document).collect(); }

}  // namespace rigor::author
