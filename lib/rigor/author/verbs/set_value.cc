// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/verbs/set_value.h>

#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <rigor/author/verbs/draft.h>
#include <rigor/schema/value.h>
#include <rigor/xml/edit.h>

namespace rigor::author {
namespace {

using model::Id;

/// What has a pose by that name: its field, in the root and in a copy of it.
struct NamedPose {
  const model::PoseField* field = nullptr;
  model::PoseField* copy = nullptr;
  const model::Site* site = nullptr;
};

NamedPose named_pose(const EditedModel& edited, model::Root& copy, std::string_view name) {
  const model::Root& root = edited.root();
  Id<model::Joint> joint = edited.joint(name);
  const Id<model::Link> link = edited.link(name);
  if (link && !edited.is_urdf()) {
    return {&root[link].pose, &copy.links[link.value].pose, &root[link].site};
  }
  if (link && !joint) {
    const std::uint32_t carrier = edited.robot.bodies[edited.body_index(name)].carrier;
    if (carrier != robot::kNoIndex) joint = edited.joint(edited.robot.joints[carrier].name);
  }
  if (joint) return {&root[joint].pose, &copy.joints[joint.value].pose, &root[joint].site};
  if (const Id<model::Frame> frame = edited.frame(name))
    return {&root[frame].pose, &copy.frames[frame.value].pose, &root[frame].site};
  const model::Model& model = root[edited.model];
  if (model.name.value == name && !edited.is_urdf())
    return {&model.pose, &copy.models[edited.model.value].pose, &model.site};
  return {};
}

std::string element_of(std::string_view name, double value) {
  return fmt::format("<{0}>{1}</{0}>", name, schema::to_shortest(value));
}

bool has_limits(model::JointType type) {
  using model::JointType;
  return type == JointType::kRevolute || type == JointType::kContinuous ||
         type == JointType::kPrismatic || type == JointType::kUniversal ||
         type == JointType::kRevolute2 || type == JointType::kScrew || type == JointType::kGearbox;
}

/// Whether a URDF's `<limit>` would have it.
bool would_have(const std::optional<double>& asked, const model::Field<double>& written) {
  return asked.has_value() || written.written;
}

/// urdfdom rejects a `<limit>` without effort or velocity.
std::string missing_in_urdf(const model::Axis& axis, const NewLimits& limits) {
  const bool effort = would_have(limits.effort, axis.effort);
  const bool velocity = would_have(limits.velocity, axis.velocity);
  if (effort && velocity) return {};
  return effort ? "--velocity" : velocity ? "--effort" : "--effort and --velocity";
}

/// Why the limits cannot be those of the joint; empty when they can.
std::string fault_of_limits(const EditedModel& edited, const model::Joint& joint,
                            const NewLimits& limits) {
  const std::string& name = joint.name.value;
  if (joint.axes.empty() || !has_limits(joint.type))
    return fmt::format("joint '{}' is {}, and has no limits", name, to_string(joint.type));
  if (limits.effort.value_or(0) < 0 || limits.velocity.value_or(0) < 0)
    return "a limit of effort or velocity is not below 0";
  const bool moves_bounds = limits.lower || limits.upper;
  if (joint.type == model::JointType::kContinuous && moves_bounds)
    return fmt::format("joint '{}' is continuous: it has no lower or upper limit", name);
  const model::Axis& axis = joint.axes.front();
  const double lower = limits.lower.value_or(axis.lower.value);
  const double upper = limits.upper.value_or(axis.upper.value);
  if (moves_bounds && lower > upper)
    return fmt::format("the lower limit {} of joint '{}' would exceed the upper limit {}: give {}",
                       lower, name, upper, limits.lower ? "--upper, too" : "--lower, too");
  if (!edited.is_urdf()) return {};
  if (const std::string missing = missing_in_urdf(axis, limits); !missing.empty())
    return fmt::format("the <limit> of joint '{}' needs effort and velocity: give {}, too", name,
                       missing);
  return {};
}

struct NewLimit {
  std::string_view name;
  const std::optional<double>& value;
  model::Field<double> model::Axis::*field;
};

}  // namespace

Change with_pose(const EditedModel& edited, std::string_view name, const model::Pose& X) {
  model::Root copy = edited.root();
  const NamedPose named = named_pose(edited, copy, name);
  if (named.field == nullptr)
    return refusal(fmt::format("nothing that has a pose is named '{}'", name));
  if (!edited.root().own(*named.site))
    return refusal(fmt::format("'{}' is in a file that is included", name));
  Draft draft(edited);
  draft.set_pose(*named.field, edited.element(*named.site), X);
  named.copy->pose.value = X;
  Change change;
  change.refused = draft.problem();
  change.steps = draft.take();
  change.expected = edited.robot_with(copy);
  return change;
}

Change with_limits(const EditedModel& edited, std::string_view joint, const NewLimits& limits) {
  const Id<model::Joint> id = edited.joint(joint);
  if (!id) return refusal(fmt::format("no joint is named '{}'", joint));
  const model::Joint& written = edited.root()[id];
  if (!edited.root().own(written.site))
    return refusal(fmt::format("'{}' is in a file that is included", joint));
  if (std::string fault = fault_of_limits(edited, written, limits); !fault.empty())
    return refusal(std::move(fault));
  const model::Axis& axis = written.axes.front();
  model::Root copy = edited.root();
  Draft draft(edited);
  std::string missing;
  std::vector<xml::NamedValue> attributes;
  for (const NewLimit& each : {NewLimit{"lower", limits.lower, &model::Axis::lower},
                               NewLimit{"upper", limits.upper, &model::Axis::upper},
                               NewLimit{"effort", limits.effort, &model::Axis::effort},
                               NewLimit{"velocity", limits.velocity, &model::Axis::velocity}}) {
    if (!each.value) continue;
    model::Field<double>& changed = copy.joints[id.value].axes.front().*each.field;
    changed.value = *each.value;
    changed.written = true;
    if ((axis.*each.field).written) {
      draft.set(axis.*each.field, *each.value);
    } else {
      attributes.push_back({each.name, schema::to_shortest(*each.value)});
      missing += (missing.empty() ? "" : "\n") + element_of(each.name, *each.value);
    }
  }
  const xml::Element element = edited.element(written.site);
  if (!attributes.empty() && edited.is_urdf()) {
    if (const auto limit = element.child("limit")) {
      draft.add(xml::set_attributes(edited.document(), *limit, attributes));
    } else {
      std::string text = "<limit";
      for (const xml::NamedValue& each : attributes)
        text += fmt::format(" {}=\"{}\"", each.name, each.value);
      draft.insert(element, element.child("axis") ? element.child("axis") : element.child("child"),
                   text + "/>");
    }
  } else if (!missing.empty()) {
    const xml::Element holder = edited.element(axis.site);
    if (const auto limit = holder.child("limit")) {
      draft.insert(*limit, std::nullopt, missing);
    } else {
      for (std::size_t at = 0; (at = missing.find('\n', at)) != std::string::npos; at += 3)
        missing.insert(at + 1, "  ");
      draft.insert(holder, holder.child("xyz"), "<limit>\n  " + missing + "\n</limit>");
    }
  }
  Change change;
  change.steps = draft.take();
  change.expected = edited.robot_with(copy);
  return change;
}

}  // namespace rigor::author
