// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/verbs/draft.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/core.h>

#include <rigor/read/values.h>
#include <rigor/schema/value.h>
#include <rigor/write/numbers.h>
#include <rigor/write/write_pose.h>
#include <rigor/xml/edit.h>

namespace rigor::author {
namespace {

using model::Pose;
using model::Quaternion;
using model::Vector3;
using xml::Element;

/// Two rotations this near are one, as quaternions' components: some roundings of a product.
constexpr double kSameRotation = 1e-15;

bool same_rotation(const Quaternion& a, const Quaternion& b) {
  const double sign = a.w * b.w + a.x * b.x + a.y * b.y + a.z * b.z < 0 ? -1 : 1;
  return std::abs(a.w - sign * b.w) <= kSameRotation &&
         std::abs(a.x - sign * b.x) <= kSameRotation &&
         std::abs(a.y - sign * b.y) <= kSameRotation && std::abs(a.z - sign * b.z) <= kSameRotation;
}

std::vector<double> quaternion_numbers(const Quaternion& q) {
  const auto number = [](double value) { return write::settled(value, 0, 0.5); };
  return {number(q.x), number(q.y), number(q.z), number(q.w)};
}

std::vector<double> angle_numbers(const Quaternion& q, double unit) {
  const Vector3 rpy = to_rpy(q);
  const double size = std::numbers::pi * unit;
  return {write::settled(rpy.x * unit, 0, size), write::settled(rpy.y * unit, 0, size),
          write::settled(rpy.z * unit, 0, size)};
}

std::vector<double> translation_numbers(const Vector3& to, const Vector3& from) {
  const double size = std::max(length(to), length(from));
  return {write::settled(to.x, from.x, size), write::settled(to.y, from.y, size),
          write::settled(to.z, from.z, size)};
}

constexpr double kDegrees = 180 / std::numbers::pi;

/// What stands in a `<pose>`, and in which words.
struct WrittenPose {
  bool quaternion = false, degrees = false;
  std::vector<double> numbers;  ///< six or seven; of an empty one the identity's
};

std::optional<WrittenPose> written_pose(Element pose, std::string_view text) {
  WrittenPose written;
  const auto format = read::attribute_text(pose, "rotation_format");
  written.quaternion = format && read::trimmed(format->text) == "quat_xyzw";
  written.degrees = bool_field(read::attribute_text(pose, "degrees"), false).value;
  const std::size_t count = written.quaternion ? 7 : 6;
  if (read::trimmed(text).empty()) {
    written.numbers.assign(count, 0);
    if (written.quaternion) written.numbers.back() = 1;
    return written;
  }
  const auto numbers = write::numbers_in(text);
  if (!numbers || numbers->size() != count) return std::nullopt;
  written.numbers = *numbers;
  return written;
}

Pose pose_of(const WrittenPose& written) {
  const std::vector<double>& n = written.numbers;
  const double unit = written.degrees ? 1 / kDegrees : 1;
  return {{n[0], n[1], n[2]},
          written.quaternion ? normalized(Quaternion{n[6], n[3], n[4], n[5]})
                             : model::from_rpy(n[3] * unit, n[4] * unit, n[5] * unit)};
}

std::vector<double> with_pose(const WrittenPose& written, const Pose& X) {
  const Pose old = pose_of(written);
  std::vector<double> numbers = translation_numbers(X.translation, old.translation);
  const auto rotation =
      same_rotation(X.rotation, old.rotation)
          ? std::vector<double>(written.numbers.begin() + 3, written.numbers.end())
      : written.quaternion ? quaternion_numbers(X.rotation)
                           : angle_numbers(X.rotation, written.degrees ? kDegrees : 1);
  numbers.insert(numbers.end(), rotation.begin(), rotation.end());
  return numbers;
}

/// What is in a `<gazebo>` of a URDF is SDF.
write::PoseForm pose_form_of(const EditedModel& edited, Element holder) {
  const write::PoseForm form = write::pose_form(edited.root()[edited.model]);
  if (form != write::PoseForm::kUrdf) return form;
  for (std::optional<Element> at = holder; at; at = at->parent()) {
    if (at->name() == "gazebo") return write::PoseForm::kPose;
  }
  return form;
}

std::string new_pose(write::PoseForm form, const Pose& X, const std::string& attributes) {
  const std::string xyz = write::joined(translation_numbers(X.translation, {}));
  const std::string rpy = write::joined(angle_numbers(X.rotation, 1));
  switch (form) {
    case write::PoseForm::kPose: return "<pose" + attributes + '>' + xyz + ' ' + rpy + "</pose>";
    case write::PoseForm::kOldOrigin: return "<origin pose=\"" + xyz + ' ' + rpy + "\"/>";
    case write::PoseForm::kUrdf: break;
  }
  return "<origin xyz=\"" + xyz + "\" rpy=\"" + rpy + "\"/>";
}

}  // namespace

Vector3 to_rpy(const Quaternion& q) {
  const model::Matrix3 R = to_matrix(q);
  const double yaw = std::atan2(R[1][0], R[0][0]);
  const double pitch = std::atan2(-R[2][0], std::hypot(R[0][0], R[1][0]));
  const double s = std::sin(yaw), c = std::cos(yaw);
  return {std::atan2(s * R[0][2] - c * R[1][2], c * R[1][1] - s * R[0][1]), pitch, yaw};
}

model::PoseField sdf_pose_in(Element holder) {
  model::PoseField field;
  const auto pose = holder.child("pose");
  if (!pose) return field;
  field.site = read::site_of(*pose);
  field.relative_to = read::string_field(read::attribute_text(*pose, "relative_to"));
  if (!field.relative_to.written)
    field.relative_to = read::string_field(read::attribute_text(*pose, "frame"));
  const auto written = written_pose(*pose, pose->text());
  field.malformed = !written;
  if (written) field.pose = {pose_of(*written), pose->text_span(), true};
  return field;
}

void Draft::add(std::vector<Edit> step) {
  if (!step.empty()) steps_.push_back(std::move(step));
}

std::vector<Edit> Draft::numbers_at(Span span, const std::vector<double>& numbers) const {
  std::vector<Edit> edits;
  const std::string_view text = edited_.sources.bytes(span);
  std::size_t at = text.find_first_not_of(write::kSpace);
  for (const double number : numbers) {
    if (at == std::string_view::npos) return {};
    const std::size_t end = std::min(text.find_first_of(write::kSpace, at), text.size());
    if (write::number_in(text.substr(at, end - at)) != number) {
      edits.push_back({{span.source, span.begin + static_cast<std::uint32_t>(at),
                        span.begin + static_cast<std::uint32_t>(end)},
                       schema::to_shortest(number)});
    }
    at = text.find_first_not_of(write::kSpace, end);
  }
  return edits;
}

void Draft::set(const model::Field<double>& field, double value) {
  if (field.written && !field.span.nowhere()) add(numbers_at(field.span, {value}));
}

void Draft::set(const model::Field<Vector3>& field, const Vector3& value) {
  if (field.written && !field.span.nowhere())
    add(numbers_at(field.span, {value.x, value.y, value.z}));
}

void Draft::set_first_numbers(const model::Field<Vector3>& field,
                              const std::vector<double>& numbers) {
  if (field.written && !field.span.nowhere()) add(numbers_at(field.span, numbers));
}

void Draft::set_attribute(Element element, std::string_view name, std::string_view value) {
  add(xml::set_attribute(edited_.document(), element, name, value));
}

void Draft::set_axis(const model::Joint& joint, const model::Axis& axis, const Vector3& xyz) {
  const Vector3& old = axis.xyz.value;
  const double size = length(xyz);
  const Vector3 positive{write::settled(xyz.x, old.x, size) + 0.0,  // no -0
                         write::settled(xyz.y, old.y, size) + 0.0,
                         write::settled(xyz.z, old.z, size) + 0.0};
  if (axis.xyz.written) return set(axis.xyz, positive);
  if (positive == axis.xyz.value) return;
  const std::string numbers = write::joined({positive.x, positive.y, positive.z});
  const Element element = edited_.element(joint.site);
  if (edited_.is_urdf()) {
    insert(element, element.child("child"), "<axis xyz=\"" + numbers + "\"/>");
  } else {
    insert(edited_.element(axis.site), std::nullopt, "<xyz>" + numbers + "</xyz>");
  }
}

void Draft::refuse_pose(Element pose) {
  const Span where = pose.tag_span();
  problem_ = fmt::format("line {}: the pose is not written as one",
                         edited_.sources.position(where.source, where.begin).line);
}

void Draft::set_pose_text(Element pose, const Pose& X) {
  const auto written = written_pose(pose, pose.text());
  if (!written) return refuse_pose(pose);
  add(write::set_numbers(edited_.document(), pose, with_pose(*written, X)));
}

void Draft::set_pose(const model::PoseField& field, Element holder, const Pose& X,
                     const std::optional<std::string>& relative_to) {
  const xml::Document& document = edited_.document();
  const write::PoseForm form = pose_form_of(edited_, holder);
  const char* const name = form == write::PoseForm::kPose ? "pose" : "origin";
  const auto pose = holder.child(name);
  const std::string_view frame =
      edited_.root()[edited_.model].version >= 7 ? "relative_to" : "frame";
  if (!pose) {
    const std::string attributes =
        relative_to && !relative_to->empty()
            ? ' ' + std::string(frame) + "=\"" + xml::escaped(*relative_to) + '"'
            : std::string();
    if (X == Pose{} && attributes.empty()) return;
    return add(xml::insert_child(document, holder, std::nullopt, new_pose(form, X, attributes)));
  }
  if (form == write::PoseForm::kUrdf) {
    if (field.malformed) return refuse_pose(*pose);
    const Pose& old = field.pose.value;
    const bool turned = !same_rotation(X.rotation, old.rotation);
    const std::vector<double> xyz = translation_numbers(X.translation, old.translation);
    std::vector<xml::NamedValue> missing;
    const auto set = [&](std::string_view attribute, const std::vector<double>& numbers) {
      if (pose->attribute(attribute)) {
        add(write::set_numbers(document, *pose, attribute, numbers));
      } else {
        missing.push_back({attribute, write::joined(numbers)});
      }
    };
    if (pose->attribute("xyz") || !(X.translation == Vector3{})) set("xyz", xyz);
    if (turned && pose->attribute("quat_xyzw")) {
      set("quat_xyzw", quaternion_numbers(X.rotation));
    } else if (turned) {
      set("rpy", angle_numbers(X.rotation, 1));
    }
    return add(xml::set_attributes(document, *pose, missing));
  }
  if (form == write::PoseForm::kOldOrigin) {
    const auto text = read::attribute_text(*pose, "pose");
    const auto written = written_pose(*pose, text ? text->text : std::string_view());
    if (!written) return refuse_pose(*pose);
    return add(write::set_numbers(document, *pose, "pose", with_pose(*written, X)));
  }
  set_pose_text(*pose, X);
  if (!relative_to) return;
  const auto attribute = pose->attribute(frame);
  if (!relative_to->empty()) {
    add(xml::set_attribute(document, *pose, frame, *relative_to));
  } else if (attribute) {
    add(xml::remove_attribute(document, *attribute));
  }
}

std::vector<Edit> Draft::edits_for_copy(Draft other) {
  if (problem_.empty()) problem_ = std::move(other.problem_);
  std::vector<Edit> edits;
  for (const std::vector<Edit>& step : other.steps_) append(edits, step);
  return edits;
}

void Draft::set_text(Element element, std::string_view text) {
  add(xml::set_text(edited_.document(), element, text));
}

void Draft::remove(Element element) { add(xml::remove_element(edited_.document(), element)); }

void Draft::insert(Element parent, std::optional<Element> after, std::string_view xml) {
  add(xml::insert_child(edited_.document(), parent, after, xml));
}

}  // namespace rigor::author
