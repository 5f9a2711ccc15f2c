// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include <rigor/rules/edits.h>
#include <rigor/rules/inertia/tensor_mistake.h>
#include <rigor/rules/rule.h>
#include <rigor/write/numbers.h>

namespace rigor::rules::inertia_rotated_by_pose {

using model::Quaternion;

std::optional<Fix> without_rotation(const model::Inertial& inertial, const Context& context) {
  const char* const title = "write an inertial that is not rotated";
  const xml::Element element = context.element(inertial.pose.site);
  if (context.is_urdf()) {
    return fix_of(title, Applicability::kUnsafe,
                  write::set_numbers(context.document(), element, "rpy", {0, 0, 0}));
  }
  if (element.name() != "pose" || !element.text_verbatim()) return std::nullopt;
  auto numbers = write::numbers_in(element.text());
  if (!numbers || numbers->size() != 6) return std::nullopt;
  std::fill(numbers->begin() + 3, numbers->end(), 0);
  return fix_of(title, Applicability::kUnsafe,
                write::set_numbers(context.document(), element, *numbers));
}

bool is_rotated(const model::Inertial& inertial) {
  return inertial.pose.pose.value.rotation != Quaternion{};
}

// π/2 as 1.57 is off by a thousandth.
constexpr double kNear = 2e-3;

/// A rotation that takes axes to axes, as people write it by hand.
bool is_right_angle(const Quaternion& q) {
  for (const auto& row : model::to_matrix(q)) {
    const bool axis = std::any_of(row.begin(), row.end(),
                                  [](double entry) { return std::abs(entry) > 1 - kNear; });
    if (!axis) return false;
  }
  return true;
}

/// Whether two rotations turn this tensor alike.
bool turn_alike(const mass::Inertia& tensor, const Quaternion& a, const Quaternion& b) {
  const mass::Inertia turned = mass::rotated(b, tensor);
  constexpr double kSame = 0.02;  // of the moments' sum
  return tensor_mistake::difference(mass::rotated(a, tensor), turned) < kSame;
}

/// Whether a shape of the link is rotated as its inertial is, for which its tensor may be.
bool a_shape_is_rotated_alike(const model::Link& link, Context& context) {
  const model::Root& root = context.root();
  const mass::Inertia tensor = mass::tensor(link.inertial);
  const Quaternion& own = link.inertial.pose.pose.value.rotation;
  const auto any = [&](const auto& shapes) {
    return std::any_of(shapes.begin(), shapes.end(), [&](auto id) {
      return turn_alike(tensor, own, root[id].pose.pose.value.rotation);
    });
  };
  return any(link.collisions) || any(link.visuals);
}

/// Whether the tensor is more like that of the shapes, as solids, with its rotation than without.
bool fits_shapes(const model::Link& link, Context& context) {
  const mass::Inertia tensor = mass::tensor(link.inertial);
  for (const mass::From from : {mass::From::kCollisions, mass::From::kVisuals}) {
    const auto solid = solid_of_all(link, from, context);
    if (!solid || !(solid->mass > 0)) continue;
    const mass::Inertia expected = mass::with_mass(*solid, link.inertial.mass.value).about_com;
    const mass::Inertia turned = mass::rotated(link.inertial.pose.pose.value.rotation, tensor);
    return tensor_mistake::difference(turned, expected) <
           tensor_mistake::difference(tensor, expected);
  }
  return false;
}

/// Whether the rotation is one that neither the link's shapes nor other links have.
bool is_unexplained(const model::Link& link, Context& context) {
  if (!has_tensor(link, context) || !is_rotated(link.inertial)) return false;
  const Quaternion& own = link.inertial.pose.pose.value.rotation;
  if (turn_alike(mass::tensor(link.inertial), own, {})) return false;
  return !a_shape_is_rotated_alike(link, context) && !fits_shapes(link, context);
}

struct Inertials {
  std::size_t plain = 0;  ///< with a tensor, and not rotated
  std::vector<const model::Link*> odd;
};

void check_model(const model::Model& model, Context& context) {
  const model::Root& root = context.root();
  Inertials found;
  for (const auto id : model.links) {
    const model::Link& link = root[id];
    if (!root.own(link.site) || !has_tensor(link, context)) continue;
    if (!is_rotated(link.inertial)) ++found.plain;
    if (is_unexplained(link, context)) found.odd.push_back(&link);
  }
  // A program that rotates one inertial into its principal axes does so with all.
  constexpr std::size_t kPlain = 2;
  if (found.plain < kPlain || found.odd.size() != 1) return;
  const model::Link& link = *found.odd.front();
  const model::Inertial& inertial = link.inertial;
  if (!is_right_angle(inertial.pose.pose.value.rotation)) return;
  if (mistaken_tensor(link, context).mistake == TensorMistake::kTurned) return;
  context.report({.where = inertial.pose.site.name,
                  .message = "the inertial is rotated by a right angle, unlike the link's shapes "
                             "and all other inertials of the model",
                  .subject = context.subject(link),
                  .related = {{inertial.tensor_site.name, "the tensor"}},
                  .fix = without_rotation(inertial, context)});
}

void check(const model::Link& link, Context& context) {
  if (!is_rotated(link.inertial)) return;
  if (mistaken_tensor(link, context).mistake != TensorMistake::kTurned) return;
  const model::Inertial& inertial = link.inertial;
  context.report({.where = inertial.pose.site.name,
                  .message = "the inertial's pose rotates the tensor away from the shapes: its "
                             "numbers are what they have along the link's own axes",
                  .subject = context.subject(link),
                  .related = {{inertial.tensor_site.name, "the tensor"}},
                  .fix = without_rotation(inertial, context)});
}

Rule rule() {
  return {
      .name = "inertia-rotated-by-pose",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "a tensor along the link's axes is turned by its inertial's rotation",
      .why = "A rotation that was copied there from the visual or collision rotates a tensor that "
             "was right along the link's axes. The tensor is taken along the axes that the "
             "inertial's pose or origin gives. Where the shapes do not tell, the one inertial of a "
             "model that is rotated by a right angle, as no shape of its link is, is reported.",
      .what_to_do = "Take the rotation out of the inertial, and leave the position.",
      .checks = {on<model::Link>(check), on<model::Model>(check_model)},
  };
}

}  // namespace rigor::rules::inertia_rotated_by_pose
