// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include <fmt/core.h>

#include <rigor/mass/resolve.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::spring_damper_unstable {

// Explicit steps h diverge when a damper takes more than twice the speed in one (d h / I), and symplectic
// ones when a spring turns it round more than twice (k h² / I).
constexpr double kMaxDamping = 2;
constexpr double kMaxStiffness = 4;

// What hangs on a joint is gone through only so far.
constexpr std::size_t kMaxLinks = 200;

constexpr double kUsualStep = 0.001;  // s, of Gazebo

double step_of(const model::Root& root) {
  for (const model::Physics& physics : root.physics) {
    if (physics.max_step_size.written && physics.max_step_size.value > 0) {
      return physics.max_step_size.value;
    }
  }
  return kUsualStep;
}

class Bodies {
 public:
  explicit Bodies(const Context& context) : context_(context) {
    const model::Root& root = context.root();
    for (std::uint32_t i = 0; i < root.joints.size(); ++i) {
      const auto& ends = context.frames().ends({i});
      if (ends.parent && ends.child) children_[ends.parent.value].push_back(ends.child);
    }
  }

  /// Of all that the joint moves, as if it were one body: kg·m² about the axis, kg for a slider. What the
  /// joint feels is no more. Nothing when there is too much of it.
  std::optional<double> moved(model::Id<model::Joint> id, model::Id<model::Link> child,
                              const model::Vector3& axis_W) const {
    const model::Root& root = context_.root();
    const bool slides = root[id].type == model::JointType::kPrismatic;
    const auto X_WJ = context_.frames().pose(id);
    if (!X_WJ) return std::nullopt;
    std::vector<model::Id<model::Link>> all{child};
    double sum = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (all.size() > kMaxLinks) return std::nullopt;
      if (mass::is_automatic(root[all[i]])) return std::nullopt;
      const auto X_WL = context_.frames().pose(all[i]);
      if (!X_WL) return std::nullopt;
      const mass::MassProperties body = mass::transformed(*X_WL, mass::resolve(root, all[i]));
      sum += slides ? body.mass : mass::moment_about(axis_W, mass::about(X_WJ->translation, body));
      const auto below = children_.find(all[i].value);
      if (below == children_.end()) continue;
      all.insert(all.end(), below->second.begin(), below->second.end());
    }
    return sum;
  }

 private:
  const Context& context_;
  std::unordered_map<std::uint32_t, std::vector<model::Id<model::Link>>> children_;
};

void check(const model::Root& root, Context& context) {
  const double step = step_of(root);
  std::optional<Bodies> bodies;
  for (std::uint32_t i = 0; i < root.joints.size(); ++i) {
    const model::Joint& joint = root.joints[i];
    if (joint.axes.size() != 1 || !root.own(joint.site)) continue;
    const model::Axis& axis = joint.axes.front();
    const bool has_spring = axis.spring_stiffness.written && axis.spring_stiffness.value > 0;
    if (!(axis.damping.value > 0) && !has_spring) continue;
    if (joint.type != model::JointType::kRevolute && joint.type != model::JointType::kContinuous &&
        joint.type != model::JointType::kPrismatic) {
      continue;
    }
    const auto child = context.frames().ends({i}).child;
    const auto axis_W = context.frames().axis({i}, 0);
    if (!child || !axis_W || joint.implicit_spring_damper) continue;
    if (!bodies) bodies.emplace(context);
    const auto inertia = bodies->moved({i}, child, *axis_W);
    if (!inertia || !(*inertia > 0)) continue;
    const char* unit = joint.type == model::JointType::kPrismatic ? "kg" : "kg·m²";
    const double damped = axis.damping.value * step / *inertia;
    const double sprung = axis.spring_stiffness.value * step * step / *inertia;
    if (damped > kMaxDamping) {
      context.report(
          {.where = axis.damping.span,
           .message = fmt::format("a damping of {} on {:.3g} {} takes {:.3g} times its speed away "
                                  "in a step of {} s: above 2 it is thrown about",
                                  axis.damping.value, *inertia, unit, damped, step),
           .subject = context.subject(joint),
           .help =
               fmt::format("at this step up to {:.3g} is stable", kMaxDamping * *inertia / step)});
    } else if (has_spring && sprung > kMaxStiffness) {
      context.report({.where = axis.spring_stiffness.span,
                      .message = fmt::format("a spring of {} on {:.3g} {} is too stiff for a step "
                                             "of {} s: it gains energy with each",
                                             axis.spring_stiffness.value, *inertia, unit, step),
                      .subject = context.subject(joint),
                      .help = fmt::format("at this step up to {:.3g} is stable",
                                          kMaxStiffness * *inertia / (step * step))});
    }
  }
}

Rule rule() {
  return {
      .name = "spring-damper-unstable",
      .severity = Severity::kWarning,
      .targets = {Target::kGazeboClassic},
      .summary = "a joint's damping or spring is too strong for the step and the mass it moves",
      .why = "Gazebo classic applies both as forces of the previous step (explicitly). When they "
             "reverse the motion by more than it was, each step is faster than the last, and the "
             "simulation diverges. Engines that solve them with the constraints (implicitly) are "
             "not affected.",
      .what_to_do =
          "Take less damping or a smaller step, give the link a real tensor, or write "
          "<implicit_spring_damper>true</implicit_spring_damper> in the joint's <physics><ode>.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::spring_damper_unstable
