// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/urdf_to_sdf.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <rigor/convert/comments.h>
#include <rigor/convert/sdf/control.h>
#include <rigor/convert/sdf/draft.h>
#include <rigor/model/subject.h>
#include <rigor/read/values.h>

namespace rigor::convert {
namespace {

using model::Id;
using Role = SdfNode::Role;

/// All links that need a mass without having one weigh this share of the robot together: a tenth of
/// what a comparison of masses lets pass.
constexpr double kNothingShare = 1e-10;
/// kg, what a robot that has no mass at all is taken for.
constexpr double kSupposedMass = 1;

double next_to_nothing_of(const model::Root& root, const SdfTree& tree) {
  double total = 0;
  int count = 0;
  for (const Id<model::Link> id : tree.order) {
    if (!is_massless(root[id])) total += std::abs(root[id].inertial.mass.value);
    count += is_massless(root[id]) && tree.nodes[id.value].role == Role::kLink ? 1 : 0;
  }
  if (!(total > 0) || !std::isfinite(total)) total = kSupposedMass;
  return std::pow(10, std::floor(std::log10(kNothingShare * total / std::max(count, 1))));
}

class UrdfToSdf {
 public:
  UrdfToSdf(const Source& source, const SdfOptions& options)
      : source_(source), options_(options), root_(source.root), ledger_(source.documents) {}

  SdfConversion convert() {
    ledger_.open(root_.site);
    if (root_.models.empty() || root_.links.empty() || root_.format != model::Format::kUrdf) {
      ledger_.take_all(root_.site, Outcome::kLost);
      ledger_.note({.kind = NoteKind::kNoModel, .where = root_.site.name});
    } else if (auto tree = sdf_tree(source_, options_, ledger_)) {
      build(*std::move(tree));
    } else {
      ledger_.take_all(root_.site, Outcome::kLost);
    }
    result_.account = std::move(ledger_).close(
        [](const model::Site&, xml::Element) { return false; },
        [](xml::Element, xml::Attribute attribute) { return is_implied_in_urdf(attribute); },
        urdf_kind_of);
    return std::move(result_);
  }

 private:
  static bool is_implied_in_urdf(xml::Attribute attribute) {
    return attribute.name().substr(0, 5) == "xmlns";
  }

  static NoteKind urdf_kind_of(xml::Element element) {
    static constexpr std::pair<std::string_view, NoteKind> kKinds[] = {
        {"safety_controller", NoteKind::kSafety},  {"calibration", NoteKind::kCalibration},
        {"transmission", NoteKind::kTransmission}, {"ros2_control", NoteKind::kRos2Control},
        {"texture", NoteKind::kTexture},           {"sensor", NoteKind::kSensor},
    };
    for (const auto& [name, kind] : kKinds) {
      if (element.name() == name) return kind;
    }
    return NoteKind::kUnknown;
  }

  void build(SdfTree tree) {
    const double nothing = next_to_nothing_of(root_, tree);
    SdfDraft draft{source_, options_, ledger_, std::move(tree), {}, {}, {}, {}, {}, nothing};
    const model::Model& robot = root_.models[0];
    ledger_.take(root_.site);
    ledger_.take(robot.name);
    ledger_.take(root_.version_text);
    draft.robot.name = robot.name.value.empty() ? "robot" : sdf_name(robot.name.value);
    draft.robot.version = version();
    draft.robot.comments = remarks_on_file(source_.documents.of(root_.site.span.source));
    find_materials(draft);
    add_sdf_links(draft);
    tell_unused_materials(draft);
    for (std::uint32_t i = 0; i < root_.joints.size(); ++i) {
      draft.joints.push_back(sdf_joint(draft, {i}));
      add_comments(draft.joints.back(), root_.joints[i].site);
    }
    add_gazebo_blocks(draft);
    add_control(draft, result_.files);
    tell_parts();
    assemble(draft);
    name_map(draft);
    result_.robot = std::move(draft.robot);
  }

  Remarks comments_on(const model::Site& site) const {
    return remarks_on(source_.documents, site, CommentsFor::kSdf);
  }

  /// On a link and the joint that carries it, which is no joint any more.
  Remarks comments_without_joint(const SdfNode& node, Id<model::Link> link) const {
    Remarks comments;
    if (node.carrier) comments = comments_on(root_[node.carrier].site);
    Remarks own = comments_on(root_[link].site);
    std::move(own.begin(), own.end(), std::back_inserter(comments));
    return comments;
  }

  void add_comments(std::vector<SdfPart>& joints, const model::Site& site) const {
    if (joints.empty()) return;
    if (auto* joint = std::get_if<SdfJoint>(&joints.front())) joint->comments = comments_on(site);
  }

  int version() const {
    if (options_.version != 0) return options_.version;
    const bool mimics =
        std::any_of(root_.joints.begin(), root_.joints.end(), [](const auto& joint) {
          return joint.type != model::JointType::kFixed && !joint.axes.empty() &&
                 joint.axes[0].mimic;
        });
    return mimics ? kMimicVersion : kPlainVersion;
  }

  /// As urdfdom takes them: the robot's own, else the first that a visual defines.
  void find_materials(SdfDraft& draft) {
    for (const model::RobotMaterial& material : root_.materials) {
      const xml::Element element = source_.documents.element(material.site);
      draft.materials.try_emplace(material.name.value, element);
    }
    for (const model::Visual& visual : root_.visuals) {
      if (!visual.material.defines_color || visual.material.name.value.empty()) continue;
      draft.materials.try_emplace(visual.material.name.value,
                                  source_.documents.element(visual.material.site));
    }
  }

  void tell_unused_materials(const SdfDraft& draft) {
    for (const model::RobotMaterial& material : root_.materials) {
      const xml::Element element = source_.documents.element(material.site);
      if (!draft.used_materials.contains(material.name.value)) {
        ledger_.pass_over(element, model::subject(root_, root_.models[0]),
                          "material " + material.name.value + ", which no visual uses");
        continue;
      }
      ledger_.take(material.site);
      ledger_.take(material.name);
      if (const auto color = element.child("color")) ledger_.take_all(*color);
    }
  }

  /// Parts of a robot that SDF has no place for, by what they say of themselves.
  void tell_parts() {
    const xml::Element robot = source_.documents.element(root_.models[0].site);
    for (const xml::Element child : robot.children()) {
      const NoteKind kind = urdf_kind_of(child);
      if (kind == NoteKind::kUnknown) continue;
      const bool control = kind == NoteKind::kTransmission || kind == NoteKind::kRos2Control;
      if (control && options_.control != ControlPolicy::kKeep) continue;
      const auto name = read::string_field(read::attribute_text(child, "name"));
      ledger_.lose(read::site_of(child), {.kind = kind,
                                          .where = child.name_span(),
                                          .subject = model::subject(root_, root_.models[0]),
                                          .written = name.value});
    }
    for (const model::Joint& joint : root_.joints) tell_safety(joint);
  }

  void tell_safety(const model::Joint& joint) {
    if (!joint.safety) return;
    const xml::Element element = source_.documents.element(joint.safety->site);
    std::string written;
    for (const xml::Attribute attribute : element.attributes()) {
      if (!written.empty()) written += ", ";
      written.append(attribute.name()).append(" ").append(attribute.value());
    }
    ledger_.lose(joint.safety->site, {.kind = NoteKind::kSafety,
                                      .where = element.name_span(),
                                      .subject = model::subject(root_, joint),
                                      .written = std::move(written)});
  }

  /// Each joint, the link that it carries, and what hangs on that.
  void assemble(SdfDraft& draft) {
    for (const Id<model::Link> id : draft.tree.order) {
      const SdfNode& node = draft.node(id);
      if (node.role == Role::kWorld) {
        take_world(root_[id]);
      } else if (node.role == Role::kFrame) {
        add_frames(draft, node, id);
      } else {
        add_link(draft, id);
      }
    }
  }

  void take_world(const model::Link& world) {
    ledger_.take_all(world.site, Outcome::kRewritten);
    ledger_.note({.kind = NoteKind::kWorldLink,
                  .outcome = Outcome::kRewritten,
                  .where = world.site.name,
                  .subject = model::subject(root_, world),
                  .written = world.name.value,
                  .instead = "the world"});
  }

  /// The link and the joint that fixes it, by their names, each with what was remarked on it.
  void add_frames(SdfDraft& draft, const SdfNode& node, Id<model::Link> link) const {
    auto& parts = draft.robot.parts;
    Remarks comments = comments_on(root_[link].site);
    // The root's frame is the model's, whatever link it is a frame of.
    if (!node.carrier) {
      parts.emplace_back(SdfFrame{
          node.name, draft.node(node.holder).name, {"__model__", {}}, std::move(comments)});
      return;
    }
    const std::string& joint = draft.tree.joint_names[node.carrier.value];
    parts.emplace_back(
        SdfFrame{joint,
                 draft.node(node.parent).name,
                 {{}, urdf_written_origin(source_.documents, root_[node.carrier].pose)},
                 comments_on(root_[node.carrier].site)});
    parts.emplace_back(SdfFrame{node.name, joint, {}, std::move(comments)});
  }

  /// A joint comes after the links that it names.
  void add_link(SdfDraft& draft, Id<model::Link> id) {
    const SdfNode& node = draft.node(id);
    SdfLink& link = *draft.links[id.value];
    auto& parts = draft.robot.parts;
    if (!node.carrier) {
      parts.emplace_back(std::move(link));
      return;
    }
    auto& row = draft.joints[node.carrier.value];
    const std::string joint = draft.tree.joint_names[node.carrier.value];
    if (row.empty()) {
      // Placed without a joint: the heir of a root that became its frame, or a free one.
      const SdfNode& parent = draft.node(node.parent);
      link.pose = {parent.role == Role::kWorld ? std::string() : parent.name,
                   urdf_written_origin(source_.documents, root_[node.carrier].pose)};
      link.comments = comments_without_joint(node, id);
      const std::string name = link.name;
      parts.emplace_back(std::move(link));
      if (node.carried_by_frame) parts.emplace_back(SdfFrame{joint, name});
      return;
    }
    link.pose.relative_to = std::get<SdfJoint>(row.back()).name;
    parts.emplace_back(std::move(link));
    std::stable_partition(row.begin(), row.end(), [](const SdfPart& part) {
      return std::holds_alternative<SdfLink>(part);
    });
    std::move(row.begin(), row.end(), std::back_inserter(parts));
  }

  void name_map(const SdfDraft& draft) {
    for (std::size_t i = 0; i < root_.links.size(); ++i) {
      const SdfNode& node = draft.tree.nodes[i];
      result_.links.try_emplace(root_.links[i].name.value, node.name);
      if (node.role != Role::kFrame) continue;
      result_.held_by.try_emplace(root_.links[i].name.value, root_[node.holder].name.value);
    }
    for (std::size_t i = 0; i < root_.joints.size(); ++i) {
      const std::string& name = draft.tree.joint_names[i];
      std::vector<std::string> names{name};
      if (root_.joints[i].type == model::JointType::kPlanar) {
        names = {name + "_slide", name + "_slide_2", name};
      }
      result_.joints.try_emplace(root_.joints[i].name.value, std::move(names));
    }
  }

  const Source& source_;
  const SdfOptions& options_;
  const model::Root& root_;
  Ledger ledger_;
  SdfConversion result_;
};

}  // namespace

SdfJoint* SdfDraft::joint(Id<model::Joint> id) {
  return joints[id.value].empty() ? nullptr : &std::get<SdfJoint>(joints[id.value].back());
}

SdfConversion urdf_to_sdf(const Source& source, const SdfOptions& options) {
  return UrdfToSdf(source, options).convert();
}

}  // namespace rigor::convert
