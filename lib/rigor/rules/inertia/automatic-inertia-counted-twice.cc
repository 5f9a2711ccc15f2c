// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstdint>

#include <fmt/core.h>

#include <rigor/mass/link_body.h>
#include <rigor/rules/inertia/automatic.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::automatic_inertia_counted_twice {

// Shapes that share less than this part of the smaller are put together as people do.
constexpr double kJoined = 0.2;

// Each pair is compared, by some thousand points.
constexpr std::size_t kMaxShapes = 24;

void check(const model::Link& link, Context& context) {
  if (!is_computed(link, context)) return;
  if (link.collisions.size() < 2 || link.collisions.size() > kMaxShapes) return;
  const model::Root& root = context.root();
  const model::Id<model::Link> id{static_cast<std::uint32_t>(&link - root.links.data())};
  const mass::PartOverlap* worst = nullptr;
  const auto overlaps = mass::overlaps_in(root, context.frames(), id, mass::From::kCollisions);
  for (const mass::PartOverlap& overlap : overlaps.list) {
    if (overlap.share >= kJoined && (!worst || overlap.share > worst->share)) worst = &overlap;
  }
  if (worst == nullptr) return;
  const model::Collision& first = root[link.collisions[worst->first]];
  const model::Collision& second = root[link.collisions[worst->second]];
  context.report(
      {.where = second.site.name,
       .message = fmt::format("the collisions '{}' and '{}' share {:.0f} % of the smaller "
                              "one's volume, and its mass is counted in both",
                              first.name.value, second.name.value, 100 * worst->share),
       .subject = context.subject(link),
       .related = {{first.site.name, "the other collision"}}});
}

Rule rule() {
  return {
      .name = "automatic-inertia-counted-twice",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .summary = "collisions of a link with an automatic inertial overlap",
      .why = "libsdformat adds up the collisions as separate bodies, so what two of them share "
             "weighs twice.",
      .what_to_do =
          "Let the collisions touch instead of overlap, or give one of them a smaller <density>.",
      .checks = {on<model::Link>(check)},
  };
}

}  // namespace rigor::rules::automatic_inertia_counted_twice
