// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/convert/plugin_text.h>
#include <rigor/convert/sdf/control.h>
#include <rigor/convert/sdf/draft.h>
#include <rigor/convert/sdf/ignored_value.h>
#include <rigor/convert/xml_layout.h>
#include <rigor/model/subject.h>
#include <rigor/read/values.h>
#include <rigor/schema/script_material.h>
#include <rigor/write/numbers.h>
#include <rigor/xml/edit.h>

namespace rigor::convert {
namespace {

using model::Id;

/// A key of a block and where SDF has it.
struct BlockKey {
  std::string_view key;
  std::string_view path;
};

constexpr BlockKey kCollisionKeys[] = {
    {"mu1", "surface/friction/ode/mu"},        {"mu", "surface/friction/ode/mu"},
    {"mu2", "surface/friction/ode/mu2"},       {"fdir1", "surface/friction/ode/fdir1"},
    {"kp", "surface/contact/ode/kp"},          {"kd", "surface/contact/ode/kd"},
    {"maxVel", "surface/contact/ode/max_vel"}, {"minDepth", "surface/contact/ode/min_depth"},
    {"maxContacts", "max_contacts"},           {"laserRetro", "laser_retro"},
};
constexpr BlockKey kLinkKeys[] = {
    {"selfCollide", "self_collide"},
    {"self_collide", "self_collide"},
    {"gravity", "gravity"},
};
constexpr BlockKey kJointKeys[] = {
    {"stopCfm", "physics/ode/limit/cfm"},
    {"stopErp", "physics/ode/limit/erp"},
    {"fudgeFactor", "physics/ode/fudge_factor"},
    {"cfmDamping", "physics/ode/cfm_damping"},
    {"implicitSpringDamper", "physics/ode/implicit_spring_damper"},
    {"provideFeedback", "physics/provide_feedback"},
};
constexpr BlockKey kAxisKeys[] = {
    {"springReference", "dynamics/spring_reference"},
    {"springStiffness", "dynamics/spring_stiffness"},
};
/// What only tells the official converter how to convert.
constexpr std::string_view kHints[] = {"preserveFixedJoint", "disableFixedJointLumping",
                                       "canonicalBody"};
/// What has a pose in the link.
constexpr std::string_view kPlaced[] = {"sensor", "light", "particle_emitter", "projector"};

template <class Keys>
const BlockKey* find_key(const Keys& keys, std::string_view name) {
  const auto found = std::find_if(std::begin(keys), std::end(keys),
                                  [name](const BlockKey& key) { return key.key == name; });
  return found == std::end(keys) ? nullptr : &*found;
}

template <class Names>
bool is_among(const Names& names, std::string_view name) {
  return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

/// Sets what stands at a path whose first step is one of the elements.
void set_at(std::vector<SdfElement>& elements, std::string_view path, std::string_view text) {
  SdfElement all{.name = {}, .text = {}, .children = std::move(elements)};
  all.set(path, std::string(text));
  elements = std::move(all.children);
}

/// Elements of SDF that libsdformat copies: no keys of its own, though they set what a key sets.
constexpr std::string_view kCopiedKeys[] = {"gravity", "self_collide"};

/// `<mu1 value="0.2"/>` or `<mu1>0.2</mu1>`; of both libsdformat takes the attribute.
std::string_view value_of_key(xml::Element element) {
  const auto attribute = element.attribute("value");
  const bool reads_it = attribute && !is_among(kCopiedKeys, element.name());
  return read::trimmed(reads_it ? attribute->value() : element.text());
}

/// Elements are as deep as the file, at most xml::kMaxDepth.
SdfElement tree_of(xml::Element element, const IgnoredValues& ignored) {
  SdfElement tree{.name = std::string(element.name()),
                  .text = std::string(read::trimmed(element.text()))};
  for (const xml::Attribute attribute : element.attributes()) {
    if (!ignored.has(attribute)) tree.attributes.emplace_back(attribute.name(), attribute.value());
  }
  for (const xml::Element child : element.children()) {
    if (!ignored.has(child)) tree.children.push_back(tree_of(child, ignored));
  }
  return tree;
}

/// Takes the place of what has its name.
void put(std::vector<SdfElement>& elements, SdfElement element) {
  const auto same = std::find_if(elements.begin(), elements.end(),
                                 [&](const SdfElement& e) { return e.name == element.name; });
  if (same == elements.end()) {
    elements.push_back(std::move(element));
  } else {
    *same = std::move(element);
  }
}

class BlockConverter {
 public:
  BlockConverter(SdfDraft& draft, const model::GazeboBlock& block)
      : draft_(draft),
        ledger_(draft.ledger),
        block_(block),
        element_(draft.source.documents.element(block.site)) {}

  void convert() {
    const model::Names& names = draft_.source.frames.names();
    link_ = names.find_link({0}, block_.reference.value);
    joint_ = names.find_joint({0}, block_.reference.value);
    const bool whole = block_.reference.value.empty();
    if (!whole && !link_ && !joint_) return lose();
    ledger_.take(block_.site);
    ledger_.take(block_.reference);
    for (const xml::Element child : element_.children()) {
      if (is_among(kHints, child.name())) {
        ledger_.pass_over(child, whose(),
                          std::string(child.name()) + ", advice to another converter");
      } else if (is_empty_key(child)) {
        continue;
      } else if (whole && child.name() == "plugin" && is_control(draft_.options.control, child)) {
        continue;  // written anew (control.cc)
      } else if (whole) {
        add_to_model(child);
      } else if (joint_ && (is_joint_key(child.name()) || !link_)) {
        add_to_joint(child);
      } else {
        add_to_link(child);
      }
    }
    if (!without_collision_.empty()) note(NoteKind::kBlockWithoutCollision, without_collision_);
  }

 private:
  static bool is_joint_key(std::string_view name) {
    return find_key(kJointKeys, name) != nullptr || find_key(kAxisKeys, name) != nullptr;
  }

  static std::string_view value(xml::Element element) { return value_of_key(element); }

  /// A key without a value says nothing: no code takes it, so it is in the account as lost.
  static bool is_key(std::string_view name) {
    return find_key(kCollisionKeys, name) != nullptr || find_key(kLinkKeys, name) != nullptr ||
           is_joint_key(name) || name == "turnGravityOff" || name == "dampingFactor" ||
           name == "static" || name == "material";
  }
  static bool is_empty_key(xml::Element element) {
    return is_key(element.name()) && element.children().empty() && value(element).empty();
  }

  std::string whose() const {
    return model::subject(draft_.source.root, draft_.source.root.models[0]);
  }

  void note(NoteKind kind, std::string written) {
    ledger_.note({.kind = kind,
                  .outcome = Outcome::kLost,
                  .where = block_.reference.written ? block_.reference.span : block_.site.name,
                  .subject = whose(),
                  .written = std::move(written)});
  }

  void lose() {
    ledger_.lose(block_.site, {.kind = NoteKind::kBlockReference,
                               .where = block_.reference.span,
                               .subject = whose(),
                               .written = block_.reference.value});
  }

  void add_to_model(xml::Element child) {
    if (child.name() == "static" || child.name() == "self_collide" ||
        child.name() == "selfCollide") {
      const char* name = child.name() == "static" ? "static" : "self_collide";
      put(draft_.robot.settings, {.name = name, .text = std::string(value(child))});
    } else {
      add_copied(draft_.robot.raw, child, "model");
    }
    ledger_.take_all(child);
  }

  /// What libsdformat copies, as it stands but for what it ignores then: that is lost.
  void add_copied(std::vector<std::string>& raw, xml::Element child, std::string_view parent,
                  std::optional<std::string> pose = {}) {
    const IgnoredValues ignored = lose_ignored(child, parent);
    if (ignored.has(child)) return;
    raw.push_back(as_it_stands(child, ignored, std::move(pose)));
  }

  IgnoredValues lose_ignored(xml::Element child, std::string_view parent) {
    IgnoredValues ignored = ignored_values(child, parent, {draft_.robot.version});
    ignored.lose(ledger_, subject_in(parent));
    return ignored;
  }

  std::string subject_in(std::string_view parent) const {
    const model::Root& root = draft_.source.root;
    if (parent == "link") return model::subject(root, root[link_]);
    if (parent == "joint") return model::subject(root, root[joint_]);
    return whose();
  }

  /// With the names and frames of the result.
  std::string as_it_stands(xml::Element child, const IgnoredValues& ignored,
                           std::optional<std::string> pose) {
    if (child.name() != "plugin") {
      LayoutChanges changes = without_scopes(child);
      ignored.leave_out(document(), changes);
      changes.pose = std::move(pose);
      in_plugins_of(child, changes);
      return laid_out(document(), child, changes);
    }
    return laid_out(document(), child, changes_in(child));
  }

  /// Plugins of sensors.
  void in_plugins_of(xml::Element element, LayoutChanges& changes) {
    for (const xml::Element child : element.children()) {
      if (child.name() != "plugin") continue;
      const LayoutChanges inner = changes_in(child);
      changes.replacements.insert(changes.replacements.end(), inner.replacements.begin(),
                                  inner.replacements.end());
    }
  }

  LayoutChanges changes_in(xml::Element plugin) {
    const std::string own = link_ ? draft_.source.root[link_].name.value : std::string();
    PluginText text = plugin_text(plugin, draft_.plugin_names, {.link = own, .model = {}});
    for (PluginRemark& remark : text.remarks) tell(std::move(remark));
    return std::move(text.layout);
  }

  void tell(PluginRemark remark) {
    using Kind = PluginRemark::Kind;
    Note note{
        .kind =
            remark.kind == Kind::kLeftInFrame ? NoteKind::kPluginFrame : NoteKind::kPluginReference,
        .outcome = remark.kind == Kind::kLeftInFrame ? Outcome::kConverted : Outcome::kRewritten,
        .where = remark.where,
        .subject = whose(),
        .written = std::move(remark.written),
        .instead = std::move(remark.instead)};
    if (remark.kind == Kind::kNoJoint) {
      ledger_.take_value(remark.where, Outcome::kLost);
      note.kind = NoteKind::kUnknown;
      note.outcome = Outcome::kLost;
      note.written = "joint " + note.written + ", which a plugin names,";
    }
    ledger_.note(std::move(note));
  }

  const xml::Document& document() const {
    return draft_.source.documents.of(block_.site.span.source);
  }

  void add_to_joint(xml::Element child) {
    SdfJoint* joint = draft_.joint(joint_);
    if (joint == nullptr) return;  // no code takes it: it is lost
    if (const BlockKey* key = find_key(kJointKeys, child.name())) {
      set_at(joint->rest, key->path, value(child));
    } else if (const BlockKey* axis_key = find_key(kAxisKeys, child.name())) {
      if (!joint->axis) return;
      set_at(joint->axis->rest, axis_key->path, value(child));
    } else {
      add_copied(joint->raw, child, "joint");
    }
    ledger_.take_all(child);
  }

  void add_to_link(xml::Element child) {
    const SdfNode& node = draft_.node(link_);
    auto& held = draft_.links[node.holder.value];
    if (!held) return;
    if (const BlockKey* key = find_key(kCollisionKeys, child.name())) {
      for_own(held->collisions, child,
              [&](SdfShape& shape) { set_at(shape.rest, key->path, value(child)); });
    } else if (const BlockKey* link_key = find_key(kLinkKeys, child.name())) {
      set_at(held->settings, link_key->path, value(child));
      ledger_.take_all(child);
    } else if (child.name() == "turnGravityOff") {
      const bool off = read::bool_field(read::Text{value(child), child.text_span()}, false).value;
      set_at(held->settings, "gravity", off ? "false" : "true");
      ledger_.take_all(child);
    } else if (child.name() == "dampingFactor") {
      set_at(held->settings, "velocity_decay/linear", value(child));
      set_at(held->settings, "velocity_decay/angular", value(child));
      ledger_.take_all(child);
    } else if (child.name() == "material" && child.children().empty()) {
      for_own(held->visuals, child, [&](SdfShape& shape) { add_script(shape, value(child)); });
    } else if (child.name() == "visual") {
      merge_into_own(held->visuals, child);
    } else if (child.name() == "collision") {
      merge_into_own(held->collisions, child);
    } else if (!is_joint_key(child.name())) {
      add_copied(held->raw, child, "link", pose_in_frame(child, node));
      ledger_.take_all(child);
    }
  }

  /// The holder's shapes that are this link's own.
  std::vector<SdfShape*> own_of(std::vector<SdfShape>& shapes) const {
    const SdfNode& node = draft_.node(link_);
    const std::string frame = node.role == SdfNode::Role::kFrame ? node.name : std::string();
    std::vector<SdfShape*> own;
    for (SdfShape& shape : shapes) {
      if (shape.pose.relative_to == frame) own.push_back(&shape);
    }
    return own;
  }

  void merge_into_own(std::vector<SdfShape>& shapes, xml::Element child) {
    // Without a shape all of it is lost, for another reason.
    const IgnoredValues ignored =
        own_of(shapes).empty() ? IgnoredValues{} : lose_ignored(child, "link");
    for_own(shapes, child, [&](SdfShape& shape) { merge(shape, child, ignored); });
  }

  template <class F>
  void for_own(std::vector<SdfShape>& shapes, xml::Element child, const F& f) {
    const std::vector<SdfShape*> own = own_of(shapes);
    for (SdfShape* shape : own) f(*shape);
    if (!own.empty()) {
      ledger_.take_all(child);
    } else if (&shapes == &draft_.links[draft_.node(link_).holder.value]->collisions) {
      without_collision_ += (without_collision_.empty() ? "" : ", ") + std::string(child.name());
      ledger_.take_all(child, Outcome::kLost);
    } else {
      ledger_.pass_over(child, model::subject(draft_.source.root, draft_.source.root[link_]),
                        std::string(child.name()) + " of a link that is not drawn");
    }
  }

  static void add_script(SdfShape& shape, std::string_view name) {
    set_at(shape.rest, "material/script/uri", "file://media/materials/scripts/gazebo.material");
    set_at(shape.rest, "material/script/name", name);
    // Gazebo Sim reads no scripts: it has the color beside it, as Gazebo classic draws it.
    const auto known = schema::find_material(name);
    if (!known) return;
    const auto& [r, g, b] = known->ambient;
    set_at(shape.rest, "material/ambient", write::joined({r, g, b, known->diffuse[3]}));
    set_at(shape.rest, "material/diffuse",
           write::joined({known->diffuse.begin(), known->diffuse.end()}));
  }

  static void merge(SdfShape& shape, xml::Element child, const IgnoredValues& ignored) {
    if (ignored.has(child)) return;
    for (const xml::Element part : child.children()) {
      if (part.name() == "pose" || part.name() == "geometry" || ignored.has(part)) continue;
      put(shape.rest, tree_of(part, ignored));
    }
  }

  /// What stood in a link that became a frame stands there still.
  static std::optional<std::string> pose_in_frame(xml::Element child, const SdfNode& node) {
    if (node.role != SdfNode::Role::kFrame || !is_among(kPlaced, child.name())) return std::nullopt;
    const auto pose = child.child("pose");
    const std::string tag = "<pose relative_to=\"" + xml::escaped(node.name) + '"';
    const std::string_view text = pose ? read::trimmed(pose->text()) : std::string_view();
    if (pose && pose->attribute("relative_to")) return std::nullopt;
    return text.empty() ? tag + "/>" : tag + '>' + std::string(text) + "</pose>";
  }

  SdfDraft& draft_;
  Ledger& ledger_;
  const model::GazeboBlock& block_;
  xml::Element element_;
  Id<model::Link> link_;
  Id<model::Joint> joint_;
  std::string without_collision_;
};

PluginNames plugin_names_of(SdfDraft& draft) {
  PluginNames names;
  const model::Root& root = draft.source.root;
  names.model = root.models.front().name.value;
  std::vector<model::Pose> X_HL(root.links.size());  // of each link in the one that holds it
  for (const Id<model::Link> id : draft.tree.order) {
    const SdfNode& node = draft.node(id);
    const std::string& name = root[id].name.value;
    if (node.holder && node.holder != id) {
      const bool below = node.carrier && draft.node(node.parent).holder == node.holder;
      X_HL[id.value] = below ? compose(X_HL[node.parent.value], root[node.carrier].pose.pose.value)
                             : pose_in_holder(draft, id);
    }
    if (node.role == SdfNode::Role::kFrame) {
      names.moved.insert_or_assign(
          name, PluginNames::Moved{draft.node(node.holder).name, X_HL[id.value]});
    }
    if (node.name != name) names.links.insert_or_assign(name, node.name);
  }
  for (std::uint32_t i = 0; i < root.joints.size(); ++i) {
    const std::string& name = root.joints[i].name.value;
    if (draft.tree.joint_names[i] != name) {
      names.joints.insert_or_assign(name, draft.tree.joint_names[i]);
    }
    if (draft.joint({i}) == nullptr) names.lost_joints.insert(name);
  }
  return names;
}

}  // namespace

void add_gazebo_blocks(SdfDraft& draft) {
  draft.plugin_names = plugin_names_of(draft);
  for (const model::GazeboBlock& block : draft.source.root.gazebo_blocks) {
    BlockConverter(draft, block).convert();
  }
}

}  // namespace rigor::convert
