// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A link cut in two with a fixed joint between them: what `lump` makes one again.
//
//   SplitRequest request;
//   request.take = {"camera_housing", "collision/2", "pan_joint"};
//   request.X_LN = {{0, 0, 0.3}, {}};
//   const Change change = split(*edited, "arm", request);
//
// Visuals, collisions, sensors and lights that are named move to the new link with their bytes, but for their poses;
// joints that are named hang on it. All that was somewhere is there still. Both links together have the mass, center of
// mass and tensor that the link had. What the link says of itself, as its gravity or its `<gazebo>` friction, the new one
// says, too.

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/author/verbs/change.h>
#include <rigor/model/pose.h>

namespace rigor::author {

enum class SplitMass : std::uint8_t {
  kStays,   ///< in the link: only in URDF, as an SDF link without mass weighs 1 kg
  kGiven,   ///< `SplitRequest::mass`
  kShapes,  ///< in the proportion of the volumes
};

struct SplitRequest {
  std::string name;  ///< of the new link; empty: the link's and `_part`
  model::Pose X_LN;  ///< of the new link in the link, m
  /// By name, or "visual/2" for the second one of the link; joints by name.
  std::vector<std::string> take;
  SplitMass share = SplitMass::kStays;
  double mass = 0;  ///< kg, of the new link
};

/// Where a link, joint or frame of that name is, in the link; nothing when there is none.
std::optional<model::Pose> place_in_link(const EditedModel& edited, std::string_view link,
                                         std::string_view name);

/// The new link's mass is that of the taken shapes at one density where what remains is a body then, else a share of
/// each piece of the link's matter: the same center of mass and a share of the tensor. Refused: templates, links of
/// files that are included, and names that the link does not hold.
Change split(const EditedModel& edited, std::string_view link, const SplitRequest& request);

}  // namespace rigor::author
