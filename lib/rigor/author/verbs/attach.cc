// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/verbs/attach.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include <fmt/core.h>

#include <rigor/author/verbs/block.h>
#include <rigor/author/verbs/hardware_names.h>
#include <rigor/author/verbs/moved_paths.h>
#include <rigor/author/verbs/prefix.h>
#include <rigor/author/verbs/robot_laws.h>
#include <rigor/schema/value.h>
#include <rigor/text/path.h>
#include <rigor/xml/edit.h>
#include <rigor/xml/style.h>

namespace rigor::author {
namespace {

using model::Pose;

std::set<std::string> all_names(const robot::Robot& robot) {
  std::set<std::string> names;
  for (const robot::Body& body : robot.bodies) names.insert(body.name);
  for (const robot::Joint& joint : robot.joints) names.insert(joint.name);
  for (const robot::Frame& frame : robot.frames) names.insert(frame.name);
  return names;
}

std::vector<std::uint32_t> roots_of(const robot::Robot& robot) {
  std::vector<std::uint32_t> roots;
  for (std::uint32_t i = 0; i < robot.bodies.size(); ++i) {
    if (robot.bodies[i].carrier == robot::kNoIndex) roots.push_back(i);
  }
  return roots;
}

constexpr int kFirstWithNestedModels = 5;
constexpr int kFirstWithFrames = 7;
constexpr int kFirstWithPlacementFrame = 8;

class Attacher {
 public:
  Attacher(ModelReader& reader, const EditedModel& arm, const EditedModel& gripper,
           const AttachRequest& request)
      : reader_(reader), arm_(arm), gripper_(&gripper), request_(request) {}

  Change attach() {
    for (const auto step : {&Attacher::place, &Attacher::fault_of_parts, &Attacher::make_unique,
                            &Attacher::fault_of_inclusion}) {
      if (std::string fault = (this->*step)(); !fault.empty()) return refusal(std::move(fault));
    }
    const auto block = arm_.loaded.file->expanded ? template_block()
                       : arm_.is_urdf()           ? urdf_block()
                                                  : sdf_block();
    if (!block) return refusal("its file has no content to add to");
    Change change;
    change.steps.push_back({*block});
    if (!includes()) change.steps.push_back(declarations());
    change.expected = joined();
    change.notes = std::move(notes_);
    change.asks_for_setting = [](const robot::Difference& difference) {
      return difference.a.empty() || difference.kind == robot::DifferenceKind::kAttachmentOnlyInB;
    };
    return change;
  }

 private:
  /// Of a frame or link by its name, in the frame of the model.
  static std::optional<Pose> placed(const EditedModel& edited, const std::string& name) {
    auto X_WF = edited.frames.pose(edited.link(name));
    if (!X_WF && edited.frame(name)) X_WF = edited.frames.pose(edited.frame(name));
    const auto X_WM = edited.frames.pose(edited.model);
    if (!X_WF || !X_WM) return std::nullopt;
    return compose(inverse(*X_WM), *X_WF);
  }

  std::string link_of_frame() const {
    for (const robot::Frame& frame : arm_.robot.frames) {
      if (frame.name == request_.frame && frame.body != robot::kNoIndex)
        return arm_.robot.bodies[frame.body].name;
    }
    return request_.frame;
  }

  /// Finds link and pose.
  std::string place() {
    link_ = request_.link.empty() ? link_of_frame() : request_.link;
    base_ = request_.frame.empty() ? link_ : request_.frame;
    if (arm_.body_index(link_) == robot::kNoIndex || !arm_.link(link_))
      return fmt::format("no link is named '{}'", link_);
    const auto X_MB = placed(arm_, base_), X_ML = placed(arm_, link_);
    if (!X_MB) return fmt::format("no frame is named '{}'", base_);
    if (!X_ML) return fmt::format("nobody knows where '{}' is", link_);
    X_BG_ = request_.X_LG;
    if (!request_.tool_frame.empty()) {
      const auto X_GT = placed(*gripper_, request_.tool_frame);
      if (!X_GT) return fmt::format("{} has no frame '{}'", gripper_->path(), request_.tool_frame);
      X_BG_ = compose(X_BG_, inverse(*X_GT));
    }
    X_LG_ = base_ == link_ ? X_BG_ : compose(compose(inverse(*X_ML), *X_MB), X_BG_);
    return {};
  }

  bool is_template() const { return arm_.loaded.file->expanded != nullptr; }
  bool includes() const { return is_template() || request_.by == AttachBy::kInclude; }

  /// What is said of a copy is done to a copy only: another file keeps its names and paths.
  std::string fault_of_inclusion() {
    if (request_.by == AttachBy::kInclude && arm_.is_urdf() && !is_template())
      return "URDF has no <include>: without it, the gripper is copied";
    if (!is_template()) return {};
    if (own_) {
      return fmt::format("names of {} are taken, and a file that is included keeps them",
                         gripper_->path());
    }
    if (!paths_from_arm().empty())
      return fmt::format("meshes of {} have relative paths: use package://", gripper_->path());
    const std::set<std::string> of_arm = material_names(arm_);
    for (const model::RobotMaterial& each : gripper_->root().materials) {
      if (of_arm.contains(each.name.value))
        return fmt::format("material '{}' would be defined twice", each.name.value);
    }
    return {};
  }

  std::string fault_of_parts() {
    if (arm_.is_urdf() != gripper_->is_urdf())
      return "one is SDF and one URDF: convert one of them first";
    const int version = arm_.root()[arm_.model].version;
    const bool differ = gripper_->root()[gripper_->model].version != version;
    if (!arm_.is_urdf() && differ && !includes()) {
      return fmt::format("one is SDF 1.{} and one 1.{}: bring them to one version first", version,
                         gripper_->root()[gripper_->model].version);
    }
    if (!arm_.is_urdf() && version < kFirstWithNestedModels)
      return "SDF has nested models since 1.5: upgrade both first";
    for (const robot::Robot* robot : {&arm_.robot, &gripper_->robot}) {
      for (const robot::Joint& joint : robot->joints) {
        if (joint.closes_loop) return fmt::format("joint '{}' closes a loop", joint.name);
      }
    }
    const std::vector<std::uint32_t> roots = roots_of(gripper_->robot);
    if (roots.size() != 1) return fmt::format("{} has {} roots", gripper_->path(), roots.size());
    if (gripper_->robot.bodies[roots.front()].name == robot::kWorldBody)
      return gripper_->path() + " is fixed to the world: extract its base link first";
    if (!end_of_content(arm_.document(), holder())) return "it has no content";
    return {};
  }

  xml::Element holder() const { return arm_.element(arm_.root()[arm_.model].site); }

  /// Names that are taken, or asked to be, with a prefix. Nested models have names of their own.
  std::string make_unique() {
    joint_ = fmt::format("{}_to_{}", link_, gripper_->robot.name);
    std::replace(joint_.begin(), joint_.end(), ':', '_');
    const std::set<std::string> taken = all_names(arm_.robot);
    std::string prefix = request_.prefix;
    if (arm_.is_urdf()) {
      const std::set<std::string> own = all_names(gripper_->robot);
      const bool clash = std::any_of(own.begin(), own.end(),
                                     [&](const std::string& name) { return taken.contains(name); });
      if (clash && prefix.empty()) prefix = gripper_->robot.name + '_';
    } else {
      name_ = prefix + gripper_->robot.name;
      for (int i = 2; taken.contains(name_) || is_model(name_); ++i)
        name_ = fmt::format("{}{}_{}", prefix, gripper_->robot.name, i);
      prefix.clear();
    }
    for (int i = 2; taken.contains(joint_); ++i)
      joint_ = fmt::format("{}_to_{}_{}", link_, gripper_->robot.name, i);
    if (prefix.empty()) return {};
    prefix_ = prefix;
    ProvenChange renamed = prove(reader_, *gripper_, prefixed(*gripper_, prefix, {}));
    if (!renamed.refused.empty() || !renamed.after) return renamed.refused;
    own_ = std::move(renamed.after);
    gripper_ = own_.get();
    const std::set<std::string> own = all_names(gripper_->robot);
    for (const std::string& name : own) {
      if (taken.contains(name)) return fmt::format("'{}' is taken: choose another --prefix", name);
    }
    return {};
  }

  bool is_model(const std::string& name) const {
    return std::any_of(arm_.root().models.begin(), arm_.root().models.end(),
                       [&](const model::Model& model) {
                         return model.parent == arm_.model && model.name.value == name;
                       });
  }

  // --- Text ---

  std::string child_name() const {
    const std::string& root = gripper_->robot.bodies[roots_of(gripper_->robot).front()].name;
    return arm_.is_urdf() ? root : name_ + "::" + root;
  }

  /// Of the gripper's file in the folder of the arm's.
  std::vector<Edit> paths_from_arm() const {
    return moved_paths(gripper_->document(), gripper_->path(), parent_path(arm_.path()));
  }

  /// Of the prefixes in the copy, at the root of the arm's file.
  std::vector<Edit> declarations() {
    const xml::Element copied = gripper_->element(gripper_->root()[gripper_->model].site);
    const std::uint32_t begin = arm_.is_urdf() ? copied.tag_span().end : copied.span().begin;
    const auto used = namespaces_used(gripper_->document(), begin, copied.span().end);
    const xml::Element root = *arm_.document().root();
    for (std::string& note :
         namespace_conflicts(declared_namespaces(root), arm_.path(), used, gripper_->path()))
      notes_.push_back(std::move(note));
    return declared(arm_.document(), root, used);
  }

  /// Without the materials of the robot that the arm has already.
  void merge_materials(std::vector<Edit>& edits) {
    std::map<std::string, std::string> of_arm;
    const auto look_of = [](const EditedModel& edited, const model::RobotMaterial& material) {
      std::string look;
      for (const xml::Element child : edited.element(material.site).children()) {
        look += child.name();
        for (const xml::Attribute attribute : child.attributes()) look += attribute.value();
      }
      return look;
    };
    for (const model::RobotMaterial& each : arm_.root().materials)
      of_arm.emplace(each.name.value, look_of(arm_, each));
    std::map<std::string, const model::RobotMaterial*> of_gripper;
    for (const model::RobotMaterial& each : gripper_->root().materials)
      of_gripper.emplace(each.name.value, &each);
    const std::set<std::string> in_arm = material_names(arm_);
    for (const std::string& name : material_names(*gripper_)) {
      if (!in_arm.contains(name)) continue;
      const auto arm = of_arm.find(name);
      const auto gripper = of_gripper.find(name);
      // A name without a look, or with one in a visual alone, would take the other's.
      if (arm == of_arm.end() || gripper == of_gripper.end() ||
          arm->second != look_of(*gripper_, *gripper->second)) {
        rename_material(name, edits);
      } else {
        append(edits,
               xml::remove_element(gripper_->document(), gripper_->element(gripper->second->site)));
      }
    }
  }

  static std::set<std::string> material_names(const EditedModel& edited) {
    std::set<std::string> names;
    for (std::uint32_t i = 0; i < edited.document().element_count(); ++i) {
      const xml::Element element = edited.document().element(i);
      const auto attribute = element.attribute("name");
      if (element.name() == "material" && attribute && !attribute->value().empty())
        names.emplace(attribute->value());
    }
    return names;
  }

  void rename_material(const std::string& name, std::vector<Edit>& edits) const {
    for (std::uint32_t i = 0; i < gripper_->document().element_count(); ++i) {
      const xml::Element element = gripper_->document().element(i);
      const auto attribute = element.attribute("name");
      if (element.name() != "material" || !attribute || attribute->value() != name) continue;
      edits.push_back({attribute->value_span(), gripper_->robot.name + '_' + name});
    }
  }

  /// The joint, whole lines with the arm's indentation.
  std::string urdf_joint() const {
    const std::string unit = xml::indent_unit(arm_.document(), *arm_.document().root());
    const std::string in = child_indentation(arm_.document(), holder());
    const std::string line(xml::line_end(arm_.document(), 0));
    std::string text = fmt::format("{}<joint name=\"{}\" type=\"{}\">{}", in, joint_,
                                   is_fixed() ? "fixed" : "revolute", line);
    const auto add = [&](const std::string& xml) { text += in + unit + xml + line; };
    add(fmt::format("<origin xyz=\"{}\" rpy=\"{}\"/>", xyz_text(X_LG_), rpy_text(X_LG_)));
    add(fmt::format("<parent link=\"{}\"/>", link_));
    add(fmt::format("<child link=\"{}\"/>", child_name()));
    if (!is_fixed()) {
      add("<axis xyz=\"0 0 1\"/>");
      add(fmt::format("<limit lower=\"{}\" upper=\"{}\" effort=\"{}\" velocity=\"{}\"/>",
                      schema::to_shortest(request_.lower), schema::to_shortest(request_.upper),
                      schema::to_shortest(request_.effort),
                      schema::to_shortest(request_.velocity)));
    }
    return text + in + "</joint>" + line;
  }

  /// In the template's own file.
  std::optional<Edit> template_block() const {
    const std::string path = relative_path(parent_path(arm_.path()), gripper_->path());
    const std::string in = child_indentation(arm_.document(), holder());
    const std::string line(xml::line_end(arm_.document(), 0));
    return block_in_template(arm_, trimmed_lines(fmt::format("{}<xacro:include filename=\"{}\"/>{}",
                                                             in, xml::escaped(path), line) +
                                                 urdf_joint()));
  }

  std::optional<Edit> urdf_block() {
    std::vector<Edit> edits = paths_from_arm();
    merge_materials(edits);
    append(edits, renamed_hardware(arm_, *gripper_, {prefix_, gripper_->robot.name + '_'}, notes_));
    const xml::Element root = gripper_->element(gripper_->root()[gripper_->model].site);
    const auto end = end_of_content(gripper_->document(), root);
    const std::uint32_t begin = root.tag_span().end;
    std::string text = urdf_joint();
    if (end) text += trimmed_lines(part_after(gripper_->document(), begin, *end, std::move(edits)));
    return block_at_end(arm_.document(), holder(), std::move(text));
  }

  /// The URI that leads to the gripper's file from the arm's.
  std::string include_uri() {
    const std::string folder(parent_path(gripper_->path()));
    const std::string uri = "model://" + std::string(file_name(normalize_path(folder)));
    const read::Resolver& resolver = arm_.environment.resolver;
    const auto found = resolver.resolve(uri, arm_.path()).path;
    const bool has_config =
        resolver.disk().kind(join_path(folder, "model.config")) == PathKind::kFile;
    if (has_config && found && normalize_path(*found) == normalize_path(folder)) return uri;
    notes_.push_back(
        fmt::format("{} is included by its path: in a model's folder with a "
                    "model.config it would have a model:// URI",
                    gripper_->path()));
    return relative_path(parent_path(arm_.path()), gripper_->path());
  }

  /// Where it is, in the arm's words: `<pose relative_to="tool0">…</pose>`.
  std::string pose_element(const Pose& X_BG) const {
    if (arm_.root()[arm_.model].version >= kFirstWithFrames) {
      return fmt::format("<pose relative_to=\"{}\">{} {}</pose>", base_, xyz_text(X_BG),
                         rpy_text(X_BG));
    }
    const Pose X_MG = compose(*placed(arm_, base_), X_BG);
    return fmt::format("<pose>{} {}</pose>", xyz_text(X_MG), rpy_text(X_MG));
  }

  std::string included_model() {
    const std::string unit = xml::indent_unit(arm_.document(), *arm_.document().root());
    const std::string in = child_indentation(arm_.document(), holder());
    const std::string line(xml::line_end(arm_.document(), 0));
    std::string text = in + "<include>" + line;
    const auto add = [&](const std::string& xml) { text += in + unit + xml + line; };
    add("<uri>" + xml::escaped(include_uri()) + "</uri>");
    add("<name>" + xml::escaped(name_) + "</name>");
    const bool by_frame =
        !request_.tool_frame.empty() && arm_.root()[arm_.model].version >= kFirstWithPlacementFrame;
    add(pose_element(by_frame ? request_.X_LG : X_BG_));
    if (by_frame)
      add("<placement_frame>" + xml::escaped(request_.tool_frame) + "</placement_frame>");
    return text + in + "</include>" + line;
  }

  std::string copied_model() {
    const model::Model& model = gripper_->root()[gripper_->model];
    const xml::Element element = gripper_->element(model.site);
    std::vector<Edit> edits = paths_from_arm();
    append(edits, xml::set_attribute(gripper_->document(), element, "name", name_));
    if (const auto pose = element.child("pose"))
      append(edits, xml::remove_element(gripper_->document(), *pose));
    const std::string in = child_indentation(arm_.document(), holder());
    const std::string line(xml::line_end(arm_.document(), 0));
    const std::string unit = xml::indent_unit(arm_.document(), *arm_.document().root());
    const std::uint32_t tag_end = element.tag_span().end;
    edits.push_back({{gripper_->document().source(), tag_end, tag_end},
                     line + in + unit + pose_element(X_BG_)});
    return in +
           part_after(gripper_->document(), element.span().begin, element.span().end,
                      std::move(edits)) +
           line;
  }

  std::optional<Edit> sdf_block() {
    const bool frames = arm_.root()[arm_.model].version >= kFirstWithFrames;
    const std::string in = child_indentation(arm_.document(), holder());
    const std::string line(xml::line_end(arm_.document(), 0));
    const std::string unit = xml::indent_unit(arm_.document(), *arm_.document().root());
    std::string text = includes() ? included_model() : copied_model();
    text += fmt::format("{}<joint name=\"{}\" type=\"{}\">{}", in, joint_,
                        is_fixed() ? "fixed" : "revolute", line);
    const auto add = [&](const std::string& xml) { text += in + unit + xml + line; };
    add(fmt::format("<parent>{}</parent>", link_));
    add(fmt::format("<child>{}</child>", child_name()));
    if (!is_fixed()) {
      add(fmt::format(
          "<axis><xyz{}>0 0 1</xyz><limit><lower>{}</lower><upper>{}</upper>"
          "<effort>{}</effort><velocity>{}</velocity></limit></axis>",
          frames ? fmt::format(" expressed_in=\"{}\"", name_) : std::string(),
          schema::to_shortest(request_.lower), schema::to_shortest(request_.upper),
          schema::to_shortest(request_.effort), schema::to_shortest(request_.velocity)));
    }
    return block_at_end(arm_.document(), holder(), text + in + "</joint>");
  }

  bool is_fixed() const { return request_.joint == AttachJoint::kFixed; }

  // --- The law ---

  robot::Robot joined() const {
    robot::Robot all = arm_.robot;
    robot::Robot part = gripper_->robot;
    const std::uint32_t root = roots_of(part).front();
    const Pose X_GR = root_in_model(part.bodies[root]);
    // The root hangs on a joint now, whose frame is the link's.
    describe_in(part, root, compose(inverse(part.bodies[root].X_MB), X_GR));
    robot::connect(part);
    if (!arm_.is_urdf()) scope_names(part);
    if (!includes()) move_paths(part, *gripper_, parent_path(arm_.path()));
    const auto offset = static_cast<std::uint32_t>(all.bodies.size());
    robot::Joint joint;
    joint.name = joint_;
    joint.type = is_fixed() ? model::JointType::kFixed : model::JointType::kRevolute;
    joint.parent = arm_.body_index(link_);
    joint.child = offset + root;
    const Pose X_ML =
        compose(inverse(*arm_.frames.pose(arm_.model)), *arm_.frames.pose(arm_.link(link_)));
    const Pose X_BL = compose(inverse(all.bodies[joint.parent].X_MB), X_ML);
    joint.X_PJ = compose(X_BL, compose(X_LG_, X_GR));
    if (!is_fixed()) joint.axes.push_back(axis(X_GR));
    for (robot::Body& body : part.bodies) all.bodies.push_back(std::move(body));
    for (robot::Joint& each : part.joints) {
      each.parent += offset;
      each.child += offset;
      all.joints.push_back(std::move(each));
    }
    all.joints.push_back(std::move(joint));
    for (robot::Frame& frame : part.frames) {
      frame.body += offset;
      all.frames.push_back(std::move(frame));
    }
    robot::connect(all);
    return all;
  }

  /// Of the root link in the gripper's model.
  Pose root_in_model(const robot::Body& root) const {
    return compose(inverse(*gripper_->frames.pose(gripper_->model)),
                   *gripper_->frames.pose(gripper_->link(root.name)));
  }

  robot::Axis axis(const Pose& X_GR) const {
    robot::Axis axis;
    axis.direction = rotate(conjugate(X_GR.rotation), {0, 0, 1});
    axis.lower = request_.lower;
    axis.upper = request_.upper;
    axis.effort = request_.effort;
    axis.velocity = request_.velocity;
    return axis;
  }

  void scope_names(robot::Robot& part) const {
    const auto scope = [this](std::string& name) { name = name_ + "::" + name; };
    for (robot::Body& body : part.bodies) scope(body.name);
    for (robot::Joint& joint : part.joints) {
      scope(joint.name);
      for (robot::Axis& each : joint.axes) {
        if (each.follow) scope(each.follow->joint);
      }
    }
    for (robot::Frame& frame : part.frames) scope(frame.name);
  }

  ModelReader& reader_;
  const EditedModel& arm_;
  const EditedModel* gripper_;
  std::unique_ptr<EditedModel> own_;  ///< the gripper with a prefix
  const AttachRequest& request_;
  std::string link_;    ///< of the arm
  std::string base_;    ///< a frame or link of the arm
  Pose X_BG_;           ///< of the gripper in that
  Pose X_LG_;           ///< in the link
  std::string prefix_;  ///< of the names of the gripper's copy
  std::string joint_;   ///< the new joint's name
  std::string name_;    ///< of the nested model, in SDF
  std::vector<std::string> notes_;
};

}  // namespace

Change attached(ModelReader& reader, const EditedModel& arm, const EditedModel& gripper,
                const AttachRequest& request) {
  return Attacher(reader, arm, gripper, request).attach();
}

}  // namespace rigor::author
