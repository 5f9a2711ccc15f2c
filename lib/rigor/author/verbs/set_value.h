// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// One value of a model set where it is written, or added where it is a default.
//
//   const Change change = with_pose(*edited, "elbow", {{0, 0, 0.3}, {}});
//   const Change limits = with_limits(*edited, "elbow", {.lower = -1, .effort = 20});

#pragma once

#include <optional>
#include <string_view>

#include <rigor/author/verbs/change.h>
#include <rigor/model/pose.h>

namespace rigor::author {

/// The pose of a joint, a frame, a link, or the model by its own name, in m, in the frame that the file has it in. A
/// URDF's link is where its joint is.
Change with_pose(const EditedModel& edited, std::string_view name, const model::Pose& X);

/// Of the first axis: rad or m, N·m or N, rad/s or m/s. What is absent is kept.
struct NewLimits {
  std::optional<double> lower, upper, effort, velocity;
};

/// Refused: joints that have no limits, a lower limit above the upper one, numbers below zero for effort and velocity, and
/// of URDF what would be a `<limit>` without effort or velocity, which urdfdom rejects.
Change with_limits(const EditedModel& edited, std::string_view joint, const NewLimits& limits);

}  // namespace rigor::author
