// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <unordered_map>
#include <vector>

#include <fmt/core.h>

#include <rigor/mass/resolve.h>
#include <rigor/rules/physics/contact_settings.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::contact_too_soft {

constexpr double kGravity = 9.8;  // m/s²

// m; a robot on soft tires sinks in by less.
constexpr double kDeep = 0.02;

/// kg, of all links of the model that the link is in.
double mass_of(model::Id<model::Model> id, const model::Root& root) {
  double sum = 0;
  for (const auto link : root[id].links) {
    if (mass::is_automatic(root[link])) return 0;
    sum += mass::resolve(root, link).mass;
  }
  return sum;
}

void check(const model::Root& root, Context& context) {
  std::unordered_map<std::uint32_t, double> masses;
  for (const ContactSettings& contact : contact_settings(context)) {
    const auto& kp = contact.kp;
    const model::Link& link = root[contact.link];
    if (!kp.written || !link.model || is_static(root, link.model)) continue;
    if (kp.value <= 0) {
      if (context.is_sdf()) continue;  // contact-stiffness-not-positive reports it
      context.report(
          {.where = kp.span,
           .message = fmt::format("the contact's stiffness kp is {} N/m: nothing pushes the "
                                  "bodies apart",
                                  kp.value),
           .subject = contact.subject});
      continue;
    }
    const auto [entry, first] = masses.emplace(link.model.value, 0);
    if (first) entry->second = mass_of(link.model, root);
    // All of the model's links bear the same part at best.
    const double shared = entry->second / static_cast<double>(root[link.model].links.size());
    const double load =
        std::max(shared, mass::is_automatic(link) ? 0 : mass::resolve(root, contact.link).mass);
    const double depth = load * kGravity / kp.value;
    if (depth < kDeep) continue;
    context.report(
        {.where = kp.span,
         .message =
             fmt::format("a contact stiffness of {:.4g} N/m under {:.3g} kg gives way by {:.2g} m",
                         kp.value, load, depth),
         .subject = contact.subject,
         .help = fmt::format("{:.2g} N/m give way by a millimeter", load * kGravity / 1e-3)});
  }
}

Rule rule() {
  return {
      .name = "contact-too-soft",
      .severity = Severity::kWarning,
      .summary = "a contact is too soft for the weight that it bears",
      .why = "The body sinks into the ground by its weight over the stiffness, and a wheel or "
             "foot vanishes in it. Gazebo classic makes ODE's contact parameters of kp (N/m) and "
             "kd; the weight is the link's own, or its share of the model's if that is more.",
      .what_to_do = "Leave kp out, or write the stiffness of the material in N/m: 1e5 and more.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::contact_too_soft
