// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The numbers of a pose as they stand in the file, before they are converted or normalized.

#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <rigor/model/model.h>
#include <rigor/rules/rule.h>
#include <rigor/schema/value.h>

namespace rigor::rules {

/// How the attributes of a pose say that its rotation is written.
struct RotationFormat {
  bool declared = false;  ///< `rotation_format` is there
  bool quaternion = false;
  bool degrees = false;
  Span degrees_span;
};

/// All false when the pose is not one of the file itself.
inline RotationFormat rotation_format(const model::PoseField& pose, const Context& context) {
  RotationFormat result;
  if (pose.site.span.nowhere() || !context.root().own(pose.site)) return result;
  const xml::Element element = context.element(pose.site);
  if (const auto format = element.attribute("rotation_format")) {
    result.declared = true;
    result.quaternion = format->value() == "quat_xyzw";
  }
  if (const auto unit = element.attribute("degrees")) {
    result.degrees = unit->value() == "true" || unit->value() == "1";
    result.degrees_span = unit->value_span();
  }
  return result;
}

/// The rotation of a pose: three angles, or a quaternion x y z w.
struct WrittenRotation {
  std::vector<double> numbers;
  bool degrees = false;
  Span span;             ///< of the value that holds the numbers
  bool verbatim = true;  ///< whether that value is the file's own bytes
};

/// Nothing when none is written, or when it is not a pose.
inline std::optional<WrittenRotation> written_rotation(const model::PoseField& pose,
                                                       const Context& context) {
  if (pose.site.span.nowhere() || !context.root().own(pose.site)) return std::nullopt;
  const xml::Element element = context.element(pose.site);
  if (const auto rpy = element.attribute("rpy")) {
    const auto parsed = schema::parse_vector3(rpy->value());
    const auto* angles = std::get_if<std::array<double, 3>>(&parsed);
    if (angles == nullptr) return std::nullopt;
    return WrittenRotation{{angles->begin(), angles->end()}, false, rpy->value_span()};
  }
  const auto old = element.attribute("pose");  // SDF 1.0: <origin pose="…"/>
  if (element.name() == "origin" && !old) return std::nullopt;
  const RotationFormat format = rotation_format(pose, context);
  const auto parsed = schema::parse_pose(
      old ? old->value() : element.text(),
      format.quaternion ? schema::RotationFormat::kQuatXyzw : schema::RotationFormat::kEulerRpy);
  const auto* numbers = std::get_if<schema::PoseNumbers>(&parsed);
  if (numbers == nullptr || numbers->count < 6) return std::nullopt;
  return WrittenRotation{{numbers->numbers.begin() + 3, numbers->numbers.begin() + numbers->count},
                         format.degrees,
                         old ? old->value_span() : element.text_span(),
                         element.text_verbatim()};
}

/// A check of the pose of whatever can have one; the subject is added for it.
using PoseCheck = std::optional<Finding> (*)(const model::PoseField& pose, const Context&);

template <PoseCheck check, class Entity>
void check_pose_of(const Entity& entity, Context& context) {
  if (auto finding = check(entity.pose, context)) {
    finding->subject = context.subject(entity);
    context.report(std::move(*finding));
  }
}

template <PoseCheck check>
std::vector<Check> on_poses() {
  return {on<model::Model>(check_pose_of<check, model::Model>),
          on<model::Link>([](const model::Link& link, Context& context) {
            check_pose_of<check>(link, context);
            if (auto finding = check(link.inertial.pose, context)) {
              finding->subject = context.subject(link);
              context.report(std::move(*finding));
            }
          }),
          on<model::Joint>(check_pose_of<check, model::Joint>),
          on<model::Frame>(check_pose_of<check, model::Frame>),
          on<model::Collision>(check_pose_of<check, model::Collision>),
          on<model::Visual>(check_pose_of<check, model::Visual>),
          on<model::Sensor>(check_pose_of<check, model::Sensor>),
          on<model::Light>(check_pose_of<check, model::Light>),
          on<model::Include>([](const model::Include& include, Context& context) {
            if (auto finding = check(include.pose, context)) context.report(std::move(*finding));
          })};
}

}  // namespace rigor::rules
