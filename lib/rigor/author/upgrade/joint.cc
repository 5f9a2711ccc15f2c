// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What changed about joints: the frame of an axis (model up to 1.4; a flag in 1.5 and 1.6; an attribute
// since 1.7), a zero that meant "no limit", the pitch of a screw.

#include <optional>
#include <string>

#include <fmt/core.h>

#include <rigor/author/upgrade/step.h>
#include <rigor/read/values.h>
#include <rigor/write/numbers.h>
#include <rigor/xml/edit.h>

namespace rigor::author {
namespace {

constexpr std::string_view kFlag = "use_parent_model_frame";

/// Up to this version a missing flag says that the axis is in the model frame.
constexpr int kLastInModelFrame = 4;

bool is_in_model_frame(const UpgradeStep& step, xml::Element axis) {
  return read::bool_field(read::child_text(axis, kFlag), step.from() <= kLastInModelFrame).value;
}

template <class Visit>
void for_each_axis(const UpgradeStep& step, Visit visit) {
  step.for_each("joint", "axis", visit);
  step.for_each("joint", "axis2", visit);
}

}  // namespace

void upgrade_zero_limits(UpgradeStep& step) {
  for (const std::string_view name : {"effort", "velocity"}) {
    std::optional<Span> first;
    std::size_t count = 0;
    step.for_each("limit", name, [&](xml::Element element) {
      const auto value = write::number_in(element.text());
      if (!value || *value != 0) return;
      step.edit(xml::set_text(step.document(), element, "-1"));
      if (count++ == 0) first = element.text_span();
    });
    if (!first) continue;
    const std::string more = count > 1 ? fmt::format(" (and {} more)", count - 1) : "";
    step.note(UpgradeNoteKind::kUnlimited, Severity::kInfo, *first,
              fmt::format("{} 0{} is no limit up to 1.3, and since then a joint that cannot move: "
                          "-1, no limit, is written",
                          name, more));
  }
}

void upgrade_axes_to_flag(UpgradeStep& step) {
  constexpr int kLastWithFlag = 6;
  if (step.to() > kLastWithFlag) return;  // a later step writes what the flag became
  for_each_axis(step, [&](xml::Element axis) {
    if (axis.child(kFlag) || !is_in_model_frame(step, axis)) return;
    step.edit(xml::insert_child(step.document(), axis, axis.child("xyz"),
                                "<use_parent_model_frame>true</use_parent_model_frame>"));
  });
}

void upgrade_axes_to_expressed_in(UpgradeStep& step) {
  const xml::Document& document = step.document();
  for_each_axis(step, [&](xml::Element axis) {
    if (is_in_model_frame(step, axis)) {
      if (const auto xyz = axis.child("xyz")) {
        step.edit(xml::set_attribute(document, *xyz, "expressed_in", "__model__"));
      } else {
        const auto attribute = axis.attribute("xyz");
        const std::string value = attribute ? xml::escaped(attribute->value()) : "0 0 1";
        step.edit(xml::insert_child(document, axis, std::nullopt,
                                    "<xyz expressed_in=\"__model__\">" + value + "</xyz>"));
        if (attribute) step.edit(xml::remove_attribute(document, *attribute));
      }
    }
    if (const auto flag = axis.child(kFlag)) step.edit(xml::remove_element(document, *flag));
  });
}

void upgrade_feedback(UpgradeStep& step) {
  step.for_each("joint", "physics", [&](xml::Element physics) {
    const auto ode = physics.child("ode");
    const auto feedback = ode ? ode->child("provide_feedback") : std::nullopt;
    if (!feedback || physics.child("provide_feedback")) return;
    const std::string value = xml::escaped(read::trimmed(feedback->text()));
    step.edit(xml::remove_element(step.document(), *feedback));
    step.edit(xml::insert_child(step.document(), physics, std::nullopt,
                                "<provide_feedback>" + value + "</provide_feedback>"));
  });
}

void upgrade_screws(UpgradeStep& step) {
  step.for_each([&](xml::Element joint) {
    const auto type = joint.attribute("type");
    if (joint.name() != "joint" || !type || read::trimmed(type->value()) != "screw") return;
    if (joint.child("thread_pitch") || joint.child("screw_thread_pitch")) return;
    const auto after = joint.child("child");
    step.edit(xml::insert_child(step.document(), joint, after, "<thread_pitch>1.0</thread_pitch>"));
  });
}

}  // namespace rigor::author
