// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mass/total.h>

namespace rigor::mass {
namespace {

void add_up(const model::Root& root, const model::Frames& frames, model::Id<model::Model> id,
            const BodyOfLink& body_of_link, Total& sum) {
  for (const model::Id<model::Link> link : root[id].links) {
    const MassProperties own = body_of_link(link);
    sum.mass += own.mass;
    const std::optional<model::Pose> X_WL = frames.pose(link);
    if (!X_WL) sum.body.reset();
    if (sum.body) sum.body = add(*sum.body, transformed(*X_WL, own));
  }
  for (const model::Id<model::Model> nested : root[id].models) {
    add_up(root, frames, nested, body_of_link, sum);
  }
}

}  // namespace

Total total(const model::Root& root, const model::Frames& frames, model::Id<model::Model> model,
            const BodyOfLink& body_of_link) {
  Total sum{0, MassProperties{}};
  add_up(root, frames, model, body_of_link, sum);
  return sum;
}

}  // namespace rigor::mass
