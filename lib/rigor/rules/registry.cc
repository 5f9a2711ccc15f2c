// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/registry.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/registered.h>

namespace rigor::rules {
namespace {

struct Renamed {
  std::string_view former;
  std::string_view current;
};

constexpr Renamed kRenamed[] = {
    {"convert-effort-stand-in", "convert-effort-unlimited"},
    {"convert-limit-stand-in", "convert-limit-unlimited"},
    {"convert-refused", "convert-rejected"},
    {"convert-turned", "convert-joint-swapped"},
    {"convert-velocity-stand-in", "convert-velocity-unlimited"},
    {"friction-direction-turns", "friction-direction-rotates"},
    {"inertia-refused", "inertia-rejected"},
    {"inertia-turned-by-pose", "inertia-rotated-by-pose"},
    {"limit-looks-like-millimetres", "limit-looks-like-millimeters"},
    {"limit-stands-for-none", "limit-used-as-unlimited"},
    {"mimic-refused-by-ros2-control", "mimic-rejected-by-ros2-control"},
    {"simulate-cause-wheel-off-centre", "simulate-cause-wheel-off-center"},
    {"simulate-engine-refused", "simulate-engine-rejected"},
    {"simulate-restless", "simulate-residual-velocity"},
    {"simulate-weight-not-borne", "simulate-ground-reaction-missing"},
    {"waypoint-time-not-rising", "waypoint-time-not-increasing"},
};

}  // namespace

std::string_view to_string(Category category) {
  constexpr std::array<std::string_view, 20> kNames{
      "xml",      "schema",   "naming",      "reference", "frame",    "inertia", "kinematics",
      "geometry", "mesh",     "physics",     "world",     "plugin",   "sensor",  "package",
      "convert",  "simulate", "suppression", "xacro",     "assembly", "mjcf"};
  static_assert(kNames.size() == static_cast<std::size_t>(Category::kMjcf) + 1);
  return kNames[static_cast<std::size_t>(category)];
}

bool needs_meshes(const Rule& rule) {
  constexpr std::array<Category, 3> kOfShapes{Category::kMesh, Category::kInertia,
                                              Category::kAssembly};
  if (std::find(kOfShapes.begin(), kOfShapes.end(), rule.category) != kOfShapes.end()) return true;
  using Kind = read::MjcfFactKind;
  return std::any_of(rule.checks.begin(), rule.checks.end(), [](const Check& check) {
    const auto* const facts = std::get_if<FactCheck<read::MjcfFact, Kind>>(&check);
    return facts != nullptr && std::find(facts->kinds.begin(), facts->kinds.end(),
                                         Kind::kFlexSurface) != facts->kinds.end();
  });
}

Registry::Registry() {
  std::vector<Rule> rules = registered_rules();
  std::vector<Rule*> sorted;
  sorted.reserve(rules.size());
  for (Rule& rule : rules) sorted.push_back(&rule);
  std::sort(sorted.begin(), sorted.end(),
            [](const Rule* a, const Rule* b) { return a->name < b->name; });
  rules_.reserve(rules.size());
  for (Rule* rule : sorted) rules_.push_back(std::move(*rule));
}

std::string_view current_name(std::string_view name) {
  const auto* const renamed =
      std::find_if(std::begin(kRenamed), std::end(kRenamed),
                   [name](const Renamed& rule) { return rule.former == name; });
  return renamed == std::end(kRenamed) ? name : renamed->current;
}

std::vector<std::string_view> former_names() {
  std::vector<std::string_view> names;
  for (const Renamed& rule : kRenamed) names.push_back(rule.former);
  return names;
}

const Rule* Registry::find(std::string_view name) const {
  name = current_name(name);
  const auto found = std::lower_bound(
      rules_.begin(), rules_.end(), name,
      [](const Rule& rule, std::string_view wanted) { return rule.name < wanted; });
  return found != rules_.end() && found->name == name ? &*found : nullptr;
}

}  // namespace rigor::rules
