// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The steps of a change as a verb makes them: values set where the file has them, in the form that its author chose, and
// added where they are defaults. A number that does not change keeps its bytes.
//
//   Draft draft(edited);
//   draft.set_pose(joint.pose, draft.element(joint.site), X_PJ);
//   draft.set(axis.lower, 0.5 * axis.lower.value);
//   change.steps = draft.take();
//
// A default that has no place yet needs its element: where `set` has no text to change it does nothing, and the proof
// shows what is missing.

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/author/verbs/edited_model.h>
#include <rigor/mass/mass_properties.h>
#include <rigor/model/model.h>
#include <rigor/text/edit.h>
#include <rigor/xml/document.h>

namespace rigor::author {

/// Roll, pitch and yaw in rad of a unit quaternion: R = Rz(yaw) Ry(pitch) Rx(roll). As exact near a pitch of 90° as
/// elsewhere, since the roll is what is left when the yaw is undone.
model::Vector3 to_rpy(const model::Quaternion& q);

/// The `<pose>` of an element that the model does not know, as SDF reads one. `malformed` where it is none.
model::PoseField sdf_pose_in(xml::Element holder);

class Draft {
 public:
  explicit Draft(const EditedModel& edited) : edited_(edited) {}

  xml::Element element(const model::Site& site) const { return edited_.element(site); }

  /// Edits to be done together; none is none.
  void add(std::vector<Edit> step);

  /// The numbers that a value's bytes hold.
  void set(const model::Field<double>& field, double value);
  void set(const model::Field<model::Vector3>& field, const model::Vector3& value);

  /// Of a point in a plane, whose bytes hold two.
  void set_first_numbers(const model::Field<model::Vector3>& field,
                         const std::vector<double>& numbers);
  void set_attribute(xml::Element element, std::string_view name, std::string_view value);

  /// The direction of a joint's axis; of one that is not written, its element is added.
  void set_axis(const model::Joint& joint, const model::Axis& axis, const model::Vector3& xyz);

  /// X is in the frame that the pose is relative to, as it is or as `relative_to` says from now on (SDF; empty: the
  /// default one). A pose that is not written is added as the first child of `holder`, unless it is the identity. In a
  /// `<gazebo>` of URDF it is SDF's.
  void set_pose(const model::PoseField& field, xml::Element holder, const model::Pose& X,
                const std::optional<std::string>& relative_to = std::nullopt);

  /// A pose written in an element that the model does not know: `<pose>` of a plugin's or a sensor's.
  void set_pose_text(xml::Element pose, const model::Pose& X);

  void set_text(xml::Element element, std::string_view text);
  void remove(xml::Element element);
  /// As the last child, or behind `after`. `xml` as `xml::insert_child` takes it.
  void insert(xml::Element parent, std::optional<xml::Element> after, std::string_view xml);

  /// Why something could not be set: "line 7: the pose has 5 numbers". Empty when all could.
  const std::string& problem() const { return problem_; }

  std::vector<std::vector<Edit>> take() { return std::move(steps_); }

  /// The edits of another draft, for a copy of the text that they are in: they are no steps of this one, but what could
  /// not be set there is this one's problem.
  std::vector<Edit> edits_for_copy(Draft other);

 private:
  void refuse_pose(xml::Element pose);
  std::vector<Edit> numbers_at(Span span, const std::vector<double>& numbers) const;

  const EditedModel& edited_;
  std::vector<std::vector<Edit>> steps_;
  std::string problem_;
};

}  // namespace rigor::author
