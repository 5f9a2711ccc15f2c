// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/robot/assembled/travel.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <variant>

namespace rigor::robot {
namespace {

/// Of positions that are added up along a tree, m.
constexpr double kRounding = 1e-9;

/// Whether the file says how large a shape is: what cannot be read has the size of a default, a meter.
struct HasWrittenSize {
  bool operator()(const model::Box& box) const { return box.size.written; }
  bool operator()(const model::Sphere& ball) const { return ball.radius.written; }
  bool operator()(const model::Ellipsoid& shape) const { return shape.radii.written; }
  bool operator()(const model::Cylinder& shape) const { return has_both(shape); }
  bool operator()(const model::Cone& shape) const { return has_both(shape); }
  bool operator()(const model::Capsule& shape) const { return has_both(shape); }
  template <class Other>
  bool operator()(const Other& /*other*/) const {
    return true;
  }

 private:
  template <class Round>
  static bool has_both(const Round& shape) {
    return shape.radius.written && shape.length.written;
  }
};

bool has_written_size(const AssembledShape& shape, const model::Root& root) {
  const model::Geometry& geometry = shape.role == ShapeRole::kCollision
                                        ? root.collisions[shape.index].geometry
                                        : root.visuals[shape.index].geometry;
  return std::visit(HasWrittenSize{}, geometry.shape);
}

std::vector<OrientedBox> child_at(const JointSides& sides, double position) {
  const model::Quaternion turn =
      sides.slides ? model::Quaternion{} : model::from_axis_angle(sides.axis_W, position);
  const model::Vector3 shift = sides.slides ? position * sides.axis_W : model::Vector3{};
  std::vector<OrientedBox> boxes = sides.child;
  for (OrientedBox& box : boxes) {
    box.center_W = sides.pivot_W + shift + rotate(turn, box.center_W - sides.pivot_W);
    for (model::Vector3& axis : box.axes_W) axis = rotate(turn, axis);
  }
  return boxes;
}

}  // namespace

RigidGroups::RigidGroups(const model::Root& root, const model::Frames& frames,
                         const Assembled& robot)
    : fixed_to(robot.links.size()), leaders(robot.links.size()), members(robot.links.size()) {
  for (std::uint32_t i = 0; i < fixed_to.size(); ++i) {
    fixed_to[i] = i;
    const auto carrier = robot.links[i].carrier;
    if (!carrier || root[carrier].type != model::JointType::kFixed) continue;
    if (const auto parent = frames.ends(carrier).parent) fixed_to[i] = parent.value;
  }
  std::vector<bool> known(fixed_to.size(), false);
  for (std::uint32_t i = 0; i < leaders.size(); ++i) {
    Links chain;
    std::uint32_t link = i;
    // A cycle of fixed joints is left where it closes.
    for (; !known[link] && fixed_to[link] != link; link = fixed_to[link]) {
      known[link] = true;
      leaders[link] = link;
      chain.push_back(link);
    }
    const std::uint32_t leader = known[link] ? leaders[link] : link;
    for (const std::uint32_t one : chain) leaders[one] = leader;
    known[link] = true;
    leaders[link] = leader;
    members[leaders[i]].push_back(i);
  }
}

bool RigidGroups::is_fixed_to(std::uint32_t link, std::uint32_t base) const {
  for (std::size_t steps = 0; link != base && steps < fixed_to.size(); ++steps) {
    if (fixed_to[link] == link) return false;
    link = fixed_to[link];
  }
  return link == base;
}

std::optional<Range> limited_range(const model::Joint& joint) {
  if (joint.type != model::JointType::kRevolute && joint.type != model::JointType::kPrismatic)
    return std::nullopt;
  if (joint.axes.size() != 1 || !joint.axes.front().limit_written) return std::nullopt;
  const Range range{joint.axes.front().lower.value, joint.axes.front().upper.value};
  constexpr double kWidest = 100;  // rad or m
  if (!(range.lower < range.upper) || !(range.upper - range.lower < kWidest)) return std::nullopt;
  return range;
}

Stand JointSides::at(double position) const {
  double gap = std::numeric_limits<double>::infinity();
  for (const OrientedBox& box : child_at(*this, position)) {
    for (const OrientedBox& other : parent) {
      const double apart = model::length(other.center_W - box.center_W);
      if (apart - (diameter(box) + diameter(other)) / 2 >= gap) continue;
      gap = std::min(gap, std::max(0.0, separation(box, other)));
    }
  }
  return {position, gap < kRounding ? 0 : gap, inside(position)};
}

double JointSides::inside(double position) const {
  double volume = 0, shared = 0;
  for (const OrientedBox& box : child_at(*this, position)) {
    const double size = box.half[0] * box.half[1] * box.half[2];
    volume += size;
    shared += size * share_inside(box, parent);
  }
  return volume > 0 ? shared / volume : 0;
}

std::vector<Stand> JointSides::between(const Range& range) const {
  std::vector<Stand> stands;
  for (const double position : positions_in(range)) stands.push_back(at(position));
  return stands;
}

std::vector<double> positions_in(const Range& range) {
  const auto [lower, upper] = range;
  constexpr int kSteps = 8;
  std::vector<double> positions;
  for (int i = 0; i <= kSteps; ++i) positions.push_back(lower + (upper - lower) * i / kSteps);
  const auto after = std::find_if(positions.begin(), positions.end(),
                                  [](double position) { return position >= 0; });
  if (lower < 0 && after != positions.end() && *after > 0) positions.insert(after, 0);
  return positions;
}

std::optional<JointSides> sides_of(model::Id<model::Joint> joint, const model::Root& root,
                                   const model::Frames& frames, const Assembled& robot,
                                   const RigidGroups& rigid) {
  const model::JointType type = root[joint].type;
  const bool slides = type == model::JointType::kPrismatic;
  if (!slides && type != model::JointType::kRevolute) return std::nullopt;
  const auto& ends = frames.ends(joint);
  const auto X_WJ = frames.pose(joint);
  const auto axis_W = frames.axis(joint, 0);
  if (!ends.parent || !ends.child || !X_WJ || !axis_W) return std::nullopt;
  if (robot.links[ends.child.value].carrier != joint) return std::nullopt;
  JointSides sides{{}, {}, X_WJ->translation, *axis_W, slides};
  const auto boxes_of = [&](std::uint32_t leader, std::vector<OrientedBox>& boxes) {
    for (const std::uint32_t i : rigid.members[leader]) {
      if (!robot.links[i].complete()) return false;
      for (const std::uint32_t s : robot.links[i].shapes) {
        if (!has_written_size(robot.shapes[s], root)) return false;
        boxes.push_back(robot.shapes[s].box_W);
      }
    }
    return !boxes.empty();
  };
  if (!boxes_of(rigid.leaders[ends.child.value], sides.child)) return std::nullopt;
  if (!boxes_of(rigid.leaders[ends.parent.value], sides.parent)) return std::nullopt;
  return sides;
}

}  // namespace rigor::robot
