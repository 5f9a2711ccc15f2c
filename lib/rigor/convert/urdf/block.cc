// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `<gazebo>` blocks: what URDF has no word for, in the words in which Gazebo's reader of URDF takes it
// back. What it does not know it puts into the link, joint or model as it stands.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/convert/number_text.h>
#include <rigor/convert/plugin_text.h>
#include <rigor/convert/urdf/draft.h>
#include <rigor/convert/urdf/parts.h>
#include <rigor/convert/written_number.h>
#include <rigor/convert/xml_layout.h>
#include <rigor/model/subject.h>
#include <rigor/read/values.h>
#include <rigor/xml/edit.h>

namespace rigor::convert {
namespace {

using model::Id;
using model::Pose;

std::string block_line(std::string_view key, std::string_view value) {
  const std::string name(key);
  return '<' + name + '>' + xml::escaped(read::trimmed(value)) + "</" + name + ">\n";
}

/// Collects the lines of one block, and tells what they carry.
class BlockMaker {
 public:
  BlockMaker(UrdfDraft& draft, std::string reference)
      : draft_(draft), reference_(std::move(reference)) {}

  void add(const std::string& lines) { lines_ += lines; }

  void add_key(std::string_view key, std::string_view value) { lines_ += block_line(key, value); }

  /// How many elements and attributes that are.
  std::size_t add_as_it_stands(xml::Element element, const LayoutChanges& changes = {}) {
    const SourceId source = element.name_span().source;
    lines_ += laid_out(draft_.source.documents.of(source), element, changes);
    return draft_.ledger.take_all(element, Outcome::kCarried);
  }

  /// As it stands; with a pose of its own where one is given.
  void add_element(xml::Element element, NoteKind kind, std::string subject,
                   const std::optional<std::string>& pose = {}) {
    const auto name = element.attribute("name");
    draft_.ledger.note({.kind = kind,
                        .outcome = Outcome::kCarried,
                        .where = element.name_span(),
                        .subject = std::move(subject),
                        .written = name ? std::string(name->value()) : std::string(),
                        .instead = {},
                        .count = add_as_it_stands(element, changes_in(element, pose))});
  }

  /// Of the source's link that plugins are in, by its name inside the model that is converted.
  void of_link(const std::string& name) { own_link_ = name; }

  /// Of the source's model that plugins are in.
  void of_model(Id<model::Model> id) {
    for (; id && id != draft_.top; id = draft_.source.root[id].parent) {
      const std::string& name = draft_.source.root[id].name.value;
      own_model_ = own_model_.empty() ? name : name + "::" + own_model_;
    }
  }

  void note(NoteKind kind, Span where, std::string subject, std::string written) {
    draft_.ledger.note({.kind = kind,
                        .outcome = Outcome::kCarried,
                        .where = where,
                        .subject = std::move(subject),
                        .written = std::move(written)});
  }

  void finish() && {
    if (!lines_.empty()) draft_.robot.blocks.push_back({std::move(reference_), std::move(lines_)});
  }

 private:
  LayoutChanges changes_in(xml::Element element, const std::optional<std::string>& pose) {
    LayoutChanges changes;
    changes.pose = pose;
    if (element.name() == "plugin") changes.added = add_changes(element, changes);
    for (const xml::Element child : element.children()) {
      if (child.name() == "plugin") add_changes(child, changes);
    }
    return changes;
  }

  /// What a plugin says of links whose frames moved to their joints, and of what has a new name; gives
  /// the elements that it has not had.
  std::vector<std::string> add_changes(xml::Element plugin, LayoutChanges& changes) {
    PluginText text =
        plugin_text(plugin, draft_.plugin_names, {.link = own_link_, .model = own_model_});
    auto& all = changes.replacements;
    all.insert(all.end(), text.layout.replacements.begin(), text.layout.replacements.end());
    const auto name = plugin.attribute("name");
    for (PluginRemark& remark : text.remarks) {
      const bool left = remark.kind == PluginRemark::Kind::kLeftInFrame;
      draft_.ledger.note({.kind = left ? NoteKind::kPluginFrame : NoteKind::kPluginReference,
                          .outcome = left ? Outcome::kCarried : Outcome::kRewritten,
                          .where = remark.where,
                          .subject = "plugin " + std::string(name ? name->value() : ""),
                          .written = std::move(remark.written),
                          .instead = std::move(remark.instead)});
    }
    return std::move(text.layout.added);
  }

  UrdfDraft& draft_;
  std::string reference_;
  std::string own_link_, own_model_;
  std::string lines_;
};

const UrdfDraft::Riders& riders_of(UrdfDraft& draft) {
  if (draft.riders) return *draft.riders;
  const model::Root& root = draft.source.root;
  UrdfDraft::Riders riders;
  for (std::uint32_t i = 0; i < root.lights.size(); ++i) {
    if (root.lights[i].link) riders.lights.emplace(root.lights[i].link, Id<model::Light>{i});
  }
  for (std::uint32_t i = 0; i < root.sensors.size(); ++i) {
    if (root.sensors[i].joint) riders.sensors.emplace(root.sensors[i].joint, Id<model::Sensor>{i});
  }
  return draft.riders.emplace(std::move(riders));
}

std::string pose_line(const UrdfOrigin& origin) {
  return "<pose>" + number_texts(origin.xyz) + ' ' + number_texts(origin.rpy) + "</pose>";
}

/// Nothing when the pose stays as it is written.
std::optional<std::string> pose_in_link(UrdfDraft& draft, Id<model::Link> link, const Pose& X_JL,
                                        const model::PoseField& pose,
                                        const std::optional<Pose>& X_WP) {
  if (is_identity(X_JL) && pose.relative_to.value.empty()) return std::nullopt;
  const UrdfOrigin origin = origin_in_link(draft, link, X_JL, pose, X_WP);
  if (is_identity(origin) && pose.site.span.nowhere()) return std::nullopt;
  return pose_line(origin);
}

/// A link that says nothing of it does as its model.
model::Field<bool> self_collide_of(UrdfDraft& draft, const model::Link& link) {
  const Source& source = draft.source;
  const auto own =
      bool_field(read::child_text(source.documents.element(link.site), "self_collide"), false);
  const model::Model& model = source.root[link.model];
  if (own.written || model.site.span.nowhere()) return own;
  // Sought once: a model may have thousands of links, all of which ask.
  const auto [known, is_new] = draft.self_collide.try_emplace(link.model);
  if (is_new) {
    known->second =
        bool_field(read::child_text(source.documents.element(model.site), "self_collide"), false);
  }
  return known->second;
}

/// A value of a joint's physics for the block, where it is written and not the default.
class JointPhysics {
 public:
  JointPhysics(UrdfDraft& draft, const model::Joint& joint, BlockMaker& block)
      : draft_(draft), site_(joint.site), block_(block) {
    physics_ = draft.source.documents.element(joint.site).child("physics");
    ode_ = below(physics_, "ode");
  }

  void carry() {
    carry_value("provideFeedback", physics_, "provide_feedback");
    carry_value("provideFeedback", ode_, "provide_feedback");
    carry_value("implicitSpringDamper", ode_, "implicit_spring_damper");
    carry_value("cfmDamping", ode_, "cfm_damping");
    carry_value("fudgeFactor", ode_, "fudge_factor");
    const auto limit = below(ode_, "limit");
    carry_value("stopCfm", limit, "cfm");
    carry_value("stopErp", limit, "erp");
  }

 private:
  static std::optional<xml::Element> below(const std::optional<xml::Element>& parent,
                                           std::string_view name) {
    return parent ? parent->child(name) : std::nullopt;
  }

  void carry_value(std::string_view key, const std::optional<xml::Element>& parent,
                   std::string_view name) {
    if (!parent || key == last_) return;
    std::optional<read::Text> text;
    if (const auto leaf = parent->child(name)) {
      if (!is_implied(draft_.source, site_, *leaf)) text = {leaf->text(), leaf->text_span()};
    } else if (const auto attribute = parent->attribute(name)) {
      if (!is_implied(draft_.source, *parent, *attribute)) {
        text = {attribute->value(), attribute->value_span()};
      }
    }
    if (!text) return;
    block_.add_key(key, text->text);
    draft_.ledger.take_value(text->span, Outcome::kCarried);
    last_ = key;
  }

  UrdfDraft& draft_;
  const model::Site& site_;
  BlockMaker& block_;
  std::optional<xml::Element> physics_, ode_;
  std::string_view last_;  // the key that was carried last: it may stand in two places
};

/// A spring without stiffness is none, whatever its reference.
void carry_spring(UrdfDraft& draft, const model::Joint& joint, BlockMaker& block) {
  if (joint.axes.empty()) return;
  const model::Axis& axis = joint.axes.front();
  const bool none = axis.spring_stiffness.value == 0;
  const Outcome outcome = none ? Outcome::kImplied : Outcome::kCarried;
  draft.ledger.take(axis.spring_stiffness, outcome);
  draft.ledger.take(axis.spring_reference, outcome);
  if (none) return;
  const read::Documents& documents = draft.source.documents;
  const std::string stiffness = to_text(written_number(documents, axis.spring_stiffness));
  const std::string reference = to_text(written_number(documents, axis.spring_reference));
  block.add_key("springReference", reference);
  block.add_key("springStiffness", stiffness);
  block.note(NoteKind::kSpring, axis.spring_stiffness.span, subject(draft.source.root, joint),
             "stiffness " + stiffness + ", reference " + reference);
}

/// The block's key sets both; where they differ Gazebo takes the element as it stands.
void carry_damping(UrdfDraft& draft, const model::Link& link, const std::string& whose,
                   BlockMaker& block) {
  const auto decay = draft.source.documents.element(link.site).child("velocity_decay");
  if (!decay) return;
  const auto linear = read::number_field(read::child_text(*decay, "linear"), 0);
  const auto angular = read::number_field(read::child_text(*decay, "angular"), 0);
  if (linear.value == 0 && angular.value == 0) return;
  if (linear.value == angular.value) {
    block.add_key("dampingFactor", to_text(written_number(draft.source.documents, linear)));
    draft.ledger.take_all(*decay, Outcome::kCarried);
  } else {
    block.add_as_it_stands(*decay);
  }
  block.note(NoteKind::kLinkPhysics, decay->name_span(), whose, "velocity_decay");
}

void carry_static(UrdfDraft& draft, const model::Model& model, BlockMaker& block) {
  if (!model.is_static.value || draft.options.static_model != StaticPolicy::kBlock) return;
  const std::string whose = subject(draft.source.root, model);
  if (!model.parent) {
    block.add_key("static", "true");
    block.note(NoteKind::kStatic, model.is_static.span, whose, "true");
    draft.ledger.take(model.is_static, Outcome::kCarried);
    return;
  }
  // Part of a robot that moves: the block would hold the whole.
  draft.ledger.take(model.is_static, Outcome::kLost);
  draft.ledger.note({.kind = NoteKind::kStatic,
                     .outcome = Outcome::kLost,
                     .where = model.is_static.span,
                     .subject = whose,
                     .written = "true"});
}

void carry_plugins(xml::Element parent, const std::string& whose, BlockMaker& block) {
  for (const xml::Element child : parent.children()) {
    if (child.name() == "plugin") block.add_element(child, NoteKind::kPlugin, whose);
  }
}

}  // namespace

void add_link_blocks(UrdfDraft& draft, Id<model::Link> id, const Pose& X_JL, const PartKeys& keys) {
  const model::Root& root = draft.source.root;
  const model::Link& link = root[id];
  const std::string whose = subject(root, link);
  BlockMaker block(draft, draft.link_names.at(id));
  block.of_link(model::name_in(root, draft.top, id));
  block.of_model(link.model);
  if (!keys.script.empty()) block.add_key("material", keys.script);
  block.add(keys.surface);
  if (const auto self_collide = self_collide_of(draft, link); self_collide.value) {
    block.add_key("selfCollide", "true");
    block.note(NoteKind::kSelfCollide, self_collide.span, whose, "true");
    draft.ledger.take(self_collide, Outcome::kCarried);
  }
  if (!link.gravity.value) {
    block.add_key("turnGravityOff", "true");
    block.note(NoteKind::kGravity, link.gravity.span, whose, "false");
    draft.ledger.take(link.gravity, Outcome::kCarried);
  }
  for (const Id<model::Sensor> sensor_id : link.sensors) {
    const model::Sensor& sensor = root[sensor_id];
    block.add_element(
        draft.source.documents.element(sensor.site), NoteKind::kSensor, subject(root, sensor),
        pose_in_link(draft, id, X_JL, sensor.pose, draft.source.frames.pose(sensor_id)));
  }
  const auto [first, last] = riders_of(draft).lights.equal_range(id);
  for (auto entry = first; entry != last; ++entry) {
    const model::Light& light = root[entry->second];
    block.add_element(
        draft.source.documents.element(light.site), NoteKind::kLight, subject(root, light),
        pose_in_link(draft, id, X_JL, light.pose, draft.source.frames.pose(entry->second)));
  }
  carry_damping(draft, link, whose, block);
  carry_plugins(draft.source.documents.element(link.site), whose, block);
  std::move(block).finish();
}

void add_joint_blocks(UrdfDraft& draft, Id<model::Joint> id, const std::string& name) {
  const model::Root& root = draft.source.root;
  const model::Joint& joint = root[id];
  BlockMaker block(draft, name);
  if (joint.type == model::JointType::kFixed) block.add_key("preserveFixedJoint", "true");
  JointPhysics(draft, joint, block).carry();
  carry_spring(draft, joint, block);
  const auto [first, last] = riders_of(draft).sensors.equal_range(id);
  for (auto entry = first; entry != last; ++entry) {
    const model::Sensor& sensor = root[entry->second];
    const auto X_WJ = draft.source.frames.pose(id);
    const auto X_WS = draft.source.frames.pose(entry->second);
    std::optional<std::string> pose;
    if (!sensor.pose.relative_to.value.empty() && X_WJ && X_WS) {
      pose = pose_line(origin_of(compose(inverse(*X_WJ), *X_WS)));
    }
    block.add_element(draft.source.documents.element(sensor.site), NoteKind::kSensor,
                      subject(root, sensor), pose);
  }
  std::move(block).finish();
}

void add_model_blocks(UrdfDraft& draft, Id<model::Model> id) {
  const model::Root& root = draft.source.root;
  const model::Model& model = root[id];
  const std::string whose = subject(root, model);
  BlockMaker block(draft, {});
  block.of_model(id);
  carry_static(draft, model, block);
  carry_plugins(draft.source.documents.element(model.site), whose, block);
  if (model.include < root.includes.size()) {
    carry_plugins(draft.source.documents.element(root.includes[model.include].site), whose, block);
  }
  std::move(block).finish();
}

}  // namespace rigor::convert
