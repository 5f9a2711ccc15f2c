// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include <fmt/core.h>

#include <rigor/rules/inertia/inertial_fix.h>
#include <rigor/rules/inertia/solid_body.h>
#include <rigor/rules/inertia/tensor.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/schema/misspelt.h>

namespace rigor::rules::inertial_missing {

/// What the shapes would have in place of the 1 kg·m²; empty when they have no closed form.
std::string comparison(const model::Link& link, Context& context) {
  auto solid = solid_of_all(link, mass::From::kCollisions, context);
  if (!solid) solid = solid_of_all(link, mass::From::kVisuals, context);
  if (!solid || !(solid->mass > 0)) return {};
  const mass::Inertia& tensor = solid->about_com;
  const double most = std::max({tensor.ixx, tensor.iyy, tensor.izz}) / solid->mass;
  return fmt::format("as a solid of 1 kg its shapes have at most {:.3g} kg·m², {:.3g} times {}",
                     most, most < 1 ? 1 / most : most, most < 1 ? "less" : "more");
}

// Boxes half a meter wide that lie about in worlds turn thirty times as hard as they should, and
// no effect shows: no motor turns them.
constexpr double kUnnoticed = 100;

/// Whether a ball of three meters is near enough, or there is nothing that could be touched.
bool may_be_meant(const model::Link& link, const model::Model& model, Context& context) {
  if (link.collisions.empty()) return true;
  const auto share = share_of_solid(link, 1, mass::Inertia{1, 0, 0, 1, 0, 1}, context);
  if (!share) return false;
  const double times = std::max(*share, 1 / *share);
  return model.joints.empty() ? times < kUnnoticed : plausible(*share);
}

/// The links that joints of the model fix to the world: whatever they weigh, they stay.
std::set<model::Id<model::Link>> anchored_links(const model::Model& model, Context& context) {
  std::set<model::Id<model::Link>> anchored;
  for (const auto id : model.joints) {
    const auto& ends = context.frames().ends(id);
    if (context.root()[id].type != model::JointType::kFixed || !ends.parent_is_world) continue;
    if (ends.child) anchored.insert(ends.child);
  }
  return anchored;
}

void report(const model::Link& link, Context& context) {
  if (misspelt_child(link.site, "inertial", context)) return;  // unknown-element
  context.report(
      {.where = link.site.name,
       .message =
           "the link '" + link.name.value +
           "' has no <inertial>: it is taken to be 1 kg with a moment of 1 kg·m² about every axis",
       .subject = context.subject(link),
       .help = comparison(link, context),
       .fix = fix_from_shapes(link, context),
       .cause = std::string("links of ").append(context.sources().path(link.site.span.source))});
}

void check(const model::Model& model, Context& context) {
  const model::Root& root = context.root();
  // Where other links have masses, or need them, one without was forgotten.
  bool reported = std::any_of(model.links.begin(), model.links.end(),
                              [&](const auto id) { return root[id].inertial.written; });
  const auto anchored = anchored_links(model, context);
  std::vector<const model::Link*> without;
  for (const auto id : model.links) {
    const model::Link& link = root[id];
    if (anchored.count(id) > 0) continue;
    if (link.inertial.written || !root.own(link.site) || !is_dynamic(link, context)) continue;
    without.push_back(&link);
    reported = reported || !may_be_meant(link, model, context);
  }
  if (!reported) return;
  for (const model::Link* link : without) report(*link, context);
}

Rule rule() {
  return {
      .name = "inertial-missing",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .fix = FixGrade::kUnsafe,
      .summary = "a link that moves has no <inertial>",
      .why = "SDF takes 1 kg and the identity as its tensor, as of a ball more than three meters "
             "across. Joints on it move like in honey, and what rests on it is thrown about.",
      .what_to_do = "`rigor inertia MODEL --mass LINK=KG --write` computes the tensor from the "
                    "link's shapes and meshes, and writes it; without a mass it takes that of "
                    "water. If the link never moves, make the model static.",
      .checks = {on<model::Model>(check)},
  };
}

}  // namespace rigor::rules::inertial_missing
