// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What changed about poses and names: `frame` became `relative_to` in 1.7, inertials lost it in 1.8,
// and `::` in a name is the path into a nested model since.

#include <string>

#include <rigor/author/upgrade/step.h>
#include <rigor/read/values.h>
#include <rigor/xml/edit.h>

namespace rigor::author {

void upgrade_pose_frames(UpgradeStep& step) {
  step.for_each([&](xml::Element pose) {
    if (pose.name() != "pose") return;
    const auto frame = pose.attribute("frame");
    if (!frame) return;
    // One that is there already counts, though its version did not know it.
    if (pose.attribute("relative_to") || read::trimmed(frame->value()).empty()) {
      step.edit(xml::remove_attribute(step.document(), *frame));
    } else {
      step.edit({{frame->name_span(), "relative_to"}});
    }
  });
}

void upgrade_inertial_poses(UpgradeStep& step) {
  step.for_each("inertial", "pose", [&](xml::Element pose) {
    const auto frame = pose.attribute("relative_to");
    if (!frame || !read::trimmed(frame->value()).empty()) return;
    step.edit(xml::remove_attribute(step.document(), *frame));
  });
}

void refuse_scoped_names(UpgradeStep& step) {
  step.for_each([&](xml::Element element) {
    const auto name = element.attribute("name");
    if (!name || element.name() == "plugin") return;
    if (name->value().find("::") == std::string_view::npos) return;
    step.note(UpgradeNoteKind::kScopedName, Severity::kError, name->value_span(),
              "'" + std::string(name->value()) + "' has :: in it, which only joins the names of " +
                  "nested models since 1.8: give it another name first, or upgrade to 1.7");
  });
}

}  // namespace rigor::author
