// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <rigor/robot/assembled/twins.h>
#include <rigor/rules/assembly/attachment.h>
#include <rigor/rules/assembly/placement_slips.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::links_in_one_place {

using model::Vector3;

// Of the diagonal: nearer, two boxes are the same.
constexpr double kSame = 0.02;

// m: smaller ones mark frames, which may well be in one place.
constexpr double kBody = 0.03;

bool are_same(const mesh::Bounds& a, const mesh::Bounds& b) {
  const double apart = std::max(length(a.min - b.min), length(a.max - b.max));
  return apart < kSame * mesh::diagonal(a);
}

bool is_twin(const std::string& a, const std::string& b, robot::Side side) {
  const std::vector<std::string> names = robot::mirrored_names(a, side);
  return std::find(names.begin(), names.end(), b) != names.end();
}

/// The same size as the pose of the link's twin on the other side, but for signs.
bool mirrors_twin(const Attached& one, const Vector3& value, const std::vector<Attached>& all,
                  Context& context) {
  const model::Root& root = context.root();
  const std::string& name = root.links[one.unit.link].name.value;
  return std::any_of(all.begin(), all.end(), [&](const Attached& other) {
    const std::string& theirs = root.links[other.unit.link].name.value;
    if (!is_twin(name, theirs, robot::Side::kAcross)) return false;
    const Vector3& there = other.unit.pose->pose.value.translation;
    constexpr double kNear = 1e-6;  // m
    return std::abs(there.x - value.x) < kNear && std::abs(there.z - value.z) < kNear &&
           std::abs(there.y + value.y) < kNear;
  });
}

struct Way {
  const Attached* link = nullptr;
  Undone change;
  bool confirmed = false;  ///< by the twin on the other side
};

/// A sign that brings one of the two to where nothing else is, and joined as well as before.
std::optional<Way> way_out(const Attached& one, const Attached& other,
                           const std::vector<Attached>& all, Context& context) {
  std::optional<Way> found;
  for (const Attached* link : {&one, &other}) {
    const Vector3& written = link->unit.pose->pose.value.translation;
    for (Undone& change : placement_slips(written)) {
      // Signs and exchanges.
      if (length(written) == 0 || std::abs(length(change.value) - length(written)) > 1e-9) continue;
      const Fit then =
          fit_of(*link, shift_of(link->unit.pose->pose.value, link->unit.X_WL, change.value));
      constexpr double kFree = 0.5;  // of the link that is within others
      std::vector<robot::OrientedBox> still = link->parent;
      still.insert(still.end(), link->others.begin(), link->others.end());
      const Vector3 moved = shift_of(link->unit.pose->pose.value, link->unit.X_WL, change.value);
      if (share_inside(*link, moved, still) > kFree || then.gap > link->fit.gap + 1e-9) continue;
      const bool confirmed = mirrors_twin(*link, change.value, all, context);
      if (found && (found->confirmed || !confirmed)) continue;
      found = Way{link, std::move(change), confirmed};
    }
  }
  return found;
}

void report(const Attached& one, const Attached& other, const std::vector<Attached>& all,
            Context& context) {
  const model::Root& root = context.root();
  const auto way = way_out(one, other, all, context);
  if (!way) return;
  const Attached& wrong = *way->link;
  const Attached& right = way->link == &one ? other : one;
  const model::Link& link = root.links[wrong.unit.link];
  context.report(
      {.where = place_of(*wrong.unit.pose, context),
       .message = fmt::format("link '{}' is in the same place as link '{}', and as large",
                              link.name.value, root.links[right.unit.link].name.value),
       .subject = wrong.unit.joint ? context.subject(*wrong.unit.joint) : context.subject(link),
       .related = {{place_of(*right.unit.pose, context), "where the other is placed"}},
       .help = fmt::format("with {} it is where nothing else is: {}", written_as(way->change.value),
                           way->change.slip),
       .fix = translation_fix(*wrong.unit.pose, way->change.value, context),
       // Fins that cross have one box around them.
       .severity = way->confirmed ? std::nullopt : std::optional(Severity::kInfo)});
}

using LinkPair = std::pair<std::uint32_t, std::uint32_t>;

/// Two that move, as large as each other, in one place. Of a left and a right one twins-in-one-place speaks.
std::vector<LinkPair> pairs_in_one_place(const model::Root& root, const robot::Assembled& robot) {
  struct Body {
    std::uint32_t link;
    mesh::Bounds box;
  };
  std::vector<Body> bodies;
  for (std::uint32_t i = 0; i < robot.links.size(); ++i) {
    const robot::AssembledLink& link = robot.links[i];
    if (!link.carrier || root[link.carrier].type == model::JointType::kFixed) continue;
    const auto box = robot.bounds_W({i});
    if (box && mesh::diagonal(*box) >= kBody) bodies.push_back({i, *box});
  }
  std::vector<LinkPair> pairs;
  constexpr std::size_t kMaxBodies = 500;
  if (bodies.size() > kMaxBodies) return pairs;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    for (std::size_t j = i + 1; j < bodies.size(); ++j) {
      const std::uint32_t a = bodies[i].link, b = bodies[j].link;
      if (!are_same(bodies[i].box, bodies[j].box) || robot.links[a].top != robot.links[b].top)
        continue;
      if (!is_twin(root.links[a].name.value, root.links[b].name.value, robot::Side::kAcross))
        pairs.emplace_back(a, b);
    }
  }
  return pairs;
}

void check(const model::Root& root, Context& context) {
  if (root.links.size() < 3 || !context.frames().problems().empty()) return;
  const std::vector<LinkPair> pairs = pairs_in_one_place(root, context.assembled());
  if (pairs.empty()) return;
  const std::vector<Attached> all = AttachedLinks(context).find();
  const auto attached = [&all](std::uint32_t link) {
    return std::find_if(all.begin(), all.end(),
                        [link](const Attached& one) { return one.unit.link == link; });
  };
  const auto carrier = [&](std::uint32_t link) {
    return context.frames().ends(context.assembled().links[link].carrier).parent.value;
  };
  for (const auto& [a, b] : pairs) {
    // A talus within its foot.
    if (carrier(a) == b || carrier(b) == a) continue;
    // What two links in one place carry is in one place with them.
    const LinkPair carriers = std::minmax(carrier(a), carrier(b));
    if (std::find(pairs.begin(), pairs.end(), carriers) != pairs.end()) continue;
    const auto one = attached(a), other = attached(b);
    if (one != all.end() && other != all.end()) report(*one, *other, all, context);
  }
}

Rule rule() {
  return {
      .name = "links-in-one-place",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "two links of one size are in the same place",
      .why = "Two legs or wheels are in each other, and where one should be there is none: the "
             "robot falls over. The boxes around the two are the same, both links move, and one "
             "is where nothing else is once a sign is changed, or two coordinates are exchanged. "
             "Where it is not the mirror image of its "
             "twin then, it is an info.",
      .what_to_do = "Put the sign right. `rigor inspect --assembled` prints where the links are.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::links_in_one_place
