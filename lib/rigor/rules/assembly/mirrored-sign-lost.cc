// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/core.h>

#include <rigor/robot/assembled/symmetry.h>
#include <rigor/rules/assembly/twin_numbers.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mirrored_sign_lost {

using model::Vector3;
using robot::MirrorPlane;
using robot::Twins;

// Pairs that are mirrored in what is examined, for each that is not: else the author did not mean them to be.
constexpr std::size_t kFewest = 2;
constexpr std::size_t kShare = 2;

constexpr double kSame = 1e-6;  // m

/// A point of two twins that is the same but for signs, though not mirrored.
struct Point {
  const model::PoseField* a = nullptr;
  const model::PoseField* b = nullptr;
  model::Pose X_WA;  ///< of what the pose places
  model::Pose X_WB;
  Vector3 p_WA;
  Vector3 p_WB;
};

bool same_numbers(const Vector3& a, const Vector3& b) {
  return same_size(a.x, b.x) && same_size(a.y, b.y) && same_size(a.z, b.z);
}

bool is_trivial(const Vector3& p) {
  constexpr double kMin = 2e-3;  // m: less may be mirrored or not
  return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) < kMin;
}

/// The sign that, changed in one of the two, makes them mirrored.
struct Flip {
  bool confirmed = false;  // another part of that side has it, or only then it is on its side
  bool of_first = false;
  std::size_t coordinate = 0;
  Vector3 value;
};

std::vector<Flip> flips_of(const Point& point, const MirrorPlane& plane) {
  std::vector<Flip> result;
  for (const bool first : {true, false}) {
    const model::PoseField& pose = first ? *point.a : *point.b;
    const model::Pose& X_W = first ? point.X_WA : point.X_WB;
    for (std::size_t k = 0; k < 3; ++k) {
      Vector3 value = pose.pose.value.translation;
      if (value.*kCoordinates[k] == 0) continue;
      value.*kCoordinates[k] = -1 * value.*kCoordinates[k];
      const Vector3 shift = shift_of(pose.pose.value, X_W, value);
      const Vector3 a = first ? point.p_WA + shift : point.p_WA;
      const Vector3 b = first ? point.p_WB : point.p_WB + shift;
      if (are_mirrored(plane, a, b)) result.push_back({false, first, k, value});
    }
  }
  return result;
}

/// What is compared of one pair.
struct Compared {
  Twins pair;
  Point point;
  bool mirrored = false;
};

/// The files of the meshes that a link is seen by, with their scales.
std::vector<std::pair<std::string, Vector3>> meshes_of(const model::Link& link,
                                                       const model::Root& root) {
  std::vector<std::pair<std::string, Vector3>> result;
  for (const auto id : link.visuals) {
    const auto* mesh = std::get_if<model::Mesh>(&root[id].geometry.shape);
    if (mesh != nullptr) result.emplace_back(mesh->uri.value, mesh->scale.value);
  }
  return result;
}

/// Whether two links are seen by the same meshes: one part that is there twice, and not its mirror image.
bool are_one_part(const model::Link& a, const model::Link& b, const model::Root& root) {
  const auto meshes = meshes_of(a, root);
  return &a != &b && !meshes.empty() && meshes == meshes_of(b, root);
}

/// Whether the links of a pair, or those that they are on, are one part.
bool are_on_one_part(const Twins& pair, Context& context) {
  const model::Root& root = context.root();
  if (are_one_part(root.links[pair.a], root.links[pair.b], root)) return true;
  const auto of_a = context.assembled().links[pair.a].carrier;
  const auto of_b = context.assembled().links[pair.b].carrier;
  if (!of_a || !of_b) return false;
  const auto a = context.frames().ends(of_a).parent, b = context.frames().ends(of_b).parent;
  return a && b && are_one_part(root[a], root[b], root);
}

/// Where the poses of the links' centers of mass are.
std::optional<Point> center_of_mass(const Twins& pair, Context& context) {
  const model::Root& root = context.root();
  const auto& X_WA = context.assembled().links[pair.a].X_WL;
  const auto& X_WB = context.assembled().links[pair.b].X_WL;
  const model::PoseField& a = root.links[pair.a].inertial.pose;
  const model::PoseField& b = root.links[pair.b].inertial.pose;
  if (!X_WA || !X_WB || !a.pose.written || !b.pose.written) return std::nullopt;
  const model::Pose X_WCa = compose(*X_WA, a.pose.value), X_WCb = compose(*X_WB, b.pose.value);
  return Point{&a, &b, X_WCa, X_WCb, X_WCa.translation, X_WCb.translation};
}

/// Of a link of the model, by its name.
std::optional<model::Pose> pose_of(const std::string& name, model::Id<model::Model> model,
                                   Context& context) {
  for (const auto id : context.root()[model].links) {
    if (context.root()[id].name.value == name) return context.assembled().links[id.value].X_WL;
  }
  return std::nullopt;
}

/// Where the links themselves are, by a URDF joint's origin or an SDF link's pose; only where what they
/// are placed from is mirrored.
std::optional<Point> placement(const Twins& pair, const MirrorPlane& plane, Context& context) {
  const model::Root& root = context.root();
  const robot::Assembled& robot = context.assembled();
  const auto& X_WA = robot.links[pair.a].X_WL;
  const auto& X_WB = robot.links[pair.b].X_WL;
  if (!X_WA || !X_WB) return std::nullopt;
  const model::PoseField* a = &root.links[pair.a].pose;
  const model::PoseField* b = &root.links[pair.b].pose;
  if (context.is_urdf()) {
    const auto of_a = robot.links[pair.a].carrier, of_b = robot.links[pair.b].carrier;
    if (!of_a || !of_b) return std::nullopt;
    a = &root[of_a].pose;
    b = &root[of_b].pose;
    const auto& X_WP = robot.links[context.frames().ends(of_a).parent.value].X_WL;
    const auto& X_WQ = robot.links[context.frames().ends(of_b).parent.value].X_WL;
    if (!X_WP || !X_WQ || !are_mirrored(plane, X_WP->translation, X_WQ->translation))
      return std::nullopt;
  } else if (a->relative_to.value != b->relative_to.value) {
    const auto X_WP = pose_of(a->relative_to.value, root.links[pair.a].model, context);
    const auto X_WQ = pose_of(b->relative_to.value, root.links[pair.b].model, context);
    if (!X_WP || !X_WQ || !are_mirrored(plane, X_WP->translation, X_WQ->translation))
      return std::nullopt;
  }
  if (!a->pose.written || !b->pose.written) return std::nullopt;
  return Point{a, b, *X_WA, *X_WB, X_WA->translation, X_WB->translation};
}

/// Which of the two the sign is wrong in.
Flip likely(const std::vector<Flip>& flips, const Compared& one, const MirrorPlane& plane,
            const std::vector<Compared>& all, Context& context) {
  const robot::Assembled& robot = context.assembled();
  const auto side = [&](const Vector3& p) { return p.*kCoordinates[plane.axis] > plane.at; };
  // The side that most parts with this side's name are on.
  std::size_t first_above = 0, first_below = 0;
  for (const Compared& other : all) {
    if (other.mirrored) ++(side(other.point.p_WA) ? first_above : first_below);
  }
  // What another part of that side, in front or behind, has written.
  for (const Flip& flip : flips) {
    const auto has_it = [&](const Compared& other) {
      const model::PoseField& pose = flip.of_first ? *other.point.a : *other.point.b;
      return other.mirrored && length(pose.pose.value.translation - flip.value) < kSame;
    };
    if (std::any_of(all.begin(), all.end(), has_it))
      return {true, flip.of_first, flip.coordinate, flip.value};
  }
  const bool above = first_above > first_below;
  for (const Flip& flip : flips) {
    const Vector3& now = flip.of_first ? one.point.p_WA : one.point.p_WB;
    if (side(now) == (flip.of_first ? above : !above)) continue;
    // On the side of the others' twins, and all of these are on theirs.
    const bool clear = std::min(first_above, first_below) == 0;
    return {clear, flip.of_first, flip.coordinate, flip.value};
  }
  // The center of mass that is farther from the middle of its shapes.
  const auto off = [&](std::uint32_t link, const Vector3& p) {
    const auto box = robot.bounds_W({link});
    return box ? length(p - 0.5 * (box->min + box->max)) : 0;
  };
  const bool first = off(one.pair.a, one.point.p_WA) > off(one.pair.b, one.point.p_WB);
  for (const Flip& flip : flips) {
    if (flip.of_first == first) return flip;
  }
  return flips.front();
}

struct Kind {
  const char* name;
  std::vector<Compared> compared;
};

void report(const Kind& kind, const MirrorPlane& plane, Context& context) {
  const model::Root& root = context.root();
  const auto good =
      static_cast<std::size_t>(std::count_if(kind.compared.begin(), kind.compared.end(),
                                             [](const Compared& one) { return one.mirrored; }));
  if (good < kFewest || good < kShare * (kind.compared.size() - good)) return;
  for (const Compared& one : kind.compared) {
    if (one.mirrored) continue;
    if (!same_numbers(one.point.a->pose.value.translation, one.point.b->pose.value.translation))
      continue;
    const std::vector<Flip> flips = flips_of(one.point, plane);
    if (flips.empty()) continue;
    const Flip flip = likely(flips, one, plane, kind.compared, context);
    if (!flip.confirmed && are_on_one_part(one.pair, context)) continue;
    const model::PoseField& pose = flip.of_first ? *one.point.a : *one.point.b;
    const model::PoseField& other = flip.of_first ? *one.point.b : *one.point.a;
    const model::Link& link = root.links[flip.of_first ? one.pair.a : one.pair.b];
    const model::Link& twin = root.links[flip.of_first ? one.pair.b : one.pair.a];
    context.report(
        {.where = place_of(pose, context),
         .message = fmt::format(
             "the {} {} is not the mirror image of that of '{}'; those of {} other pairs are",
             kind.name, written_as(pose.pose.value.translation), twin.name.value, good),
         .subject = context.subject(link),
         .related = {{place_of(other, context), "its twin's"}},
         .help = fmt::format("with the other sign of {} it is: {}",
                             coordinate_name(flip.coordinate), written_as(flip.value)),
         .fix = translation_fix(pose, flip.value, context),
         .severity = flip.confirmed ? Severity::kWarning : Severity::kInfo});
  }
}

void check(const model::Root& root, Context& context) {
  constexpr std::size_t kFewestLinks = 7;  // three pairs, of which two say what the third should be
  if (root.links.size() < kFewestLinks || !context.frames().problems().empty()) return;
  std::map<model::Id<model::Model>, std::vector<Twins>> by_model;
  for (const Twins& pair : context.assembled().link_twins)
    by_model[root.links[pair.a].model].push_back(pair);
  for (const auto& [model, pairs] : by_model) {
    const auto plane = robot::symmetry_plane(context.assembled(), pairs);
    if (!plane) continue;
    Kind places{"origin", {}}, masses{"center of mass", {}};
    for (const Twins& pair : pairs) {
      const auto at = placement(pair, *plane, context);
      if (!at) continue;
      const bool mirrored = are_mirrored(*plane, at->p_WA, at->p_WB);
      if (!is_trivial(at->a->pose.value.translation))
        places.compared.push_back({pair, *at, mirrored});
      const auto com = mirrored ? center_of_mass(pair, context) : std::nullopt;
      if (!com || is_trivial(com->a->pose.value.translation)) continue;
      masses.compared.push_back({pair, *com, are_mirrored(*plane, com->p_WA, com->p_WB)});
    }
    report(places, *plane, context);
    report(masses, *plane, context);
  }
}

Rule rule() {
  return {
      .name = "mirrored-sign-lost",
      .severity = Severity::kInfo,
      .fix = FixGrade::kUnsafe,
      .summary = "a part is not the mirror image of its twin, but for one sign",
      .why = "The robot is lopsided: two legs are on one side, or the mass of one side is in the "
             "wrong place. Other pairs of the robot, left and right, are mirror images; this one "
             "has the same numbers, and is one once a sign is changed. Joints are at zero. It is "
             "a warning when another part of that side, in front or behind, has the sign, or when "
             "it is on the side where all others have the other name; else what is seen by the "
             "same meshes on both sides, as a camera, is one part and no mirror image.",
      .what_to_do = "Change the sign of the coordinate in the one that is wrong. `rigor inspect "
                    "--assembled` prints the plane and the pairs.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::mirrored_sign_lost
