// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/schema/gazebo_content.h>
#include <rigor/schema/schema.h>
#include <rigor/schema/suggest.h>

namespace rigor::rules::gazebo_element_unknown {

bool knows(const schema::Node& parent, std::string_view name) {
  return parent.child(name) || parent.child_in_other_version(name);
}

/// What Gazebo read before it had SDF, and libsdformat does not: no slip of what is read now.
bool is_former(std::string_view name) { return name == "stopKp" || name == "stopKd"; }

/// Of `mu`, which is too short to be near anything: mu1 and mu2.
std::vector<std::string_view> meant(std::string_view name,
                                    const std::vector<schema::Node>& parents) {
  std::vector<std::string_view> known;
  for (const GazeboKey& key : kGazeboKeys) known.push_back(key.name);
  for (const schema::Node& parent : parents) {
    for (const schema::Node child : parent.children()) known.push_back(child.name());
  }
  auto near = schema::near(name, known);
  if (!near.empty()) return near;
  for (const std::string_view other : known) {
    if (other.size() == name.size() + 1 && other.starts_with(name)) near.push_back(other);
  }
  return near;
}

/// Whether the first is nearer than the second: of `mu` no one is.
bool is_nearest(const std::vector<std::string_view>& near, std::string_view name) {
  constexpr std::size_t kMax = 2;  // edits of what is near
  if (near.size() < 2) return !near.empty();
  return schema::edit_distance(name, near[0], kMax) < schema::edit_distance(name, near[1], kMax);
}

void check(const model::GazeboBlock& block, Context& context) {
  const auto parents = parents_of_copied(block, context);
  if (parents.empty()) return;
  for (const model::Parameter& child : block.content) {
    const std::string_view name = child.name;
    const bool foreign = name.find(':') != std::string_view::npos;
    if (foreign || gazebo_key(name)) continue;
    if (std::any_of(parents.begin(), parents.end(),
                    [name](const schema::Node& parent) { return knows(parent, name); })) {
      continue;
    }
    Finding finding{.where = child.site.name,
                    .message = "<" + std::string(name) + "> in a <gazebo> block of a " +
                               std::string(parents.front().name()) + " has no effect"};
    const auto near = is_former(name) ? std::vector<std::string_view>() : meant(name, parents);
    for (const std::string_view other : near) {
      finding.help +=
          (finding.help.empty() ? "did you mean <" : " or <") + std::string(other) + ">";
    }
    if (!near.empty()) finding.help += "?";
    if (is_former(name)) {
      finding.help = "remove it: the stops of a joint have <stopErp> and <stopCfm>, in other units";
      finding.why = "Gazebo read it before it had SDF; libsdformat and Gazebo ignore it today.";
    }
    if (is_nearest(near, name) && find(block.content, near.front()) == nullptr) {
      finding.fix = fix_of("write <" + std::string(near.front()) + ">", Applicability::kUnsafe,
                           renamed(context, child.site, near.front()));
    }
    context.report(std::move(finding));
  }
}

Rule rule() {
  return {
      .name = "gazebo-element-unknown",
      .severity = Severity::kWarning,
      .formats = Formats::kUrdf,
      .fix = FixGrade::kUnsafe,
      .summary = "an element of a <gazebo> block that neither the converter nor SDF knows",
      .why = "libsdformat converts a list of names to SDF (mu1, kp, selfCollide, turnGravityOff, "
             "…) and copies every other element as it is into the link, the joint or the model. "
             "Gazebo ignores what SDF does not know there, so a slip in a name is lost silently.",
      .what_to_do = "Write the name that was meant; letter case counts.",
      .checks = {on<model::GazeboBlock>(check)},
  };
}

}  // namespace rigor::rules::gazebo_element_unknown
