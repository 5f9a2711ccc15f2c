// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/inspect.h>

#include <rigor/mass/resolve.h>

namespace rigor::report {
namespace {

using model::Id;

std::string seen_from(const model::Root& root, Id<model::Model> scope, Id<model::Link> link) {
  const std::string name = scoped_name(root, link);
  const std::string prefix = scope ? scoped_name(root, scope) + "::" : "";
  return name.starts_with(prefix) ? name.substr(prefix.size()) : name;
}

/// Adds a model's links up; `body` is lost when one of them has no pose.
void add_up(const Inspection& inspection, Id<model::Model> id, Totals& sum,
            std::optional<mass::MassProperties>& body) {
  const model::Model& model = inspection.root[id];
  sum.links += model.links.size();
  sum.joints += model.joints.size();
  for (const Id<model::Link> link : model.links) {
    sum.collisions += inspection.root[link].collisions.size();
    sum.visuals += inspection.root[link].visuals.size();
    const mass::MassProperties own = mass::resolve(inspection.root, link);
    sum.mass += own.mass;
    const std::optional<model::Pose> X_WL = inspection.frames.pose(link);
    if (!X_WL) body.reset();
    if (body) body = mass::add(*body, mass::transformed(*X_WL, own));
  }
  for (const Id<model::Model> nested : model.models) add_up(inspection, nested, sum, body);
}

}  // namespace

std::vector<Id<model::Model>> top_models(const model::Root& root) {
  std::vector<Id<model::Model>> models;
  for (std::uint32_t i = 0; i < root.models.size(); ++i) {
    if (!root.models[i].parent) models.push_back({i});
  }
  return models;
}

Totals totals(const Inspection& inspection, Id<model::Model> model) {
  Totals sum;
  std::optional<mass::MassProperties> body = mass::MassProperties{};
  add_up(inspection, model, sum, body);
  if (body && body->mass > 0) sum.com = body->com;
  return sum;
}

std::optional<std::string> parent_name(const Inspection& inspection, Id<model::Joint> joint) {
  const model::Frames::Ends& ends = inspection.frames.ends(joint);
  if (ends.parent_is_world) return "world";
  if (!ends.parent) return std::nullopt;
  return seen_from(inspection.root, inspection.root[joint].model, ends.parent);
}

std::optional<std::string> child_name(const Inspection& inspection, Id<model::Joint> joint) {
  const model::Frames::Ends& ends = inspection.frames.ends(joint);
  if (!ends.child) return std::nullopt;
  return seen_from(inspection.root, inspection.root[joint].model, ends.child);
}

}  // namespace rigor::report
