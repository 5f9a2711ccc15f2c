// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Links of one model that are in each other at the start, and no neighbors: pairs that an engine
// which lets a model's links collide pushes apart. Boxes, spheres, cylinders and the like; no meshes.
//
//   for (const auto& [top, pairs] : overlapping_links(root, frames)) …

#pragma once

#include <map>
#include <vector>

#include <rigor/model/frames.h>
#include <rigor/model/model.h>

namespace rigor::robot {

struct LinkOverlap {
  const model::Collision* a;
  const model::Collision* b;
  double depth;  ///< m, diameter of the ball that fits into both
};

/// By outermost model, the pairs of links, each with its deepest shapes, in the order of the file.
using LinkOverlaps = std::map<model::Id<model::Model>, std::vector<LinkOverlap>>;

LinkOverlaps overlapping_links(const model::Root& root, const model::Frames& frames);

/// Those that overlap at the start as well as where all joints are within their limits.
LinkOverlaps lasting_overlaps(const model::Root& root, const model::Frames& frames);

}  // namespace rigor::robot
