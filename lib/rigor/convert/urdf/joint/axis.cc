// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/urdf/joint/axis.h>

#include <cmath>
#include <optional>
#include <string>

#include <rigor/convert/digits.h>
#include <rigor/convert/number_text.h>
#include <rigor/convert/written_number.h>
#include <rigor/model/subject.h>
#include <rigor/robot/robot.h>
#include <rigor/write/numbers.h>
#include <rigor/xml/document.h>

namespace rigor::convert {
namespace {

using model::Field;
using model::Id;
using model::Vector3;

/// How far from 1 the length of an axis may be and its digits still be kept: it is the error of a
/// prismatic joint per meter of travel, in readers that do not normalize.
constexpr double kUnitTolerance = 1e-9;

class UrdfAxisWriter {
 public:
  UrdfAxisWriter(UrdfDraft& draft, Id<model::Joint> id, std::size_t k, UrdfJoint& target)
      : draft_(draft),
        documents_(draft.source.documents),
        ledger_(draft.ledger),
        id_(id),
        joint_(draft.source.root[id]),
        index_(k),
        target_(target) {
    if (k < joint_.axes.size()) axis_ = joint_.axes[k];
  }

  void write() {
    take_containers();
    target_.axis = direction();
    write_limits();
    write_dynamics();
  }

 private:
  void take_containers() {
    ledger_.take(axis_.site);
    ledger_.take(axis_.limit_site);
    if (axis_.site.span.nowhere()) return;
    const xml::Element element = documents_.element(axis_.site);
    for (const char* name : {"dynamics", "use_parent_model_frame"}) {
      if (const auto child = element.child(name)) ledger_.take(*child);
    }
    if (const auto flag = element.attribute("use_parent_model_frame")) {
      ledger_.take_value(flag->value_span());
    }
  }

  void note(NoteKind kind, Outcome outcome, Span where, std::string written,
            std::string instead = {}) {
    if (where.nowhere()) where = axis_.site.name;
    if (where.nowhere()) where = joint_.site.name;
    ledger_.note({.kind = kind,
                  .outcome = outcome,
                  .where = where,
                  .subject = model::subject(draft_.source.root, joint_),
                  .written = std::move(written),
                  .instead = std::move(instead)});
  }

  // --- Direction ---

  Number3 direction() {
    ledger_.take(axis_.expressed_in);
    const double size = length(axis_.xyz.value);
    const auto unit = in_joint_frame(size);
    const std::string text =
        axis_.site.span.nowhere() ? "" : number_texts(numbers(axis_.xyz.value));
    if (!unit) {
      ledger_.take(axis_.xyz, Outcome::kSubstituted);
      note(NoteKind::kAxisZero, Outcome::kSubstituted, axis_.xyz.span, text, "0 0 1");
      return numbers({0, 0, 1});
    }
    const bool is_unit = std::abs(size - 1) <= kUnitTolerance;
    ledger_.take(axis_.xyz, is_unit ? Outcome::kConverted : Outcome::kRewritten);
    if (is_unit) return settled_axis(numbers_like(documents_, size * *unit, axis_.xyz));
    const Number3 written = settled_axis(numbers(*unit));
    note(NoteKind::kAxisUnit, Outcome::kRewritten, axis_.xyz.span, text, number_texts(written));
    return written;
  }

  /// What was computed, without its last noise: 3/5 is 0.6.
  static Number3 settled_axis(Number3 axis) {
    for (Number& number : axis) {
      if (number.text.empty()) number.value = write::settled(number.value, 0, 1);
    }
    return axis;
  }

  /// As a unit vector; nothing for an axis that has no direction or is not there.
  std::optional<Vector3> in_joint_frame(double size) const {
    if (!(size > 0) || !std::isfinite(size) || index_ >= joint_.axes.size()) return std::nullopt;
    if (axis_.expressed_in.value.empty()) return (1 / size) * axis_.xyz.value;
    const auto axis_W = draft_.source.frames.axis(id_, index_);
    const auto X_WJ = draft_.source.frames.pose(id_);
    if (!axis_W || !X_WJ) return std::nullopt;
    return rotate(conjugate(X_WJ->rotation), *axis_W);
  }

  // --- Limits ---

  static bool is_endless(double limit) { return !std::isfinite(model::position_limit(limit)); }

  bool has_effort() const {
    return std::isfinite(model::effort_limit(draft_.source.root, joint_, axis_));
  }
  bool has_velocity() const {
    return std::isfinite(model::velocity_limit(draft_.source.root, joint_, axis_));
  }

  std::string said(const Field<double>& field) const {
    if (!field.written) return "not written";
    const Number number = written_number(documents_, field);
    return number.text.empty() ? to_text(number) : number.text;
  }

  Number stand_in(const Field<double>& field, NoteKind kind, double value) {
    Number number{value, {}};
    ledger_.take(field, Outcome::kSubstituted);
    note(kind, Outcome::kSubstituted, field.span, said(field), to_text(number));
    return number;
  }

  Number taken(const Field<double>& field) {
    ledger_.take(field);
    return written_number(documents_, field);
  }

  Number bound(const Field<double>& field, double endless) {
    if (is_endless(field.value)) return stand_in(field, NoteKind::kLimitStandIn, endless);
    return taken(field);
  }

  void write_limits() {
    const bool endless = is_endless(axis_.lower.value) && is_endless(axis_.upper.value);
    if (target_.type == "revolute" && endless) {
      target_.type = "continuous";
      tell_continuous();
    }
    const bool continuous = target_.type == "continuous";
    if (continuous && endless) {
      ledger_.take(axis_.lower, Outcome::kRewritten);
      ledger_.take(axis_.upper, Outcome::kRewritten);
    }
    if (continuous && !has_effort() && !has_velocity()) {
      // Without `<limit>` a continuous joint has none: exact.
      ledger_.take(axis_.effort, Outcome::kRewritten);
      ledger_.take(axis_.velocity, Outcome::kRewritten);
      return;
    }
    UrdfLimit limit;
    if (!continuous) {
      limit.lower = bound(axis_.lower, -draft_.options.unlimited);
      limit.upper = bound(axis_.upper, draft_.options.unlimited);
      if (axis_.lower.value > axis_.upper.value) {
        note(NoteKind::kLimitInverted, Outcome::kConverted, axis_.lower.span,
             said(axis_.lower) + " to " + said(axis_.upper));
      }
    }
    const double none = draft_.options.unlimited;
    limit.effort =
        has_effort() ? taken(axis_.effort) : stand_in(axis_.effort, NoteKind::kEffortStandIn, none);
    limit.velocity = has_velocity() ? taken(axis_.velocity)
                                    : stand_in(axis_.velocity, NoteKind::kVelocityStandIn, none);
    target_.limit = limit;
  }

  /// Of a joint that is written as several, that has been reported.
  void tell_continuous() {
    if (joint_.type != model::JointType::kRevolute) return;
    ledger_.take(joint_.type_name, Outcome::kRewritten);
    note(NoteKind::kContinuous, Outcome::kRewritten, joint_.type_name.span, "revolute",
         "continuous");
  }

  // --- Dynamics ---

  void write_dynamics() {
    target_.damping = dynamic(axis_.damping);
    target_.friction = dynamic(axis_.friction);
  }

  std::optional<Number> dynamic(const Field<double>& field) {
    // One that is not a finite number stays in the account as lost.
    if (!field.written || !std::isfinite(field.value)) return std::nullopt;
    ledger_.take(field);
    return written_number(documents_, field);
  }

  UrdfDraft& draft_;
  const read::Documents& documents_;
  Ledger& ledger_;
  Id<model::Joint> id_;
  const model::Joint& joint_;
  std::size_t index_;
  UrdfJoint& target_;
  model::Axis axis_ = default_axis();

  static model::Axis default_axis() {
    model::Axis axis;
    axis.xyz.value = {0, 0, 1};
    axis.lower.value = -robot::kUnlimited;
    axis.upper.value = axis.effort.value = axis.velocity.value = robot::kUnlimited;
    return axis;
  }
};

}  // namespace

void set_axis(UrdfDraft& draft, Id<model::Joint> joint, std::size_t k, UrdfJoint& target) {
  UrdfAxisWriter(draft, joint, k, target).write();
}

UrdfLimit no_limit(const UrdfOptions& options) {
  return {.lower = Number{-options.unlimited, {}},
          .upper = Number{options.unlimited, {}},
          .effort = {options.unlimited, {}},
          .velocity = {options.unlimited, {}}};
}

}  // namespace rigor::convert
