// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/core.h>

#include <rigor/robot/assembled/symmetry.h>
#include <rigor/rules/assembly/twin_numbers.h>
#include <rigor/rules/edits.h>
#include <rigor/rules/inertia/tensor_mistake.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::products_of_inertia_negated {

std::string with_other_sign(std::string_view number) {
  if (number.starts_with('-')) return std::string(number.substr(1));
  if (number.starts_with('+')) number.remove_prefix(1);
  return "-" + std::string(number);
}

Fix negate(const model::Inertial& inertial, const Context& context) {
  Fix fix{"give the products the other sign", Applicability::kUnsafe, {}};
  for (const auto* product : {&inertial.ixy, &inertial.ixz, &inertial.iyz}) {
    if (!product->written || product->value == 0) continue;
    fix.edits.push_back({product->span, with_other_sign(context.bytes(product->span))});
  }
  return fix;
}

void check(const model::Link& link, Context& context) {
  const model::Inertial& inertial = link.inertial;
  if (inertial.ixy.value == 0 && inertial.ixz.value == 0 && inertial.iyz.value == 0) return;
  if (mistaken_tensor(link, context).mistake != TensorMistake::kProductsNegated) return;
  context.report({.where = inertial.tensor_site.name,
                  .message = fmt::format(
                      "ixy, ixz and iyz ({:.4g}, {:.4g} and {:.4g} kg·m²) have the opposite sign "
                      "of what the link's shapes have; the rest of the tensor fits",
                      inertial.ixy.value, inertial.ixz.value, inertial.iyz.value),
                  .subject = context.subject(link),
                  .fix = negate(inertial, context)});
}

/// What mirroring in a plane makes of a tensor: the products with the plane's axis get the other sign.
mass::Inertia mirrored(const robot::MirrorPlane& plane, mass::Inertia tensor) {
  if (plane.axis != 2) tensor.ixy = -tensor.ixy;
  if (plane.axis != 1) tensor.ixz = -tensor.ixz;
  if (plane.axis != 0) tensor.iyz = -tensor.iyz;
  return tensor;
}

enum class Likeness : std::uint8_t { kNone, kMirrored, kCopied, kNegated };

/// How the tensors of two links are related, in W. Of one without products nothing is known.
Likeness likeness_of(const robot::Twins& pair, const robot::MirrorPlane& plane, Context& context) {
  constexpr double kAlike = 0.03;  // of the moments' sum
  const model::Root& root = context.root();
  const auto& X_WA = context.assembled().links[pair.a].X_WL;
  const auto& X_WB = context.assembled().links[pair.b].X_WL;
  const model::Inertial& a = root.links[pair.a].inertial;
  const model::Inertial& b = root.links[pair.b].inertial;
  if (!X_WA || !X_WB || !(a.mass.value > 0) || !(b.mass.value > 0)) return Likeness::kNone;
  const mass::Inertia of_a = mass::tensor(a), of_b = mass::tensor(b);
  if (!tensor_mistake::has_products(of_a) || !tensor_mistake::has_products(of_b))
    return Likeness::kNone;
  const auto in_W = [](const model::Pose& X_WL, const model::Inertial& inertial,
                       const mass::Inertia& tensor) {
    return mass::rotated(X_WL.rotation * inertial.pose.pose.value.rotation, tensor);
  };
  const mass::Inertia image = mirrored(plane, in_W(*X_WA, a, of_a));
  const mass::Inertia at_b = in_W(*X_WB, b, of_b);
  const auto alike = [](const mass::Inertia& p, const mass::Inertia& q) {
    return tensor_mistake::difference(p, q) < kAlike;
  };
  if (alike(at_b, image)) return Likeness::kMirrored;
  if (alike(of_a, of_b) || alike(at_b, mirrored(plane, image))) return Likeness::kCopied;
  const mass::Inertia negated = in_W(*X_WB, b, tensor_mistake::with_products_negated(of_b));
  return alike(negated, image) ? Likeness::kNegated : Likeness::kNone;
}

/// Which of the two has the wrong sign, when their twins in front or behind tell; else the second.
bool first_is_wrong(const robot::Twins& pair, const robot::MirrorPlane& plane,
                    const std::vector<robot::Twins>& along, Context& context) {
  const auto agrees = [&](std::uint32_t link) {
    for (const robot::Twins& other : along) {
      if (other.a != link && other.b != link) continue;
      robot::MirrorPlane across = plane;
      across.axis = plane.axis == 0 ? 1 : 0;
      const Likeness found = likeness_of(other, across, context);
      return found == Likeness::kMirrored || found == Likeness::kCopied;
    }
    return false;
  };
  return agrees(pair.b) && !agrees(pair.a);
}

void check_pairs(const std::vector<robot::Twins>& pairs, Context& context) {
  const model::Root& root = context.root();
  const auto plane = robot::symmetry_plane(context.assembled(), pairs);
  if (!plane) return;
  std::size_t good = 0;
  std::vector<robot::Twins> odd;
  for (const robot::Twins& pair : pairs) {
    const Likeness found = likeness_of(pair, *plane, context);
    good += found == Likeness::kMirrored;
    if (found == Likeness::kNegated) odd.push_back(pair);
  }
  if (good < 2 * odd.size()) return;
  for (const robot::Twins& pair : odd) {
    const auto along = twins_of(root.links, robot::Side::kAlong, root);
    const bool first = first_is_wrong(pair, *plane, along, context);
    const model::Link& wrong = root.links[first ? pair.a : pair.b];
    const model::Link& right = root.links[first ? pair.b : pair.a];
    if (mistaken_tensor(wrong, context).mistake == TensorMistake::kProductsNegated) continue;
    context.report(
        {.where = wrong.inertial.tensor_site.name,
         .message = fmt::format("the tensor is the mirror image of that of '{}' only with the "
                                "other sign of ixy, ixz and iyz",
                                right.name.value),
         .subject = context.subject(wrong),
         .related = {{right.inertial.tensor_site.name, "its twin's"}},
         .help = fmt::format("those of {} other pairs are mirror images as they are", good),
         .fix = negate(wrong.inertial, context)});
  }
}

void check_twins(const model::Root& root, Context& context) {
  constexpr std::size_t kFewestLinks = 7;  // three pairs, of which two say what the third should be
  if (root.links.size() < kFewestLinks || !context.frames().problems().empty()) return;
  std::map<model::Id<model::Model>, std::vector<robot::Twins>> by_model;
  for (const robot::Twins& pair : context.assembled().link_twins) {
    // A finger of the left hand is like that of the right hand on the same side, or on the other.
    constexpr std::size_t kOneSide = 2;
    const auto has = [&](std::uint32_t i) {
      const std::string& name = root.links[i].name.value;
      if (robot::mirrored_names(name, robot::Side::kAcross).size() > kOneSide) return false;
      return is_dynamic(root.links[i], context) && has_tensor(root.links[i], context);
    };
    if (has(pair.a) && has(pair.b)) by_model[root.links[pair.a].model].push_back(pair);
  }
  for (const auto& [model, pairs] : by_model) check_pairs(pairs, context);
}

/// A mirror image, as a part that is turned half around an axis, has two of three products negated or none:
/// the sign of what they make multiplied stays. Zero where one of them is.
double handedness(const model::Inertial& inertial) {
  const double product = inertial.ixy.value * inertial.ixz.value * inertial.iyz.value;
  return product > 0 ? 1 : (product < 0 ? -1 : 0);
}

bool same_but_for_signs(const model::Inertial& a, const model::Inertial& b) {
  constexpr double kDigits = 1e-5;
  const auto same = [](const model::Field<double>& p, const model::Field<double>& q) {
    const double u = std::abs(p.value), v = std::abs(q.value);
    return std::abs(u - v) <= kDigits * std::max(u, v);
  };
  return same(a.mass, b.mass) && same(a.ixx, b.ixx) && same(a.iyy, b.iyy) && same(a.izz, b.izz) &&
         same(a.ixy, b.ixy) && same(a.ixz, b.ixz) && same(a.iyz, b.iyz);
}

/// Those of the model that are the same body by all their numbers, for each in turn.
void check_same_bodies(const std::vector<std::uint32_t>& bodies, Context& context) {
  const model::Root& root = context.root();
  std::vector<bool> done(bodies.size(), false);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (done[i]) continue;
    std::vector<std::uint32_t> right, left;
    for (std::size_t k = i; k < bodies.size(); ++k) {
      const model::Inertial& other = root.links[bodies[k]].inertial;
      if (done[k] || !same_but_for_signs(root.links[bodies[i]].inertial, other)) continue;
      done[k] = true;
      (handedness(other) > 0 ? right : left).push_back(bodies[k]);
    }
    if (right.size() == left.size() && right.size() != 1) continue;
    const auto& odd = right.size() < left.size() ? right : left;
    const auto& most = &odd == &right ? left : right;
    if (odd.size() != 1) continue;
    const model::Link& wrong = root.links[odd.front()];
    const model::Link& like = root.links[most.front()];
    if (mistaken_tensor(wrong, context).mistake == TensorMistake::kProductsNegated) continue;
    context.report(
        {.where = wrong.inertial.tensor_site.name,
         .message = fmt::format("ixy, ixz and iyz are those of '{}' with signs that no mirror "
                                "image of its tensor has",
                                like.name.value),
         .subject = context.subject(wrong),
         .related = {{like.inertial.tensor_site.name, "the same numbers"}},
         .help = "mirrored in a plane, two of the three change their signs, or none",
         .fix = most.size() > 1 ? std::optional(negate(wrong.inertial, context)) : std::nullopt});
  }
}

void check_bodies(const model::Root& root, Context& context) {
  for (const model::Model& model : root.models) {
    std::vector<std::uint32_t> bodies;
    for (const auto id : model.links) {
      const model::Link& link = root[id];
      if (handedness(link.inertial) == 0 || !root.own(link.site)) continue;
      if (is_dynamic(link, context) && has_tensor(link, context)) bodies.push_back(id.value);
    }
    if (bodies.size() > 1) check_same_bodies(bodies, context);
  }
}

Rule rule() {
  return {
      .name = "products-of-inertia-negated",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "the products of inertia have the opposite sign",
      .why = "The body has its principal axes mirrored, and moves differently from the real one. "
             "SDF and URDF want the entries of the tensor, ixy = -∫xy dm; some CAD programs and "
             "mesh tools print the products ∫xy dm. A link that was copied from the robot's other "
             "side has the same fault: where the shapes do not tell, its tensor is compared with "
             "the mirror image of its twin's, as those of other pairs are. Of bodies with the same "
             "mass and moments one may be the mirror image of another, but then two of the three "
             "products have the other sign, and never all.",
      .what_to_do = "Give ixy, ixz and iyz the other sign.",
      .checks = {on<model::Link>(check), on<model::Root>(check_twins),
                 on<model::Root>(check_bodies)},
  };
}

}  // namespace rigor::rules::products_of_inertia_negated
