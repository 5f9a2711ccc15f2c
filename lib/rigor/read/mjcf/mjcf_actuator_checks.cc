// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <rigor/read/mjcf/mjcf_checks.h>

namespace rigor::read {
namespace {

using MjcfKind = MjcfFactKind;

std::string actuator_named(xml::Element element) {
  const std::string name = mjcf_name(element, "name").value;
  return name.empty() ? std::string(element.name()) : "actuator " + name;
}

/// Why the actuator cannot move anything; empty when it may.
std::string no_effect(const MjcfValues& values) {
  const std::vector<double> gear = values.numbers("gear");
  const bool none =
      !gear.empty() && std::all_of(gear.begin(), gear.end(), [](double g) { return g == 0; });
  if (none) return "its gear is zero";
  const auto zero_range = [&](const char* range, const char* limited) {
    const std::vector<double> n = values.numbers(range);
    const auto mode = values.text(limited);
    const bool off = mode && trimmed(mode->text) == "false";
    return !off && n.size() == 2 && n[0] == 0 && n[1] == 0 && values.text(range);
  };
  if (zero_range("forcerange", "forcelimited")) return "its forcerange is 0 0";
  const std::string_view tag = values.element().name();
  if (tag == "motor" && zero_range("ctrlrange", "ctrllimited")) return "its ctrlrange is 0 0";
  if (tag == "position" && values.own("kp") && values.number("kp", 1).value == 0)
    return "its kp is zero";
  if (tag == "velocity" && values.own("kv") && values.number("kv", 1).value == 0)
    return "its kv is zero";
  return {};
}

/// The numbers of a state, by what they are of.
struct StateSize {
  std::size_t positions = 0, velocities = 0, controls = 0, mocaps = 0;
};

StateSize state_size(const MjcfScope& scope) {
  StateSize size;
  for_each_in_bodies(scope, [&](xml::Element element, std::size_t class_id) {
    const std::string_view tag = element.name();
    if (tag == "body") {
      const auto mocap = attribute_text(element, "mocap");
      size.mocaps += mocap && trimmed(mocap->text) == "true" ? 1 : 0;
    }
    if (tag != "joint" && tag != "freejoint") return;
    const MjcfValues values = scope.defaults.values(element, "joint", class_id);
    const std::string type = tag == "freejoint" ? "free" : values.string("type", "hinge").value;
    size.positions += type == "free" ? 7 : type == "ball" ? 4 : 1;
    size.velocities += type == "free" ? 6 : type == "ball" ? 3 : 1;
  });
  size.controls = scope.tree.in_sections("actuator").size();
  return size;
}

/// How many of a set have each bit.
class BitCounts {
 public:
  void add(unsigned bits) {
    for (std::size_t i = 0; i < counts_.size(); ++i) counts_[i] += (bits >> i) & 1U;
  }
  /// The bits that others than one with `bits` have.
  unsigned without(unsigned bits) const {
    unsigned others = 0;
    for (std::size_t i = 0; i < counts_.size(); ++i) {
      if (counts_[i] > ((bits >> i) & 1U)) others |= 1U << i;
    }
    return others;
  }

 private:
  std::array<std::size_t, 32> counts_{};
};

}  // namespace

void check_mjcf_actuators(const MjcfScope& scope, MjcfFacts& facts) {
  for (const xml::Element element : scope.tree.in_sections("actuator")) {
    const std::string_view tag = element.name();
    if (tag == "plugin" || tag == "orientation") continue;
    const MjcfValues values = scope.defaults.values_of_any(
        element, {tag, "general"}, mjcf_class_of(scope, element, MjcfDefaults::kMain));
    std::size_t targets = 0;
    for (const char* target : {"joint", "jointinparent", "tendon", "site", "body", "cranksite"}) {
      targets += element.attribute(target) ? 1 : 0;
    }
    const std::string subject = actuator_named(element);
    if (targets == 0) facts.push_back({MjcfKind::kActuatorNoTarget, element.tag_span(), subject});
    if (targets > 1) facts.push_back({MjcfKind::kActuatorTwoTargets, element.tag_span(), subject});
    const std::string why = no_effect(values);
    if (!why.empty()) {
      facts.push_back({MjcfKind::kActuatorNoEffect, element.tag_span(), subject, {}, why});
    }
    for (const auto& [range, limited] :
         {std::pair{"ctrlrange", "ctrllimited"}, std::pair{"forcerange", "forcelimited"},
          std::pair{"actrange", "actlimited"}}) {
      const std::vector<double> n = values.numbers(range);
      const auto mode = values.text(limited);
      const std::string_view value = mode ? trimmed(mode->text) : "auto";
      const bool on = value == "true" || (value == "auto" && scope.settings.auto_limits);
      if (value == "true" && !values.text(range)) {
        facts.push_back({MjcfKind::kLimitedWithoutRange, mode->span, subject, range});
      }
      if (n.size() != 2) continue;
      const bool empty = n[0] == 0 && n[1] == 0;
      if (on && n[0] >= n[1] && !empty) {
        facts.push_back({MjcfKind::kRangeInverted, values.text(range)->span, subject, range,
                         std::string(trimmed(values.text(range)->text))});
      } else if (!on && !empty && value != "false" && tag != "damper") {
        facts.push_back(
            {MjcfKind::kRangeUnlimited, values.text(range)->span, subject, range, limited});
      } else if (!on && values.own(range) && !empty && value == "false") {
        facts.push_back({MjcfKind::kRangeIgnored, values.text(range)->span, subject, range,
                         std::string(limited) + "=\"false\""});
      }
    }
  }
}

void check_mjcf_keyframes(const MjcfScope& scope, MjcfFacts& facts) {
  if (makes_names(scope)) return;  // their bodies and joints are not counted here
  const StateSize size = state_size(scope);
  for (const xml::Element key : scope.tree.in_sections("keyframe")) {
    for (const auto& [attribute, expected] :
         {std::pair{"qpos", size.positions}, std::pair{"qvel", size.velocities},
          std::pair{"ctrl", size.controls}, std::pair{"mpos", 3 * size.mocaps},
          std::pair{"mquat", 4 * size.mocaps}}) {
      const auto text = attribute_text(key, attribute);
      if (!text) continue;
      const auto numbers = mjcf_numbers(text->text);
      if (!numbers || numbers->size() == expected) continue;
      const bool fewer = numbers->size() < expected;
      facts.push_back({fewer ? MjcfKind::kKeyframeShort : MjcfKind::kKeyframeSize,
                       text->span,
                       {},
                       attribute,
                       std::to_string(numbers->size()) + " numbers, where the model has " +
                           std::to_string(expected)});
    }
  }
}

/// A geom whose bits meet those of no other geom never touches anything. A file that is included beside others
/// meets at least geoms with the bits that MuJoCo gives by default, such as the ground of a scene.
void check_mjcf_contacts(const MjcfScope& scope, MjcfFacts& facts) {
  if (makes_names(scope)) return;
  struct Bits {
    xml::Element element;
    unsigned contype, conaffinity;
  };
  std::vector<Bits> all;
  BitCounts contypes, conaffinities;
  contypes.add(1);  // a geom that names none
  conaffinities.add(1);
  for_each_in_bodies(scope, [&](xml::Element element, std::size_t class_id) {
    if (element.name() != "geom") return;
    const MjcfValues values = scope.defaults.values(element, "geom", class_id);
    const auto bits = [&](const char* name) {
      return static_cast<unsigned>(static_cast<std::int64_t>(values.number(name, 1).value));
    };
    all.push_back({element, bits("contype"), bits("conaffinity")});
    contypes.add(all.back().contype);
    conaffinities.add(all.back().conaffinity);
  });
  for (const Bits& one : all) {
    if (one.contype == 0 && one.conaffinity == 0) continue;
    // No geom touches itself.
    const bool meets = (one.contype & conaffinities.without(one.conaffinity)) != 0 ||
                       (one.conaffinity & contypes.without(one.contype)) != 0;
    if (meets) continue;
    const std::string name = mjcf_name(one.element, "name").value;
    if (!name.empty() && scope.in_pairs.contains(name)) continue;
    facts.push_back({MjcfKind::kNeverTouches,
                     one.element.tag_span(),
                     name.empty() ? std::string() : "geom " + name,
                     {},
                     "contype " + std::to_string(one.contype) + ", conaffinity " +
                         std::to_string(one.conaffinity)});
  }
}

}  // namespace rigor::read
