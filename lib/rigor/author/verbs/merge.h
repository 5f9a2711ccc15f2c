// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Two models in one file: side by side in a world (SDF), or as one robot with a common root (URDF).
//
//   const MergedWorld world = merged_world(*left, *right, {.out = "cell.sdf", .X_WB = X});
//   if (world.holds()) write("cell.sdf", world.text);
//
//   const Change change = merged_robot(reader, *left, *right, {.root = "table"});
//
// A world is a text of its own: the models are copied with their bytes, or included. It is read again, and each of its
// models held against the one that it was made of.

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <rigor/author/verbs/attach.h>
#include <rigor/author/verbs/change.h>
#include <rigor/model/pose.h>

namespace rigor::author {

enum class WorldParts : std::uint8_t { kCopied, kIncluded };

struct WorldRequest {
  std::string out;                  ///< the world's path: paths in it are relative to its folder
  std::string name;                 ///< of the world; empty: those of both models
  std::optional<model::Pose> X_WB;  ///< of the second model; where its file puts it when absent
  WorldParts parts = WorldParts::kCopied;
};

struct MergedWorld {
  std::string text;
  std::vector<std::string> names;  ///< of the two models in the world
  std::vector<robot::Difference>
      unasked;                     ///< of the models that were expected and those in the world
  std::vector<std::string> notes;  ///< what is left to the author, a line each
  std::string refused;             ///< why there is no text, as the end of a sentence

  bool holds() const { return refused.empty() && unasked.empty(); }
};

/// A second model with the name of the first gets a number. Copied models are of one version of SDF. Where the first one
/// is in a world, the text is that world with the second model behind all that it holds.
MergedWorld merged_world(const EditedModel& a, const EditedModel& b, const WorldRequest& request);

/// URDF: both roots on fixed joints to a new link, where the first one's is at the identity; of the second one as
/// `attached` takes it (its `link` is the new root). Refused where a link of that name is there.
Change merged_robot(ModelReader& reader, const EditedModel& a, const EditedModel& b,
                    const AttachRequest& request);

}  // namespace rigor::author
