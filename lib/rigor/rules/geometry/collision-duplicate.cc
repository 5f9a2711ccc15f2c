// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <rigor/rules/edits.h>
#include <rigor/rules/geometry/shape_key.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::collision_duplicate {

/// Equal for shapes that fill the same space.
using Key = std::pair<ShapeKey, std::vector<double>>;

std::optional<Key> place_of(const model::Collision& collision, model::Id<model::Collision> id,
                            Context& context) {
  const auto X_WC = context.frames().pose(id);
  auto shape = shape_key(collision.geometry.shape);
  if (!X_WC || !shape) return std::nullopt;
  const auto& [p, q] = *X_WC;
  return Key{*std::move(shape), {p.x, p.y, p.z, q.w, q.x, q.y, q.z}};
}

void check(const model::Link& link, Context& context) {
  if (link.collisions.size() < 2) return;
  const model::Root& root = context.root();
  std::map<Key, const model::Collision*> seen;
  for (const auto id : link.collisions) {
    const model::Collision& collision = root[id];
    auto key = place_of(collision, id, context);
    if (!key) continue;
    const auto [first, is_new] = seen.emplace(*std::move(key), &collision);
    if (is_new || !root.own(collision.site)) continue;
    const model::Collision& other = *first->second;
    context.report(
        {.where = collision.site.name,
         .message = fmt::format("the link '{}' has the same {} in the same place already{}",
                                link.name.value, model::shape_name(collision.geometry.shape),
                                other.name.value.empty() ? "" : ": '" + other.name.value + "'"),
         .subject = context.subject(collision),
         .related = {{other.site.name, "the first one"}},
         .fix = fix_of("remove it", Applicability::kUnsafe, removed(context, collision.site))});
  }
}

Rule rule() {
  return {
      .name = "collision-duplicate",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "a link has the same collision shape twice in the same place",
      .why = "Both are there: contacts count twice, so they are twice as stiff and cost twice the "
             "time; where the mass is computed from the shapes, it counts twice as well. It was "
             "copied and not moved. The part that the copy was meant for has none.",
      .what_to_do = "Give the copy its own pose and size, or remove it.",
      .checks = {on<model::Link>(check)},
  };
}

}  // namespace rigor::rules::collision_duplicate
