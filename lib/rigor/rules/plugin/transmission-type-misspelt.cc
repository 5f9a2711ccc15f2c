// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

#include <rigor/rules/plugin/drive_wheels.h>
#include <rigor/rules/rule.h>
#include <rigor/schema/suggest.h>

namespace rigor::rules::transmission_type_misspelt {

constexpr std::string_view kTypes[] = {"SimpleTransmission", "DifferentialTransmission",
                                       "FourBarLinkageTransmission", "PantographTransmission"};

constexpr std::string_view kInterfaces[] = {"PositionJointInterface", "VelocityJointInterface",
                                            "EffortJointInterface",   "JointStateInterface",
                                            "PosVelJointInterface",   "PosVelAccJointInterface",
                                            "JointCommandInterface",  "ActuatorStateInterface"};

constexpr std::string_view kNamespaces[] = {"transmission_interface/", "hardware_interface/"};

/// What stands before the last slash, and behind it.
std::pair<std::string_view, std::string_view> parts_of(std::string_view text) {
  const std::size_t slash = text.rfind('/');
  if (slash == text.npos) return {{}, text};
  return {text.substr(0, slash + 1), text.substr(slash + 1)};
}

template <std::size_t count>
void check_value(const model::Parameter& value, const std::string_view (&known)[count],
                 const char* kind, Context& context) {
  const auto [space, name] = parts_of(value.value.value);
  if (name.empty() || !context.may_suggest()) return;
  context.compared(count);
  std::string meant;
  if (std::find(std::begin(known), std::end(known), name) == std::end(known)) {
    const auto near = schema::near(name, {std::begin(known), std::end(known)});
    if (near.empty()) return;  // a driver's own
    meant = std::string(space) + std::string(near.front());
  } else if (!space.empty()) {
    const auto near = schema::near(space, {std::begin(kNamespaces), std::end(kNamespaces)});
    if (near.empty() || near.front() == space) return;
    meant = std::string(near.front()) + std::string(name);
  } else {
    return;
  }
  const Span where = trimmed(value, context);
  context.report({.where = where,
                  .message = "there is no " + std::string(kind) + " '" + value.value.value +
                             "' in ros_control",
                  .help = "did you mean '" + meant + "'?",
                  .fix = Fix{"name '" + meant + "'", Applicability::kUnsafe, {{where, meant}}}});
}

void check(const model::Root& root, Context& context) {
  for (const model::Parameter& transmission : root.transmissions) {
    if (!root.own(transmission.site)) continue;
    for (const model::Parameter& part : transmission.children) {
      if (part.name == "type") check_value(part, kTypes, "transmission", context);
      for (const model::Parameter& inner : part.children) {
        if (inner.name == "hardwareInterface")
          check_value(inner, kInterfaces, "hardware interface", context);
      }
    }
  }
}

Rule rule() {
  return {
      .name = "transmission-type-misspelt",
      .severity = Severity::kWarning,
      .formats = Formats::kUrdf,
      .fix = FixGrade::kUnsafe,
      .summary = "the type or hardware interface of a transmission is nearly one of ros_control",
      .why = "ros_control loads no such transmission, or ignores the joint with a warning; the "
             "controller then does not find its joint. Names of a driver's own interfaces are not "
             "reported.",
      .what_to_do = "Write transmission_interface/SimpleTransmission, or hardware_interface/ with "
                    "PositionJointInterface, VelocityJointInterface or EffortJointInterface.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::transmission_type_misspelt
