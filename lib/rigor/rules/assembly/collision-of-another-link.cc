// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <fmt/core.h>

#include <rigor/robot/assembled/twins.h>
#include <rigor/rules/assembly/seen_shapes.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::collision_of_another_link {

// Boxes that are so much alike are of one shape; less alike, of two.
constexpr double kSame = 0.93;
constexpr double kOther = 0.5;

// As much as a robot's other collisions are like their visuals, most of them at least.
constexpr double kFits = 0.7;

/// A link with one collision and one visual.
struct Dressed {
  std::uint32_t link = 0;
  SeenShape collision;
  SeenShape visual;
  double fit = 0;
};

std::vector<Dressed> dressed_links(const model::Root& root, Context& context) {
  std::vector<Dressed> result;
  for (std::uint32_t i = 0; i < root.links.size(); ++i) {
    const model::Link& link = root.links[i];
    if (link.collisions.size() != 1 || link.visuals.size() != 1) continue;
    const std::vector<SeenShape> shapes = seen_shapes(i, context);
    if (shapes.size() != 2) continue;
    result.push_back(
        {i, shapes[0], shapes[1], robot::likeness(shapes[0].bounds_L, shapes[1].bounds_L)});
  }
  return result;
}

bool are_twins(const std::string& a, const std::string& b) {
  for (const robot::Side side : {robot::Side::kAcross, robot::Side::kAlong}) {
    const std::vector<std::string> names = robot::mirrored_names(a, side);
    if (std::find(names.begin(), names.end(), b) != names.end()) return true;
  }
  return false;
}

/// The one other link, or pair of twins, whose collision this one has. Its own twin and families of like
/// parts, as rotors, have the same rightly: then it is the visual that is odd.
const Dressed* owner(const Dressed& link, const std::vector<Dressed>& all,
                     const model::Root& root) {
  // Boxes of a centimeter mark frames, and are alike everywhere.
  constexpr double kToken = 0.03;  // m
  if (link.fit > kOther || mesh::diagonal(link.collision.bounds_L) < kToken) return nullptr;
  const Dressed* found = nullptr;
  for (const Dressed& other : all) {
    if (other.link == link.link || other.fit < kFits) continue;
    if (size_likeness(link.collision.shape->bounds_S, other.collision.shape->bounds_S) < kSame)
      continue;
    if (size_likeness(link.visual.bounds_L, other.visual.bounds_L) > kOther) continue;
    const std::string& name = root.links[other.link].name.value;
    if (are_twins(root.links[link.link].name.value, name)) return nullptr;
    if (found && !are_twins(root.links[found->link].name.value, name)) return nullptr;
    found = &other;
  }
  return found;
}

void check(const model::Root& root, Context& context) {
  constexpr std::size_t kFewest = 3;
  if (root.links.size() < kFewest) return;
  const std::vector<Dressed> all = dressed_links(root, context);
  std::size_t fitting = 0;
  for (const Dressed& link : all) fitting += link.fit > kFits ? 1 : 0;
  if (fitting < kFewest || 2 * fitting < all.size()) return;
  for (const Dressed& link : all) {
    if (!root.own(root.links[link.link].site)) continue;
    const Dressed* other = owner(link, all, root);
    if (other == nullptr) continue;
    const model::Collision& collision = root.collisions[link.collision.shape->index];
    context.report(
        {.where = collision.geometry.site.name,
         .message = fmt::format(
             "the collision shares {:.0f} % with the visual: its shape is that of link '{}'",
             100 * link.fit, root.links[other->link].name.value),
         .subject = context.subject(collision),
         .related = {{link.visual.geometry->site.name, "the visual of this link"}}});
  }
}

Rule rule() {
  return {
      .name = "collision-of-another-link",
      .severity = Severity::kWarning,
      .summary = "a link has the collision shape of another link",
      .why = "The link touches what it does not reach, and passes through what it hits. Its "
             "collision is not where its visual is, and has the shape of another link's, which "
             "fits there; the robot's other collisions fit their visuals. Mostly a block was "
             "copied and not changed. Shapes are compared as boxes.",
      .what_to_do = "Give the collision the shape of its own link's visual, or one around it.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::collision_of_another_link
