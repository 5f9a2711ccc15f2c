// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a model is once everything is resolved, in four shapes.
//
//   Inspection inspection{"arm.sdf", loaded.root, frames};
//   std::fputs(inspect_text(inspection).c_str(), stdout);

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <rigor/mass/resolve.h>
#include <rigor/model/frames.h>
#include <rigor/model/model.h>

namespace rigor::report {

struct Inspection {
  std::string path;
  const model::Root& root;
  const model::Frames& frames;
  mass::FindMesh find_mesh = {};  ///< for automatic inertials; without one they are unknown

  mass::Resolved inertial(model::Id<model::Link> link) const {
    return mass::resolve(root, frames, link, find_mesh);
  }
};

/// A tree for people. What the file does not say is marked `(default)`.
std::string inspect_text(const Inspection& inspection);

/// The same for programs. Infinite numbers, and poses that a frame problem hides, are null.
std::string inspect_json(const Inspection& inspection);

/// A row for each entity that has a pose: kind, scoped name, x y z qw qx qy qz, extra; with tabs
/// between, numbers of 12 significant digits. In names a space is `\s`, a tab `\t`, a line break
/// `\n`, a backslash `\\`. What cannot be said of a joint is `-` for a link, `nan` for an axis.
std::string inspect_tsv(const Inspection& inspection);

/// The kinematic graph for Graphviz: links are nodes, joints edges from parent to child.
std::string inspect_dot(const Inspection& inspection);

/// Models that stand in no other one, in file order.
std::vector<model::Id<model::Model>> top_models(const model::Root& root);

/// A model with all that is nested in it.
struct Totals {
  std::size_t links = 0;
  std::size_t joints = 0;
  std::size_t collisions = 0;
  std::size_t visuals = 0;
  double mass = 0;  ///< kg, as a consumer takes it
  /// m, in the frame of the poses; nothing without mass, or when a link has no pose.
  std::optional<model::Vector3> com;
};

Totals totals(const Inspection& inspection, model::Id<model::Model> model);

/// What a joint's end resolves to: a link's name as seen from the joint's model, or `world`; nothing
/// when it resolves to none.
std::optional<std::string> parent_name(const Inspection& inspection, model::Id<model::Joint> joint);
std::optional<std::string> child_name(const Inspection& inspection, model::Id<model::Joint> joint);

}  // namespace rigor::report
