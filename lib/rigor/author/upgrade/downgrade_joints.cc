// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <cstddef>
#include <string>

#include <rigor/author/upgrade/downgrading.h>
#include <rigor/model/motion.h>
#include <rigor/schema/value.h>
#include <rigor/write/numbers.h>
#include <rigor/xml/edit.h>

namespace rigor::author {
namespace {

using model::Id;
using model::Vector3;
using xml::Element;

class JointDowngrader {
 public:
  explicit JointDowngrader(Downgrading& work) : work_(work) {}

  void write_joints() {
    work_.each(work_.root.joints, [&](Id<model::Joint> id, const model::Joint& joint) {
      if (work_.drops_frames()) {
        const model::Frames::Ends& ends = work_.frames.ends(id);
        if (!ends.parent_is_world) write_end(joint, "parent", joint.parent.value, ends.parent);
        write_end(joint, "child", joint.child.value, ends.child);
      }
      for (std::size_t k = 0; k < joint.axes.size(); ++k) {
        if (work_.to < kPoseFrames && k < 2) write_axis(id, joint, k);
        write_limits(joint.axes[k]);
      }
      if (joint.type == model::JointType::kScrew) write_screw(joint);
    });
  }

 private:
  void write_end(const model::Joint& joint, const char* name, const std::string& written,
                 Id<model::Link> link) {
    const auto end = work_.element(joint.site).child(name);
    if (!end) return;
    if (!link) return work_.refuse(UpgradeNoteKind::kNotTheSame, end->tag_span(), "names no link");
    const std::string other = work_.name_in(joint.model, link);
    if (other != written) work_.edit(xml::set_text(work_.document, *end, xml::escaped(other)));
  }

  void write_axis(Id<model::Joint> id, const model::Joint& joint, std::size_t k) {
    const model::Axis& axis = joint.axes[k];
    const Element written = work_.element(axis.site);
    const auto xyz = written.child("xyz");
    const auto flag = written.child("use_parent_model_frame");
    const bool of_model = axis.expressed_in.value == "__model__";
    const bool to_model = work_.to < kNestedModels;  // 1.4: whatever is written
    if (const auto attribute = xyz ? xyz->attribute("expressed_in") : std::nullopt)
      work_.edit(xml::remove_attribute(work_.document, *attribute));
    if (flag && to_model) work_.edit(xml::remove_element(work_.document, *flag));
    if (of_model) {
      if (!to_model && !flag)
        work_.edit(xml::insert_child(work_.document, written, xyz,
                                     "<use_parent_model_frame>true</use_parent_model_frame>"));
      return;
    }
    if (!to_model && axis.expressed_in.value.empty()) return;
    const auto in_world = work_.frames.axis(id, k);
    const auto X_WF = to_model ? work_.frames.pose(joint.model) : work_.frames.pose(id);
    if (!in_world || !X_WF)
      return work_.refuse(UpgradeNoteKind::kNotTheSame, written.tag_span(),
                          "its direction is not known");
    const Vector3 v = length(axis.xyz.value) * rotate(conjugate(X_WF->rotation), *in_world);
    const auto number = [](double value) { return write::settled(value, 0, 1); };
    const std::string text = write::joined({number(v.x), number(v.y), number(v.z)});
    if (xyz)
      work_.edit(xml::set_text(work_.document, *xyz, text));
    else
      work_.edit(
          xml::insert_child(work_.document, written, std::nullopt, "<xyz>" + text + "</xyz>"));
  }

  void write_limits(const model::Axis& axis) {
    if (work_.to >= kInfinities) return;
    const auto write = [&](const model::Field<double>& field, const char* none) {
      if (field.written && !field.span.nowhere() && std::isinf(field.value))
        work_.edits.push_back({field.span, none});
    };
    write(axis.lower, axis.lower.value < 0 ? "-1e16" : "1e16");
    write(axis.upper, axis.upper.value < 0 ? "-1e16" : "1e16");
    write(axis.effort, "-1");
    write(axis.velocity, "-1");
  }

  void write_screw(const model::Joint& joint) {
    if (work_.to >= kInfinities || work_.from < kInfinities) return;
    const Element written = work_.element(joint.site);
    const auto pitch = written.child("screw_thread_pitch");
    if (pitch) work_.edit(xml::remove_element(work_.document, *pitch));
    if (!pitch && written.child("thread_pitch")) return;
    const double lead = model::screw_lead(work_.root, joint);
    const std::string text = schema::to_shortest(-1 / lead);
    if (const auto old = written.child("thread_pitch"))
      work_.edit(xml::set_text(work_.document, *old, text));
    else
      work_.edit(xml::insert_child(work_.document, written, written.child("child"),
                                   "<thread_pitch>" + text + "</thread_pitch>"));
  }

  Downgrading& work_;
};

}  // namespace

void downgrade_joints(Downgrading& work) { JointDowngrader(work).write_joints(); }

}  // namespace rigor::author
