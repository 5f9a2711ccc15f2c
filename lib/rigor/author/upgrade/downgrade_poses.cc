// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/author/upgrade/downgrading.h>
#include <rigor/author/verbs/block.h>
#include <rigor/xml/edit.h>

namespace rigor::author {
namespace {

using model::Id;
using model::Pose;

class PoseDowngrader {
 public:
  explicit PoseDowngrader(Downgrading& work) : work_(work) {}

  void write_poses() {
    work_.each(work_.root.models, [&](auto id, const model::Model& model) {
      if (model.include != 0xffffffffU) return;
      const auto X_WP = model.parent ? work_.frames.pose(model.parent) : std::optional(Pose{});
      const bool placed = !model.placement_frame.value.empty() && work_.to < kNestedNames;
      write_pose(model.pose, model.site, in(X_WP, id), placed);
    });
    work_.each(work_.root.links, [&](auto id, const model::Link& link) {
      write_pose(link.pose, link.site, in(work_.frames.pose(link.model), id), false);
    });
    work_.each(work_.root.joints, [&](auto id, const model::Joint& joint) {
      const Id<model::Link> child = work_.frames.ends(id).child;
      const bool is_frame =
          work_.drops_frames() && child && joint.child.value != work_.name_in(joint.model, child);
      write_pose(joint.pose, joint.site,
                 child ? in(work_.frames.pose(child), id) : std::optional<Pose>(), is_frame);
    });
    const auto of_link = [&](auto id, const auto& part) {
      if (part.link) write_pose(part.pose, part.site, in(work_.frames.pose(part.link), id), false);
    };
    work_.each(work_.root.collisions, of_link);
    work_.each(work_.root.visuals, of_link);
    work_.each(work_.root.sensors, [&](auto id, const model::Sensor& sensor) {
      write_pose(
          sensor.pose, sensor.site,
          in(sensor.joint ? work_.frames.pose(sensor.joint) : work_.frames.pose(sensor.link), id),
          false);
    });
    work_.each(work_.root.lights, [&](auto id, const model::Light& light) {
      const auto X_WF = light.link ? work_.frames.pose(light.link) : std::optional(Pose{});
      write_pose(light.pose, light.site, in(X_WF, id), false);
    });
    for (const model::Include& include : work_.root.includes) {
      if (!work_.root.own(include.site)) continue;
      const auto X_WP = include.model ? work_.frames.pose(include.model) : std::optional(Pose{});
      write_pose(include.pose, include.site,
                 include.loaded ? in(X_WP, include.loaded) : std::nullopt, false);
    }
    for (const model::Link& link : work_.root.links) {
      if (work_.root.own(link.site) && link.inertial.written)
        write_pose(link.inertial.pose, link.inertial.site, link.inertial.pose.pose.value, false);
    }
    // Of frames that stay.
    if (!work_.drops_frames()) {
      work_.each(work_.root.frames, [&](auto, const model::Frame& frame) {
        write_pose(frame.pose, frame.site, std::nullopt, false);
      });
    }
  }

 private:
  template <class T>
  std::optional<Pose> in(const std::optional<Pose>& X_WF, Id<T> id) const {
    const auto X_WT = work_.frames.pose(id);
    if (!X_WF || !X_WT) return std::nullopt;
    return compose(inverse(*X_WF), *X_WT);
  }

  /// `X` is in the frame that the older version takes for granted.
  void write_pose(const model::PoseField& field, const model::Site& holder,
                  const std::optional<Pose>& X, bool must_be_written) {
    const auto pose = work_.element(holder).child("pose");
    const std::string& frame = field.relative_to.value;
    const bool in_frame =
        !frame.empty() && (work_.drops_frames() ||
                           (work_.to < kNestedNames && frame.find("::") != std::string::npos));
    std::vector<xml::Attribute> gone;
    if (pose) {
      for (const xml::Attribute attribute : pose->attributes()) {
        const std::string_view name = attribute.name();
        const bool rotation = name == "rotation_format" || name == "degrees";
        if ((rotation && work_.to < kRotationFormats) ||
            (name == "relative_to" && (in_frame || work_.to < kPoseFrames)))
          gone.push_back(attribute);
      }
    }
    const bool other_words = std::any_of(gone.begin(), gone.end(), [](const xml::Attribute& each) {
      return each.name() != "relative_to";
    });
    for (const xml::Attribute attribute : gone)
      work_.edit(xml::remove_attribute(work_.document, attribute));
    if (!in_frame && !must_be_written && !other_words) return;
    const bool moved = in_frame || must_be_written;
    if (moved && !X) {
      return work_.refuse(UpgradeNoteKind::kNotTheSame, work_.element(holder).tag_span(),
                          "where it is cannot be told");
    }
    const Pose& value = moved ? *X : field.pose.value;
    const std::string numbers = xyz_text(value) + ' ' + rpy_text(value);
    if (pose)
      work_.edit(xml::set_text(work_.document, *pose, numbers));
    else if (!(value == Pose{}))
      work_.edit(xml::insert_child(work_.document, work_.element(holder), std::nullopt,
                                   "<pose>" + numbers + "</pose>"));
  }

  Downgrading& work_;
};

}  // namespace

void downgrade_poses(Downgrading& work) { PoseDowngrader(work).write_poses(); }

}  // namespace rigor::author
