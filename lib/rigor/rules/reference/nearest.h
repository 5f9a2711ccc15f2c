// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// "Did you mean", as a line of help and a fix.

#pragma once

#include <concepts>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_set>
#include <utility>
#include <vector>

#include <rigor/model/frames.h>
#include <rigor/rules/context.h>
#include <rigor/schema/suggest.h>
#include <rigor/text/edit.h>

namespace rigor::rules {

/// The finding with what the name that is at its place was probably meant to be: "did you mean 'tip'?".
/// There is a fix only where one candidate is near, and the name is written there as it is read. What
/// refers to another thing is another robot: the author has to agree.
inline Finding with_nearest(Finding finding, std::string_view name,
                            const std::vector<std::string>& candidates, const Context& context) {
  finding.cause = name;
  std::vector<std::string_view> others;  // the name itself may be there for something else
  for (const std::string& candidate : candidates) {
    if (candidate != name) others.emplace_back(candidate);
  }
  const auto near = schema::near(name, others);
  if (near.empty()) return finding;
  const std::string meant(near.front());
  finding.help = "did you mean '" + meant + "'?";
  const bool plain = meant.find_first_of("<>&\"'") == std::string::npos;
  if (near.size() == 1 && plain && context.bytes(finding.where) == name) {
    finding.fix = Fix{"name '" + meant + "'", Applicability::kUnsafe, {{finding.where, meant}}};
  }
  return finding;
}

/// The same of what `candidates()` gives, as long as the file is worth the effort.
template <std::invocable Candidates>
Finding with_nearest(Finding finding, std::string_view name, const Candidates& candidates,
                     Context& context) {
  finding.cause = name;
  if (!context.may_suggest()) return finding;
  const std::vector<std::string> names = candidates();
  context.compared(names.size());
  return with_nearest(std::move(finding), name, names, context);
}

/// Where several joints name what does not exist, and none names the link that is near, the link's own name is the
/// one that is wrong: its place. Nothing otherwise.
inline std::optional<Span> misnamed_link(std::string_view missing, std::string_view near,
                                         const Context& context) {
  constexpr std::size_t kSeveral = 2;
  const model::Root& root = context.root();
  std::size_t of_missing = 0;
  for (const model::Joint& joint : root.joints) {
    for (const std::string* end : {&joint.parent.value, &joint.child.value}) {
      if (*end == near) return std::nullopt;
      of_missing += *end == missing ? 1 : 0;
    }
  }
  if (of_missing < kSeveral) return std::nullopt;
  for (const model::Link& link : root.links) {
    if (link.name.value == near && root.own(link.site) && context.bytes(link.name.span) == near)
      return link.name.span;
  }
  return std::nullopt;
}

/// Of a name that is undefined.
inline Finding unresolved(const model::FrameProblem& problem, std::string message,
                          const Context& context) {
  Finding finding = with_nearest(
      {.where = problem.where, .message = std::move(message), .subject = problem.subject},
      problem.name, problem.candidates, context);
  if (!finding.fix) return finding;
  const std::string& near = finding.fix->edits.front().text;
  if (const auto link = misnamed_link(problem.name, near, context)) {
    finding.help +=
        " Several joints name '" + problem.name + "', and none the link '" + near + "'.";
    finding.fix = Fix{"rename the link", Applicability::kUnsafe, {{*link, problem.name}}};
  }
  return finding;
}

/// The names of links, joints or whatever else has one.
template <class Entities>
std::vector<std::string> names_of(const Entities& entities) {
  std::vector<std::string> names;
  for (const auto& entity : entities) names.push_back(entity.name.value);
  return names;
}

/// The same, to look up in: views into the entities' own strings.
template <class Entities>
std::unordered_set<std::string_view> name_set(const Entities& entities) {
  std::unordered_set<std::string_view> names;
  for (const auto& entity : entities) names.insert(entity.name.value);
  return names;
}

}  // namespace rigor::rules
