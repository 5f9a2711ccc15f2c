// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/core.h>

#include <rigor/robot/assembled/assembled.h>
#include <rigor/robot/placed_collisions.h>
#include <rigor/rules/assembly/undone_slips.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::shape_exceeds_robot {

using model::Vector3;

// Times as long as all the rest of the robot together.
constexpr double kTimes = 2.5;

// Links of a robot; two bodies and a joint may be of any sizes.
constexpr std::size_t kFewestLinks = 3;

constexpr std::array<double, 3> kFactors{10, 100, 1000};
constexpr double kInch = 25.4;  // of meshes, which may be drawn in any unit

/// All shapes of a model, and the box around any but one of them.
class BoundsWithout {
 public:
  explicit BoundsWithout(std::vector<mesh::Bounds> boxes) : boxes_(std::move(boxes)) {
    for (const mesh::Bounds& box : boxes_) before_.push_back(add(before_, box));
    for (std::size_t i = boxes_.size(); i-- > 0;) behind_.push_back(add(behind_, boxes_[i]));
  }

  /// m, the diagonal.
  double length(std::size_t but) const {
    const std::size_t behind = boxes_.size() - 1 - but;
    if (but == 0) return mesh::diagonal(behind_[behind - 1]);
    if (behind == 0) return mesh::diagonal(before_[but - 1]);
    return mesh::diagonal(robot::joined(before_[but - 1], behind_[behind - 1]));
  }

 private:
  static mesh::Bounds add(const std::vector<mesh::Bounds>& so_far, const mesh::Bounds& box) {
    return so_far.empty() ? box : robot::joined(so_far.back(), box);
  }

  std::vector<mesh::Bounds> boxes_, before_, behind_;
};

/// A number of the shape that was multiplied, or all of them.
struct Shrunk {
  std::vector<Edit> edits;
  std::string slip;
  double length = 0;  ///< m, of the shape then
};

double diagonal_of(const model::Shape& shape) {
  const auto bounds = robot::shape_bounds(shape, robot::ShapeRole::kCollision, {});
  return bounds ? mesh::diagonal(*bounds) : 0;
}

void divide(model::Field<double>& number, double factor, Shrunk& shrunk) {
  number.value = divided(number.value, factor);
  shrunk.edits.push_back({number.span, write::joined({number.value})});
}

void divide(model::Field<Vector3>& size, const std::array<bool, 3>& which, double factor,
            Shrunk& shrunk) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (which[k]) size.value.*kCoordinates[k] = divided(size.value.*kCoordinates[k], factor);
  }
  shrunk.edits.push_back({size.span, written_as(size.value)});
}

std::vector<Shrunk> shrunk_by(const model::Shape& shape, double factor, double length) {
  std::vector<Shrunk> result;
  const auto add = [&](model::Shape changed, Shrunk shrunk, const std::string& what) {
    shrunk.slip = fmt::format("{} divided by {:g}", what, factor);
    shrunk.length = diagonal_of(changed);
    result.push_back(std::move(shrunk));
  };
  const auto add_round = [&](auto round) {
    auto longer = round;
    Shrunk one;
    divide(longer.length, factor, one);
    add(longer, std::move(one), "the length");
    auto wider = round;
    Shrunk other;
    divide(wider.radius, factor, other);
    add(wider, std::move(other), "the radius");
  };
  if (const auto* s = std::get_if<model::Cylinder>(&shape)) add_round(*s);
  if (const auto* s = std::get_if<model::Capsule>(&shape)) add_round(*s);
  if (const auto* s = std::get_if<model::Sphere>(&shape)) {
    model::Sphere ball = *s;
    Shrunk one;
    divide(ball.radius, factor, one);
    add(ball, std::move(one), "the radius");
  }
  if (const auto* s = std::get_if<model::Box>(&shape)) {
    for (std::size_t k = 0; k < 4; ++k) {
      model::Box box = *s;
      Shrunk one;
      divide(box.size, {k == 0 || k == 3, k == 1 || k == 3, k == 2 || k == 3}, factor, one);
      add(box, std::move(one), k == 3 ? "the size" : std::string(coordinate_name(k)));
    }
  }
  if (const auto* s = std::get_if<model::Mesh>(&shape)) {
    model::Mesh mesh = *s;
    Shrunk one;
    if (mesh.scale.written && !mesh.scale.span.nowhere())
      divide(mesh.scale, {true, true, true}, factor, one);
    result.push_back(
        {std::move(one.edits), fmt::format("its scale divided by {:g}", factor), length / factor});
  }
  return result;
}

/// Of the changes with which it is no longer than the rest of the robot the one that makes it most like
/// `usual`, m: what else its link has, or the robot's other shapes.
std::optional<Shrunk> change_for(const model::Shape& shape, double length, double rest,
                                 double usual) {
  std::vector<double> factors{kFactors.begin(), kFactors.end()};
  if (std::holds_alternative<model::Mesh>(shape)) factors.push_back(kInch);
  std::optional<Shrunk> best;
  double least = std::numeric_limits<double>::infinity();
  for (const double factor : factors) {
    for (Shrunk& change : shrunk_by(shape, factor, length)) {
      if (!(change.length > 0) || change.length > rest) continue;
      // Robots are drawn in meters or millimeters, and decimal points slip by one place.
      constexpr double kRare = 1;  // a factor of e
      const double unlike = std::abs(std::log(change.length / usual)) + (factor == 100 ? kRare : 0);
      // One number before all of them.
      constexpr double kClearly = 0.1;
      if (unlike >= least - kClearly) continue;
      least = unlike;
      best = std::move(change);
    }
  }
  return best;
}

/// The diagonal of the largest shape of the same link in the other role, or else the median of all others, m.
double usual_length(std::size_t one, const std::vector<const robot::AssembledShape*>& shapes) {
  double counterpart = 0;
  std::vector<double> lengths;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    if (i == one) continue;
    lengths.push_back(mesh::diagonal(shapes[i]->bounds_S));
    if (shapes[i]->link == shapes[one]->link && shapes[i]->role != shapes[one]->role)
      counterpart = std::max(counterpart, lengths.back());
  }
  if (counterpart > 0) return counterpart;
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

/// Whether its link has other shapes that are known.
bool has_company(const robot::AssembledShape& shape, const robot::Assembled& robot) {
  return robot.links[shape.link].shapes.size() > 1;
}

void check_model(const std::vector<const robot::AssembledShape*>& shapes, Context& context) {
  const model::Root& root = context.root();
  std::vector<mesh::Bounds> boxes;
  for (const robot::AssembledShape* shape : shapes) boxes.push_back(robot::bounds_of(shape->box_W));
  const BoundsWithout without(boxes);
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const robot::AssembledShape& shape = *shapes[i];
    const double length = mesh::diagonal(shape.bounds_S);
    const double rest = without.length(i);
    if (!(rest > 0) || length < kTimes * rest) continue;
    const bool collision = shape.role == robot::ShapeRole::kCollision;
    const model::Geometry& geometry =
        collision ? root.collisions[shape.index].geometry : root.visuals[shape.index].geometry;
    if (!root.own(geometry.site)) continue;
    const auto change = change_for(geometry.shape, length, rest, usual_length(i, shapes));
    if (!change) continue;
    context.report(
        {.where = geometry.site.name,
         .message = fmt::format("the {} is {:.3g} m long, and all the rest of the robot {:.3g} m",
                                collision ? "collision" : "visual", length, rest),
         .subject = collision ? context.subject(root.collisions[shape.index])
                              : context.subject(root.visuals[shape.index]),
         .help = fmt::format("with {} it is {:.3g} m long", change->slip, change->length),
         .fix = change->edits.empty()
                    ? std::nullopt
                    : fix_of("write it so", Applicability::kUnsafe, change->edits),
         // A hull and its fins, seen by nothing else.
         .severity = has_company(shape, context.assembled()) ? std::nullopt
                                                             : std::optional(Severity::kInfo)});
  }
}

void check(const model::Root& root, Context& context) {
  if (root.links.size() < kFewestLinks || root.joints.empty()) return;
  const robot::Assembled& robot = context.assembled();
  std::map<model::Id<model::Model>, std::vector<const robot::AssembledShape*>> models;
  std::map<model::Id<model::Model>, std::size_t> links;
  for (const robot::AssembledLink& link : robot.links) ++links[link.top];
  for (const robot::AssembledShape& shape : robot.shapes)
    models[robot.links[shape.link].top].push_back(&shape);
  for (const auto& [top, shapes] : models) {
    if (links[top] < kFewestLinks || shapes.size() < kFewestLinks) continue;
    if (root[top].is_static.value) continue;
    check_model(shapes, context);
  }
}

Rule rule() {
  return {
      .name = "shape-exceeds-robot",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "one shape is larger than all the rest of its robot",
      .why = "A collision that is ten times too large throws the robot into the air; a visual "
             "hides it, and cameras inside of it see nothing. The shape is more than twice as long "
             "as the box around all other shapes, and no longer than that once a slip is undone: a "
             "decimal point, or a unit. Where its link has no other shape, it is an info.",
      .what_to_do = "Write the size in meters, and a mesh's scale from its unit to meters.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::shape_exceeds_robot
