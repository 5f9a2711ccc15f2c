// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A robot as one body: the sum of its links where they are.
//
//   Total robot = total(root, frames, model, [&](Id<Link> id) { return resolve(root, id); });

#pragma once

#include <functional>
#include <optional>

#include <rigor/mass/mass_properties.h>
#include <rigor/model/frames.h>
#include <rigor/model/model.h>

namespace rigor::mass {

using BodyOfLink = std::function<MassProperties(model::Id<model::Link>)>;

struct Total {
  double mass = 0;  ///< kg
  /// In the frame of the poses; nothing when a link has no pose.
  std::optional<MassProperties> body;
};

/// Of a model with all that is nested in it. `frames` says where the links are, at the joint positions
/// that it was made for.
Total total(const model::Root& root, const model::Frames& frames, model::Id<model::Model> model,
            const BodyOfLink& body_of_link);

}  // namespace rigor::mass
