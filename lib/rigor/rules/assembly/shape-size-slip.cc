// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/core.h>

#include <rigor/rules/assembly/seen_shapes.h>
#include <rigor/rules/assembly/undone_slips.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::shape_size_slip {

// The box of a shape with the slip undone is that of the other shape; as written it is not.
constexpr double kSame = 0.95;
constexpr double kOther = 0.62;  // twice too long along one side, with some care

// A mesh is not as plain as the shape around it: less alike, and by more otherwise as written.
constexpr double kLikeMesh = 0.7;
constexpr double kUnlikeMesh = 0.4;

/// A number of a shape that is written, and what it would be.
struct Resized {
  model::Shape shape;
  std::vector<Edit> edits;
  std::string slip;
  Span where;
};

struct NamedFactor {
  double factor;
  const char* slip;
};
constexpr std::array<NamedFactor, 4> kOfRadius{{{0.5, "the diameter is written as the radius"},
                                                {2, "half of the radius is written"},
                                                {0.1, "the decimal point of the radius slipped"},
                                                {10, "the decimal point of the radius slipped"}}};
constexpr std::array<NamedFactor, 4> kOfLength{{{0.5, "the length is written twice as long"},
                                                {2, "half of the length is written"},
                                                {0.1, "the decimal point of the length slipped"},
                                                {10, "the decimal point of the length slipped"}}};

Edit number_edit(const model::Field<double>& field, double value) {
  return {field.span, write::joined({value})};
}

template <class Round>
void add_round(const Round& round, std::vector<Resized>& result) {
  if (!round.radius.written || !round.length.written) return;
  Round other = round;
  std::swap(other.radius.value, other.length.value);
  result.push_back({other,
                    {number_edit(round.radius, round.length.value),
                     number_edit(round.length, round.radius.value)},
                    "radius and length are exchanged",
                    round.radius.span});
  for (const auto& [factor, slip] : kOfRadius) {
    other = round;
    other.radius.value =
        write::settled(factor * round.radius.value, round.radius.value, round.radius.value);
    result.push_back(
        {other, {number_edit(round.radius, other.radius.value)}, slip, round.radius.span});
  }
  for (const auto& [factor, slip] : kOfLength) {
    other = round;
    other.length.value =
        write::settled(factor * round.length.value, round.length.value, round.length.value);
    result.push_back(
        {other, {number_edit(round.length, other.length.value)}, slip, round.length.span});
  }
}

void add_ball(const model::Sphere& ball, std::vector<Resized>& result) {
  if (!ball.radius.written) return;
  for (const auto& [factor, slip] : kOfRadius) {
    model::Sphere other = ball;
    other.radius.value =
        write::settled(factor * ball.radius.value, ball.radius.value, ball.radius.value);
    result.push_back(
        {other, {number_edit(ball.radius, other.radius.value)}, slip, ball.radius.span});
  }
}

void add_box(const model::Box& box, std::vector<Resized>& result) {
  if (!box.size.written) return;
  const auto add = [&](const model::Vector3& size, std::string slip) {
    model::Box other = box;
    other.size.value = size;
    result.push_back({other, {{box.size.span, written_as(size)}}, std::move(slip), box.size.span});
  };
  const model::Vector3& s = box.size.value;
  add({s.y, s.x, s.z}, "x and y are exchanged");
  add({s.z, s.y, s.x}, "x and z are exchanged");
  add({s.x, s.z, s.y}, "y and z are exchanged");
  add(2 * s, "half sides are written, as some engines have them");
  add(0.5 * s, "twice the sides are written");
  constexpr std::array<double, 2> kFactors{0.1, 10};
  for (std::size_t k = 0; k < 3; ++k) {
    for (const double factor : kFactors) {
      model::Vector3 size = s;
      size.*kCoordinates[k] =
          write::settled(factor * s.*kCoordinates[k], s.*kCoordinates[k], s.*kCoordinates[k]);
      add(size, fmt::format("{} is off by a factor of {}", coordinate_name(k),
                            factor < 1 ? 1 / factor : factor));
    }
  }
}

std::vector<Resized> resized(const model::Shape& shape) {
  std::vector<Resized> result;
  if (const auto* cylinder = std::get_if<model::Cylinder>(&shape)) add_round(*cylinder, result);
  if (const auto* capsule = std::get_if<model::Capsule>(&shape)) add_round(*capsule, result);
  if (const auto* ball = std::get_if<model::Sphere>(&shape)) add_ball(*ball, result);
  if (const auto* box = std::get_if<model::Box>(&shape)) add_box(*box, result);
  return result;
}

bool is_mesh(const SeenShape& one) {
  return std::holds_alternative<model::Mesh>(one.geometry->shape);
}

/// The change that makes one the size of the other, as nearly as any does.
std::optional<Resized> change_of(const SeenShape& one, const SeenShape& other) {
  const bool rough = is_mesh(other);
  if (rough && robot::likeness(one.bounds_L, other.bounds_L) > kUnlikeMesh) return std::nullopt;
  std::optional<Resized> best;
  double most = rough ? kLikeMesh : kSame;
  for (Resized& change : resized(one.geometry->shape)) {
    const auto bounds_S = robot::shape_bounds(change.shape, one.shape->role, {});
    if (!bounds_S) continue;
    const auto bounds_L = robot::bounds_of(robot::box_around(*bounds_S, one.shape->X_LS));
    const double then = robot::likeness(bounds_L, other.bounds_L);
    if (then < most || (best && then == most)) continue;
    most = then;
    best = std::move(change);
  }
  return best;
}

bool in_one_place(const SeenShape& a, const SeenShape& b) {
  // Of the smaller.
  const double near = is_mesh(a) || is_mesh(b) ? 0.15 : 0.02;
  const auto middle = [](const mesh::Bounds& box) { return 0.5 * (box.min + box.max); };
  const double size = std::min(mesh::diagonal(a.bounds_L), mesh::diagonal(b.bounds_L));
  return length(middle(a.bounds_L) - middle(b.bounds_L)) < near * size;
}

/// Whether the sizes are one in three directions but for a factor: that is visual-collision-scale's.
bool is_scaled(const SeenShape& a, const SeenShape& b) {
  constexpr double kEven = 1.1;
  const model::Vector3 p = sides(a.bounds_L), q = sides(b.bounds_L);
  const auto [least, most] = std::minmax({p.x / q.x, p.y / q.y, p.z / q.z});
  return most < kEven * least && (most > 5 || least < 0.2);
}

double largest_side(const SeenShape& one) {
  const model::Vector3 size = sides(one.bounds_L);
  return std::max({size.x, size.y, size.z});
}

/// How often shapes of other links have these sides, m.
std::size_t recurrences(const model::Vector3& size, std::uint32_t link,
                        const robot::Assembled& robot) {
  constexpr double kSameSides = 1e-3;
  return static_cast<std::size_t>(
      std::count_if(robot.shapes.begin(), robot.shapes.end(), [&](const auto& shape) {
        return shape.link != link &&
               length(sides(shape.bounds_L) - size) < kSameSides * length(size);
      }));
}

/// How far the moments of the link are from those of a solid box of these sides, as a logarithm; nothing when it
/// has none.
std::optional<double> unlike_moments(const model::Inertial& inertial, const model::Vector3& size) {
  const double trace = inertial.ixx.value + inertial.iyy.value + inertial.izz.value;
  if (!inertial.mass.written || !inertial.ixx.written || !(trace > 0) || !(inertial.mass.value > 0))
    return std::nullopt;
  const double power = std::round(std::log10(inertial.ixx.value));
  const bool placeholder = inertial.ixx.value == inertial.iyy.value &&
                           std::abs(std::log10(inertial.ixx.value) - power) < 1e-9;
  if (placeholder) return std::nullopt;
  const double solid = inertial.mass.value * dot(size, size) / 6;
  return std::abs(std::log(trace / solid));
}

/// Where either shape may be wrong: whether the visual is, by shapes of other links and by the moments; nothing
/// where these do not tell.
std::optional<bool> visual_is_wrong(const SeenShape& touched, const SeenShape& seen,
                                    std::uint32_t link, Context& context) {
  const model::Vector3 p = sides(touched.bounds_L), q = sides(seen.bounds_L);
  const std::size_t of_collision = recurrences(p, link, context.assembled());
  const std::size_t of_visual = recurrences(q, link, context.assembled());
  if ((of_collision > 0) != (of_visual > 0)) return of_collision > 0;
  constexpr double kNear = 1.4;     // a factor of 4
  constexpr double kClearly = 1.1;  // a factor of 3
  const model::Inertial& inertial = context.root().links[link].inertial;
  const auto a = unlike_moments(inertial, p), b = unlike_moments(inertial, q);
  if (!a || !b || std::min(*a, *b) > kNear || std::abs(*a - *b) < kClearly) return std::nullopt;
  return *b > *a;
}

bool is_ball(const SeenShape& one) {
  return std::holds_alternative<model::Sphere>(one.geometry->shape);
}

/// Whether a link is fixed to the end of one that turns, as a foot to a calf: its collision is meant to be larger than
/// what is drawn.
bool is_foot(std::uint32_t link, Context& context) {
  const auto& links = context.assembled().links;
  const auto carrier_type = [&](std::uint32_t i) {
    const auto carrier = links[i].carrier;
    return carrier ? context.root()[carrier].type : model::JointType::kUnknown;
  };
  if (!links[link].links_carried.empty() || carrier_type(link) != model::JointType::kFixed)
    return false;
  const auto parent = context.frames().ends(links[link].carrier).parent;
  return parent && carrier_type(parent.value) == model::JointType::kRevolute;
}

/// Whether another link has both sizes as well: then they are a choice.
bool recurs(const SeenShape& touched, const SeenShape& seen, std::uint32_t link, Context& context) {
  return recurrences(sides(touched.bounds_L), link, context.assembled()) > 0 &&
         recurrences(sides(seen.bounds_L), link, context.assembled()) > 0;
}

std::string message_of(const SeenShape& touched, const SeenShape& seen) {
  const model::Vector3 a = sides(touched.bounds_L), b = sides(seen.bounds_L);
  if (is_ball(touched) && is_ball(seen)) {
    return fmt::format("the collision's radius is {:.3g} m, the visual's {:.3g} m", a.x / 2,
                       b.x / 2);
  }
  return fmt::format(
      "the collision's sides are {:.3g} × {:.3g} × {:.3g} m, the visual's {:.3g} × {:.3g} × {:.3g} "
      "m",
      a.x, a.y, a.z, b.x, b.y, b.z);
}

void check_link(std::uint32_t link, Context& context) {
  const model::Root& root = context.root();
  const std::vector<SeenShape> all = seen_shapes(link, context);
  for (const SeenShape& touched : all) {
    if (!touched.is_collision()) continue;
    const auto fits = [&](const SeenShape& seen) {
      return !seen.is_collision() && robot::likeness(touched.bounds_L, seen.bounds_L) > kOther;
    };
    if (std::any_of(all.begin(), all.end(), fits)) continue;
    for (const SeenShape& seen : all) {
      if (seen.is_collision() || !in_one_place(touched, seen) || is_scaled(touched, seen)) continue;
      const bool balls = is_ball(touched) && is_ball(seen);
      if (balls && is_foot(link, context)) continue;
      auto of_collision = change_of(touched, seen);
      const auto of_visual = change_of(seen, touched);
      if (!of_collision && !of_visual) continue;
      bool decided = !balls || !recurs(touched, seen, link, context);
      if (of_collision && of_visual) {
        const auto wrong = visual_is_wrong(touched, seen, link, context);
        // A visual of twice the size would have been seen; which decimal point slipped is not known.
        constexpr double kDecimal = 5;
        const double larger = largest_side(touched) / largest_side(seen);
        decided = decided && (wrong || std::max(larger, 1 / larger) < kDecimal);
        if (wrong.value_or(false)) of_collision.reset();
      }
      const auto& change = of_collision ? of_collision : of_visual;
      const SeenShape& one = of_collision ? touched : seen;
      context.report(
          {.where = change->where,
           .message = message_of(touched, seen),
           .subject = subject_of_shape(one, context),
           .related = {{(of_collision ? seen : touched).geometry->site.name,
                        of_collision ? "the visual" : "the collision"}},
           .help = fmt::format("they are the same once undone: {}", change->slip),
           .fix = decided && root.own(one.geometry->site)
                      ? fix_of("make them the same", Applicability::kUnsafe, change->edits)
                      : std::nullopt});
      break;
    }
  }
}

void check(const model::Root& root, Context& context) {
  for (std::uint32_t i = 0; i < root.links.size(); ++i) {
    const model::Link& link = root.links[i];
    if (link.collisions.empty() || link.visuals.empty() || !root.own(link.site)) continue;
    check_link(i, context);
  }
}

Rule rule() {
  return {
      .name = "shape-size-slip",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "a collision has another size than its visual, by a slip",
      .why =
          "The robot touches what it does not reach, or reaches through what it touches; a "
          "wheel of twice the radius drives twice as fast. The two shapes lie in one place and "
          "are the same once a slip is undone: a diameter as the radius, radius and length "
          "exchanged, half sides, a decimal point. Where either can be wrong, it is the one that "
          "no other link has and that the moments of inertia do not fit; without such evidence "
          "the finding is at the collision, and has no fix. Balls at the ends of legs may have "
          "any size.",
      .what_to_do = "Write the size of the wrong one as in the other. SDF and URDF take radii, "
                    "and full sides of boxes.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::shape_size_slip
