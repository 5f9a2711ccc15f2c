// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/srdf/group_finder.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

namespace rigor::author {
namespace {

using robot::kNoIndex;
using robot::Robot;

/// A gripper's fingers are at most this share of the arm that carries it; a torso's arms are longer than the torso.
constexpr double kGripperShare = 0.5;
constexpr std::size_t kMinChainJoints = 2;

/// The shared beginning of names up to the last separator: "left_arm" of "left_arm_1" and "left_arm_2".
std::string shared_prefix(const std::vector<std::string>& names) {
  if (names.empty()) return {};
  std::string prefix = names.front();
  for (const std::string& name : names) {
    std::size_t same = 0;
    while (same < prefix.size() && same < name.size() && prefix[same] == name[same]) ++same;
    prefix.resize(same);
  }
  if (names.size() == 1) return prefix;
  const std::size_t last = prefix.find_last_not_of("_-/:.0123456789");
  prefix.resize(last == std::string::npos ? 0 : last + 1);
  for (const char* noun : {"_joint", "_link"}) {
    if (prefix.ends_with(noun)) prefix.resize(prefix.size() - std::string_view(noun).size());
  }
  return prefix;
}

class GroupFinder {
 public:
  explicit GroupFinder(const Robot& robot) : robot_(robot), children_(robot.bodies.size()) {
    for (const std::uint32_t body : robot.order) {
      const std::uint32_t carrier = robot.bodies[body].carrier;
      if (carrier != kNoIndex) children_[robot.joints[carrier].parent].push_back(body);
    }
    moving_.resize(robot.bodies.size());
    reach_.resize(robot.bodies.size());
    for (auto body = robot.order.rbegin(); body != robot.order.rend(); ++body) {
      const std::uint32_t carrier = robot.bodies[*body].carrier;
      if (carrier == kNoIndex) continue;
      const robot::Joint& joint = robot.joints[carrier];
      moving_[joint.parent] += moving_[*body] + (joint.axes.empty() ? 0U : 1U);
      reach_[joint.parent] =
          std::max(reach_[joint.parent], reach_[*body] + length(joint.X_PJ.translation));
    }
  }

  FoundGroups find() && {
    for (const std::uint32_t body : robot_.order) {
      if (robot_.bodies[body].carrier != kNoIndex) continue;
      if (result_.root == kNoIndex) result_.root = body;
      pending_.push_back({body});
      while (!pending_.empty()) {
        const Start start = pending_.back();
        pending_.pop_back();
        walk(start);
      }
    }
    name_groups();
    return std::move(result_);
  }

 private:
  /// Where a run begins: at a body, or at one of a branching body's children.
  struct Start {
    std::uint32_t base = kNoIndex;
    std::uint32_t child = kNoIndex;
  };

  struct Run {
    std::uint32_t base = kNoIndex;
    std::uint32_t last_moved = kNoIndex;  // child of the last joint that moves
    std::uint32_t end = kNoIndex;         // where it branches, or nothing moves any more
    std::vector<std::uint32_t> joints;
    double length = 0;  // m, along the joints
  };

  const robot::Joint* carrier(std::uint32_t body) const {
    const std::uint32_t joint = robot_.bodies[body].carrier;
    return joint == kNoIndex ? nullptr : &robot_.joints[joint];
  }
  bool moves(std::uint32_t body) const { return carrier(body) && !carrier(body)->axes.empty(); }
  bool has_surface(std::uint32_t body) const {
    return !robot_.bodies[body].collisions.empty() || !robot_.bodies[body].visuals.empty();
  }
  const std::string& name(std::uint32_t body) const { return robot_.bodies[body].name; }

  std::vector<std::uint32_t> moving_branches(std::uint32_t body) const {
    std::vector<std::uint32_t> found;
    for (const std::uint32_t child : children_[body]) {
      if (moves(child) || moving_[child] > 0) found.push_back(child);
    }
    return found;
  }

  void step(Run& run, std::uint32_t child) const {
    const robot::Joint& joint = *carrier(child);
    run.length += length(joint.X_PJ.translation);
    if (!joint.axes.empty()) {
      run.joints.push_back(robot_.bodies[child].carrier);
      run.last_moved = child;
    }
    run.end = child;
  }

  Run run_from(const Start& start) const {
    Run run{.base = start.base, .end = start.base};
    if (start.child != kNoIndex) {
      step(run, start.child);
      if (run.joints.empty()) run.base = start.child;
    }
    for (;;) {
      const auto branches = moving_branches(run.end);
      if (branches.size() != 1) break;
      // What ties the robot to the world is no part of an arm.
      if (run.joints.empty() && name(run.base) == robot::kWorldBody) run.base = branches[0];
      step(run, branches[0]);
      if (run.joints.empty() && run.base == run.end) run.length = 0;
    }
    return run;
  }

  /// Of the lines of fixed links behind it the longest.
  std::uint32_t fixed_end(std::uint32_t body) const {
    std::uint32_t farthest = body;
    std::size_t most = 0;
    std::vector<std::pair<std::uint32_t, std::size_t>> open{{body, 0}};
    while (!open.empty()) {
      const auto [at, depth] = open.back();
      open.pop_back();
      if (depth > most) std::tie(farthest, most) = std::pair(at, depth);
      for (auto child = children_[at].rbegin(); child != children_[at].rend(); ++child)
        open.emplace_back(*child, depth + 1);
    }
    return farthest;
  }

  void walk(const Start& start) {
    const Run run = run_from(start);
    const auto branches = moving_branches(run.end);
    const bool is_chain = run.joints.size() >= kMinChainJoints;
    if (branches.empty()) {
      if (is_chain)
        add_chain(run, fixed_end(run.end));
      else if (run.joints.size() == 1)
        note_wheel(run);
      return;
    }
    if (is_chain && reach_[run.end] <= kGripperShare * run.length) {
      std::uint32_t palm = run.end;
      while (palm != run.last_moved && carrier(palm)->parent != run.last_moved &&
             has_surface(carrier(palm)->parent))
        palm = carrier(palm)->parent;
      const bool separate = palm != run.last_moved;
      const std::uint32_t tip = separate ? carrier(palm)->parent : palm;
      add_chain(run, tip);
      add_gripper(separate ? std::vector{palm} : branches, name(tip), result_.groups.size() - 1);
      return;
    }
    if (run.joints.empty() && is_one_gripper()) return add_gripper(branches, {}, kNoIndex);
    if (is_chain) add_chain(run, run.end);
    for (auto branch = branches.rbegin(); branch != branches.rend(); ++branch)
      pending_.push_back({run.end, *branch});
  }

  void note_wheel(const Run& run) {
    const robot::Axis& axis = robot_.joints[run.joints[0]].axes[0];
    if (axis.motion == robot::Axis::Motion::kTurn && !std::isfinite(axis.lower) &&
        !std::isfinite(axis.upper))
      result_.has_wheels = true;
  }

  /// All that moves follows one axis.
  bool is_one_gripper() const {
    std::size_t free = 0, all = 0;
    for (const robot::Joint& joint : robot_.joints) {
      for (const robot::Axis& axis : joint.axes) {
        ++all;
        if (!axis.follow) ++free;
      }
    }
    return free == 1 && all > 1;
  }

  void add_chain(const Run& run, std::uint32_t tip) {
    FoundGroup found{.group = {.name = {}, .base_link = name(run.base), .tip_link = name(tip)},
                     .joints = run.joints};
    result_.groups.push_back(std::move(found));
  }

  void add_gripper(const std::vector<std::uint32_t>& from, const std::string& parent_link,
                   std::size_t chain) {
    FoundGroup found;
    std::vector<std::uint32_t> open(from.rbegin(), from.rend());
    while (!open.empty()) {
      const std::uint32_t body = open.back();
      open.pop_back();
      found.group.links.push_back(name(body));
      if (moves(body)) {
        found.group.joints.push_back(carrier(body)->name);
        found.joints.push_back(robot_.bodies[body].carrier);
      }
      open.insert(open.end(), children_[body].rbegin(), children_[body].rend());
    }
    found.parent_link = parent_link;
    chain_of_.emplace_back(result_.groups.size(), chain);
    result_.groups.push_back(std::move(found));
  }

  bool is_gripper(const FoundGroup& found) const { return !found.group.links.empty(); }

  /// One chain is `arm`; of several, each is named by what the names of its joints share, or by its tip.
  void name_groups() {
    const auto& groups = result_.groups;
    const auto chains = static_cast<std::size_t>(std::count_if(
        groups.begin(), groups.end(), [&](const auto& found) { return !is_gripper(found); }));
    const std::size_t grippers = groups.size() - chains;
    std::set<std::string> taken;
    for (FoundGroup& found : result_.groups) {
      const bool gripper = is_gripper(found);
      std::string name = gripper ? "gripper" : "arm";
      if ((gripper ? grippers : chains) > 1) {
        std::vector<std::string> names;
        for (const std::uint32_t j : found.joints) names.push_back(robot_.joints[j].name);
        name = shared_prefix(names);
        if (gripper && !name.ends_with("gripper")) name += name.empty() ? "gripper" : "_gripper";
        if (name.empty()) name = found.group.tip_link;
      }
      std::string free = name;
      for (int k = 2; !taken.insert(free).second; ++k) free = name + '_' + std::to_string(k);
      found.group.name = std::move(free);
    }
    for (const auto& [gripper, chain] : chain_of_) {
      if (chain < result_.groups.size())
        result_.groups[gripper].parent_group = result_.groups[chain].group.name;
    }
  }

  const Robot& robot_;
  std::vector<std::vector<std::uint32_t>> children_;
  std::vector<std::size_t> moving_;  // joints that move beyond a body
  std::vector<double> reach_;        // m, the longest way along joints beyond a body
  std::vector<Start> pending_;
  std::vector<std::pair<std::size_t, std::size_t>> chain_of_;
  FoundGroups result_;
};

}  // namespace

FoundGroups find_groups(const Robot& robot) { return GroupFinder(robot).find(); }

}  // namespace rigor::author
