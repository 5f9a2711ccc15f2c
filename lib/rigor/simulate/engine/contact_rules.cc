// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/engine/contact_rules.h>

#include <algorithm>

namespace rigor::simulate {
namespace {

constexpr std::uint64_t body_pair(std::uint32_t a, std::uint32_t b) {
  return (std::uint64_t{std::min(a, b)} << 32U) | std::max(a, b);
}

double in_series(double a, double b) { return a > 0 && b > 0 ? 1 / (1 / a + 1 / b) : 0; }

}  // namespace

ContactRules::ContactRules(const Scene& scene) {
  for (const SceneShape& shape : scene.shapes) {
    Shape known{.body = shape.body,
                .without_contact = shape.surface.collide_without_contact,
                .bitmask = shape.surface.collide_bitmask};
    if (shape.link < scene.links.size()) known.model = scene.links[shape.link].model;
    if (shape.body != kWorld) {
      known.model = scene.bodies[shape.body].model;
      known.self_collide = scene.bodies[shape.body].self_collide;
    }
    shapes_.push_back(known);
  }
  for (const SceneJoint& joint : scene.joints) {
    jointed_.push_back(body_pair(joint.parent, joint.child));
  }
  std::sort(jointed_.begin(), jointed_.end());
}

bool ContactRules::are_jointed(std::uint32_t a, std::uint32_t b) const {
  return std::binary_search(jointed_.begin(), jointed_.end(), body_pair(a, b));
}

bool ContactRules::may_touch(std::uint32_t first, std::uint32_t second) const {
  const Shape& a = shapes_[first];
  const Shape& b = shapes_[second];
  if ((a.bitmask & b.bitmask) == 0) return false;
  if (a.without_contact || b.without_contact) return false;
  const bool same = a.model == b.model && a.model != kWorld;
  if (same && !a.self_collide && !b.self_collide) return false;
  // What hangs on the world touches the ground all the same, only not the model's own parts there.
  if (!same && (a.body == kWorld || b.body == kWorld)) return true;
  return !are_jointed(a.body, b.body);
}

ContactSurface combined(const ContactSurface& a, const ContactSurface& b) {
  ContactSurface both;
  both.mu = std::min(a.mu, b.mu);
  both.mu2 = std::min(a.mu2, b.mu2);
  both.slip1 = a.slip1 + b.slip1;
  both.slip2 = a.slip2 + b.slip2;
  both.restitution = std::min(a.restitution, b.restitution);
  both.bounce_threshold = std::min(a.bounce_threshold, b.bounce_threshold);
  both.kp = in_series(a.kp, b.kp);
  both.kd = a.kd + b.kd;
  both.max_contacts = std::min(a.max_contacts, b.max_contacts);
  return both;
}

}  // namespace rigor::simulate
