// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <set>
#include <string>
#include <string_view>

#include <rigor/rules/physics/contact_settings.h>
#include <rigor/rules/plugin/drive_wheels.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::wheel_without_friction {

bool has_word(const std::string& name, std::string_view word) {
  const auto same = [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a - 'A' + 'a' : a) == b; };
  return std::search(name.begin(), name.end(), word.begin(), word.end(), same) != name.end();
}

/// By what its author calls it; casters slide on purpose.
bool is_called_wheel_or_foot(const std::string& name) {
  for (const std::string_view passive :
       {"caster", "castor", "footprint", "slide", "skid", "omni", "mecanum"}) {
    if (has_word(name, passive)) return false;
  }
  for (const std::string_view word : {"wheel", "foot", "tire", "tyre"}) {
    if (has_word(name, word)) return true;
  }
  return false;
}

std::set<std::uint32_t> driven_links(Context& context) {
  std::set<std::uint32_t> links;
  for (const model::Plugin& plugin : context.root().plugins) {
    const auto drive = drive_of(plugin, context);
    if (!drive) continue;
    for (const auto* side : {&drive->left, &drive->right}) {
      for (const DrivenWheel& wheel : *side) {
        links.insert(context.frames().ends(wheel.joint).child.value);
      }
    }
  }
  return links;
}

void check(const model::Root& root, Context& context) {
  std::vector<ContactSettings> slippery;
  for (ContactSettings& contact : contact_settings(context)) {
    if (contact.mu.written && contact.mu.value == 0) {
      slippery.push_back(std::move(contact));
    }
  }
  if (slippery.empty()) return;
  const std::set<std::uint32_t> driven = driven_links(context);
  for (const ContactSettings& contact : slippery) {
    const std::string& name = root[contact.link].name.value;
    const bool drives = driven.contains(contact.link.value);
    if (!drives && !is_called_wheel_or_foot(name)) continue;
    context.report({.where = contact.mu.span,
                    .message = "the friction of '" + name + "' is 0" +
                               (drives ? ": the wheel spins and drives nothing" : ": it slides"),
                    .subject = contact.subject});
  }
}

Rule rule() {
  return {
      .name = "wheel-without-friction",
      .severity = Severity::kWarning,
      .summary = "a wheel or foot has no friction",
      .why = "The wheel spins on the spot and the robot stays; a foot slides away under its load. "
             "A friction of 0 is right for what slides on purpose, such as a caster: reported are "
             "the wheels of a drive plugin, and links that are called wheel, foot or tire.",
      .what_to_do = "Write the coefficient of friction: 1 for rubber on a dry floor.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::wheel_without_friction
