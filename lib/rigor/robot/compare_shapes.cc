// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>

#include <rigor/robot/compare_parts.h>

namespace rigor::robot {
namespace {

/// Colors are distinguished by eye and by bytes, of which this is a 250th.
constexpr double kColorStep = 1.0 / 255 / 250;

struct ShapeKinds {
  std::string_view name;
  DifferenceKind only_in_a, only_in_b, moved;
};
constexpr ShapeKinds kCollisionKinds{"collision", DifferenceKind::kCollisionOnlyInA,
                                     DifferenceKind::kCollisionOnlyInB,
                                     DifferenceKind::kCollisionMoved};
constexpr ShapeKinds kVisualKinds{"visual", DifferenceKind::kVisualOnlyInA,
                                  DifferenceKind::kVisualOnlyInB, DifferenceKind::kVisualMoved};

std::string robot_part_name(std::string_view kind, const Body& body, const Part& part,
                            std::uint32_t index) {
  return std::string(kind) + " " + body.name + "/" +
         (part.name.empty() ? std::to_string(index + 1) : part.name);
}

bool same_robot_color(const Color& a, const Color& b) {
  return std::abs(a.r - b.r) <= kColorStep && std::abs(a.g - b.g) <= kColorStep &&
         std::abs(a.b - b.b) <= kColorStep && std::abs(a.a - b.a) <= kColorStep;
}

std::string shape_file(const Shape& shape) {
  return shape.submesh.empty() ? shape.uri : shape.uri + " " + shape.submesh;
}

/// `<empty/>`: nobody misses it in a format that has no word for it.
bool is_nothing(const Part& part) { return part.shape.kind == "none"; }

class ShapeComparer {
 public:
  ShapeComparer(Comparison& comparison, std::uint32_t body)
      : c_(comparison),
        i_(body),
        j_(comparison.match.a.body[body]),
        x_(comparison.a.bodies[i_]),
        y_(comparison.b.bodies[j_]) {}

  void compare(const ShapeKinds& kinds, const std::vector<Part>& xs, const std::vector<Part>& ys) {
    for (const PartPair& pair : pair_parts(xs, ys)) {
      if (pair.b == kNoIndex) {
        if (is_nothing(xs[pair.a])) continue;
        Difference& d = c_.add(kinds.only_in_a, robot_part_name(kinds.name, x_, xs[pair.a], pair.a),
                               "", xs[pair.a].span, {});
        d.from = {xs[pair.a].shape.numbers, xs[pair.a].shape.kind};
        d.unit = "m";
      } else if (pair.a == kNoIndex) {
        if (is_nothing(ys[pair.b])) continue;
        Difference& d =
            c_.add(kinds.only_in_b, "", robot_part_name(kinds.name, y_, ys[pair.b], pair.b), {},
                   ys[pair.b].span);
        d.to = {ys[pair.b].shape.numbers, ys[pair.b].shape.kind};
        d.unit = "m";
      } else {
        compare(kinds, pair, xs[pair.a], ys[pair.b]);
      }
    }
  }

 private:
  void compare(const ShapeKinds& kinds, const PartPair& pair, const Part& x, const Part& y) {
    const auto add = [&](DifferenceKind kind) -> Difference& {
      return c_.add(kind, robot_part_name(kinds.name, x_, x, pair.a),
                    robot_part_name(kinds.name, y_, y, pair.b), x.span, y.span);
    };
    if (c_.names.helpers == Helpers::kReported && !x.name.empty() && !y.name.empty() &&
        plain_name(x.name) != plain_name(y.name)) {
      add(DifferenceKind::kPartRenamed);
    }
    const model::Pose& E = c_.shifts[i_].E;
    const model::Pose expected = E == model::Pose{} ? x.X_BS : compose(E, x.X_BS);
    if (!near(expected, y.X_BS, c_.tolerance)) {
      const Apart off = apart(expected, y.X_BS);
      Difference& d = add(kinds.moved);
      d.from.numbers = pose_numbers(expected);
      d.to.numbers = pose_numbers(y.X_BS);
      d.unit = "m";
      d.distance = off.distance;
      d.angle = off.angle;
    }
    compare_shape(x.shape, y.shape, add);
    if (differ_in_color(x, y)) {
      Difference& d = add(DifferenceKind::kColor);
      if (x.color) d.from.numbers = {x.color->r, x.color->g, x.color->b, x.color->a};
      if (y.color) d.to.numbers = {y.color->r, y.color->g, y.color->b, y.color->a};
    }
  }

  /// A material whose color is unknown may have that of the other.
  bool differ_in_color(const Part& x, const Part& y) const {
    if (x.color && y.color) return !same_robot_color(*x.color, *y.color);
    if (!c_.names.one_format) return false;
    return (x.color && !y.has_material) || (y.color && !x.has_material);
  }

  template <class Add>
  void compare_shape(const Shape& x, const Shape& y, Add add) {
    if (x.kind != y.kind) {
      Difference& d = add(DifferenceKind::kShape);
      d.from = {x.numbers, x.kind};
      d.to = {y.numbers, y.kind};
      d.unit = "m";
      return;
    }
    if (!same_file(x, y)) {
      Difference& d = add(DifferenceKind::kMesh);
      d.from.text = shape_file(x);
      d.to.text = shape_file(y);
    }
    const auto same = [this](double p, double q) { return near(p, q, c_.tolerance); };
    if (!std::equal(x.numbers.begin(), x.numbers.end(), y.numbers.begin(), y.numbers.end(), same)) {
      Difference& d = add(DifferenceKind::kSize);
      d.from = {x.numbers, x.kind};
      d.to = {y.numbers, y.kind};
      if (x.kind != "mesh") d.unit = "m";
      const std::size_t both = std::min(x.numbers.size(), y.numbers.size());
      for (std::size_t n = 0; n < both; ++n) {
        d.distance = std::max(d.distance, std::abs(y.numbers[n] - x.numbers[n]));
      }
    }
  }

  Comparison& c_;
  std::uint32_t i_, j_;
  const Body& x_;
  const Body& y_;
};

}  // namespace

void compare_shapes(Comparison& comparison, std::uint32_t body) {
  ShapeComparer comparer(comparison, body);
  const Body& x = comparison.a.bodies[body];
  const Body& y = comparison.b.bodies[comparison.match.a.body[body]];
  comparer.compare(kCollisionKinds, x.collisions, y.collisions);
  comparer.compare(kVisualKinds, x.visuals, y.visuals);
}

}  // namespace rigor::robot
