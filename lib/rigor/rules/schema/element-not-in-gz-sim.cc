// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <string>
#include <string_view>

#include <rigor/rules/rule.h>

namespace rigor::rules::element_not_in_gz_sim {

struct Ignored {
  std::string_view name;
  std::string_view parent;
  std::string_view effect;
};

constexpr Ignored kIgnored[] = {
    {"audio_sink", "link", "nothing is heard"},
    {"audio_source", "link", "nothing is heard"},
    {"gripper", "model", "nothing is held"},
    {"population", "world", "its models are not there"},
    {"road", "world", "it is not drawn"},
    {"state", "world", "models begin where their <pose> says"},
};

void check(const model::Root& /*root*/, Context& context) {
  const xml::Document& document = context.document();
  for (std::uint32_t i = 0; i < document.element_count(); ++i) {
    const xml::Element element = document.element(i);
    const auto is_it = [&element](const Ignored& one) { return one.name == element.name(); };
    const auto found = std::find_if(std::begin(kIgnored), std::end(kIgnored), is_it);
    if (found == std::end(kIgnored)) continue;
    const auto parent = element.parent();
    if (!parent || parent->name() != found->parent) continue;
    context.report({.where = element.name_span(),
                    .message = "gz-sim passes over <" + std::string(found->name) +
                               ">: " + std::string(found->effect)});
  }
}

Rule rule() {
  return {
      .name = "element-not-in-gz-sim",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .targets = {Target::kGzSim},
      .summary = "an element that only Gazebo classic acts on",
      .why = "libsdformat accepts populations, roads, grippers, sound and saved states, and gives "
             "none of them to the simulator: gz-sim makes nothing of them, and says nothing.",
      .what_to_do = "Write out the models of a <population>, and the poses of a <state> into the "
                    "models. A road can be a mesh; what grips is a DetachableJoint system.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::element_not_in_gz_sim
