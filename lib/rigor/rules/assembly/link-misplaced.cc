// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <rigor/rules/assembly/placed_units.h>
#include <rigor/rules/assembly/undone_slips.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::link_misplaced {

using model::Vector3;

// Shares of the longest link. What is drawn leaves out brackets and cables, and toys have gaps between all
// of their links: nearer than kFar, it has to be the only one of a robot.
constexpr double kApart = 0.5;
constexpr double kFar = 3;
constexpr std::size_t kLinksOfRobot = 5;
constexpr double kTouching = 0.05;

// With more shapes or links, those that do not meet what carries them are not compared with all others.
constexpr std::size_t kMaxCompared = 2000;

// Where the boxes of some shapes are not known, they may be what is between.
constexpr double kFarApart = 10;

struct Misplaced {
  PlacedUnit unit;
  double gap = 0;   ///< m
  double size = 0;  ///< m, of the longest link
  Undone change;
  bool exchanged = false;  ///< whether two coordinates exchanged do as well
};

/// Links of the same model.
struct Company {
  std::size_t links = 0;
  double longest = 0;  ///< m
  bool complete = true;
};

using Companies = std::map<model::Id<model::Model>, Company>;

/// By the outermost model.
Companies companies_of(const robot::Assembled& robot) {
  Companies result;
  for (std::uint32_t i = 0; i < robot.links.size(); ++i) {
    Company& company = result[robot.links[i].top];
    ++company.links;
    company.longest = std::max(company.longest, robot.longest({i}));
    company.complete = company.complete && robot.links[i].complete();
  }
  return result;
}

/// Whether the joint's zero is a position that it can take.
bool can_be_zero(const model::Joint& joint) {
  if (joint.type != model::JointType::kPrismatic || joint.axes.empty()) return true;
  const model::Axis& axis = joint.axes.front();
  return !axis.limit_written || (axis.lower.value <= 0 && axis.upper.value >= 0);
}

/// m, of the link and the one that carries it; nothing when one has no shape.
std::optional<double> gap_to_carrier(std::uint32_t link, const robot::Assembled& robot,
                                     const Context& context, double enough) {
  const auto parent = context.frames().ends(robot.links[link].carrier).parent;
  if (!parent) return std::nullopt;
  std::optional<double> least;
  for (const std::uint32_t a : robot.links[link].shapes) {
    for (const std::uint32_t b : robot.links[parent.value].shapes) {
      const double apart = robot::separation(robot.shapes[a].box_W, robot.shapes[b].box_W);
      least = std::min(least.value_or(apart), apart);
      if (*least <= enough) return least;
    }
  }
  return least;
}

/// Whether it meets the link that carries it, as nearly all do. What is placed from the link that it carries moves
/// that along, so that this is no evidence.
bool meets_carrier(const PlacedUnit& unit, double enough, const robot::Assembled& robot,
                   const Context& context) {
  if (!robot.links[unit.link].carrier) return false;
  const auto parent = context.frames().ends(robot.links[unit.link].carrier).parent;
  if (!parent) return false;
  if (!context.is_urdf() && !context.root()[parent].pose.relative_to.value.empty()) return false;
  const auto gap = gap_to_carrier(unit.link, robot, context, enough);
  return gap && *gap <= enough;
}

/// Whether it is a body of its own in the world of an MJCF file, where several robots and loose things are one model.
bool stands_by_itself(const robot::AssembledLink& link, const Context& context) {
  if (context.root().format != model::Format::kMjcf) return false;
  if (!link.carrier) return true;
  const auto parent = context.frames().ends(link.carrier).parent;
  return !parent || context.root()[parent].name.value == "world";
}

/// Whether it touches the others with two coordinates exchanged.
bool touches_exchanged(const PlacedUnit& unit, const robot::Links& moved, const Company& company,
                       const robot::Assembled& robot) {
  const model::Vector3& written = unit.pose->pose.value.translation;
  for (const auto& [i, j] : {std::pair<std::size_t, std::size_t>{0, 1}, {1, 2}, {0, 2}}) {
    model::Vector3 value = written;
    std::swap(value.*kCoordinates[i], value.*kCoordinates[j]);
    if (value == written) continue;
    const auto gap = robot.gap(moved, shift_of(unit.pose->pose.value, unit.X_WL, value),
                               kTouching * company.longest);
    if (gap && *gap <= kTouching * company.longest) return true;
  }
  return false;
}

std::optional<Misplaced> look_at(const PlacedUnit& unit, const Company& company,
                                 const MovedLinks& moved_links, Context& context) {
  const robot::Assembled& robot = context.assembled();
  if (company.links < 2 || (unit.joint && !can_be_zero(*unit.joint))) return std::nullopt;
  const double apart = (company.complete ? kApart : kFarApart) * company.longest;
  if (meets_carrier(unit, apart, robot, context) || is_eye(unit.link, context)) return std::nullopt;
  if (std::max(robot.shapes.size(), robot.links.size()) > kMaxCompared) return std::nullopt;
  const robot::Links moved = moved_links.with(unit.link);
  const auto gap = robot.gap(moved, {}, apart);
  if (!gap || !(*gap > apart)) return std::nullopt;
  for (Undone& change : undone_slips(unit.pose->pose.value.translation)) {
    const Vector3 shift = shift_of(unit.pose->pose.value, unit.X_WL, change.value);
    const auto then = robot.gap(moved, shift, kTouching * company.longest);
    if (then && *then <= kTouching * company.longest)
      return Misplaced{unit, *gap, company.longest, std::move(change),
                       touches_exchanged(unit, moved, company, robot)};
  }
  return std::nullopt;
}

/// Of two that are joined, the one that is farther off took the other from its neighbor.
bool follows_from(const Misplaced& one, const Misplaced& other, const robot::Assembled& robot) {
  if (other.gap <= one.gap) return false;
  const auto& carried = robot.links[other.unit.link].links_carried;
  const auto& carries = robot.links[one.unit.link].links_carried;
  return std::count(carried.begin(), carried.end(), one.unit.link) > 0 ||
         std::count(carries.begin(), carries.end(), other.unit.link) > 0;
}

void check(const model::Root& root, Context& context) {
  if (root.links.size() < 2 || !context.frames().problems().empty()) return;
  const robot::Assembled& robot = context.assembled();
  std::vector<Misplaced> found;
  const Companies companies = companies_of(robot);
  const MovedLinks moved(context);
  for (const PlacedUnit& unit : placed_units(context)) {
    // What no joint holds may lie anywhere.
    const robot::AssembledLink& link = robot.links[unit.link];
    if (!link.carrier && link.links_carried.empty()) continue;
    if (stands_by_itself(link, context)) continue;
    const Company& company = companies.at(link.top);
    if (auto misplaced = look_at(unit, company, moved, context))
      found.push_back(*std::move(misplaced));
  }
  for (const Misplaced& one : found) {
    const auto explains = [&](const Misplaced& other) { return follows_from(one, other, robot); };
    if (std::any_of(found.begin(), found.end(), explains)) continue;
    const auto top = robot.links[one.unit.link].top;
    const auto beside = std::count_if(found.begin(), found.end(), [&](const Misplaced& other) {
      return robot.links[other.unit.link].top == top;
    });
    const bool is_odd = beside == 1 && companies.at(top).links >= kLinksOfRobot;
    if (one.gap < kFar * one.size && !is_odd) continue;
    const model::Link& link = root.links[one.unit.link];
    context.report(
        {.where = place_of(*one.unit.pose, context),
         .message = fmt::format(
             "link '{}' is {:.3g} m away from all other links, the longest of which is {:.3g} m",
             link.name.value, one.gap, one.size),
         .subject = one.unit.joint ? context.subject(*one.unit.joint) : context.subject(link),
         .help = fmt::format("with {} it touches them: {}", written_as(one.change.value),
                             one.change.slip),
         .fix = one.exchanged ? std::nullopt
                              : translation_fix(*one.unit.pose, one.change.value, context),
         // A sensor on a mast that is not drawn is no farther away than the robot is long.
         .severity = one.gap < one.size ? Severity::kInfo : Severity::kWarning});
  }
}

Rule rule() {
  return {
      .name = "link-misplaced",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "a link is far from all that it should touch",
      .why = "The robot is simulated in pieces: the link swings at the end of an invisible lever, "
             "and the robot's center of mass lies outside of it. The joint's origin, or the "
             "link's pose, is written in millimeters or centimeters, or its decimal point or sign "
             "is wrong: with that undone the link touches the others. Shapes are compared as "
             "boxes, with all joints at zero; with more than 2,000 shapes or links each only "
             "with the one that carries it.",
      .what_to_do = "Write the origin in meters. `rigor inspect --assembled` prints the distances.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::link_misplaced
