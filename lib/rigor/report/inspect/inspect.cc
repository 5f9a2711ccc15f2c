// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/inspect/inspect.h>

#include <rigor/mass/total.h>

namespace rigor::report {
namespace {

using model::Id;

std::string seen_from(const model::Root& root, Id<model::Model> scope, Id<model::Link> link) {
  const std::string name = scoped_name(root, link);
  const std::string prefix = scope ? scoped_name(root, scope) + "::" : "";
  return name.starts_with(prefix) ? name.substr(prefix.size()) : name;
}

void count(const model::Root& root, Id<model::Model> id, Totals& sum) {
  const model::Model& model = root[id];
  sum.links += model.links.size();
  sum.joints += model.joints.size();
  for (const Id<model::Link> link : model.links) {
    sum.collisions += root[link].collisions.size();
    sum.visuals += root[link].visuals.size();
  }
  for (const Id<model::Model> nested : model.models) count(root, nested, sum);
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
  count(inspection.root, model, sum);
  const auto body_of = [&inspection](Id<model::Link> link) {
    return inspection.inertial(link).body;
  };
  const mass::Total robot = mass::total(inspection.root, inspection.frames, model, body_of);
  sum.mass = robot.mass;
  if (robot.body && robot.body->mass > 0) sum.com = robot.body->com;
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
