// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/robot/compare_match.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>

#include <rigor/robot/compare_near.h>

namespace rigor::robot {
namespace {

/// How many links with as many parts under one parent are tried as the new name
/// of one: a file decides how many there are.
constexpr std::size_t kMaxCandidates = 16;

/// Who has a name, in order: a file may give it twice.
class NameIndex {
 public:
  template <class T>
  explicit NameIndex(const std::vector<T>& all) {
    for (std::uint32_t i = 0; i < all.size(); ++i) {
      exact_[all[i].name].owners.push_back(i);
      plain_[plain_name(all[i].name)].owners.push_back(i);
    }
  }

  /// The first of the name that is not taken yet; kNoIndex when there is none.
  std::uint32_t find(const std::string& name, const std::vector<std::uint32_t>& taken) {
    const std::uint32_t found = first_free(exact_, name, taken);
    return found != kNoIndex ? found : first_free(plain_, plain_name(name), taken);
  }

 private:
  struct Owners {
    std::vector<std::uint32_t> owners;
    std::size_t next = 0;
  };
  using Table = std::unordered_map<std::string, Owners>;

  static std::uint32_t first_free(Table& table, const std::string& name,
                                  const std::vector<std::uint32_t>& taken) {
    const auto found = table.find(name);
    if (found == table.end()) return kNoIndex;
    auto& [owners, next] = found->second;
    while (next < owners.size() && taken[owners[next]] != kNoIndex) ++next;
    return next < owners.size() ? owners[next] : kNoIndex;
  }

  Table exact_, plain_;
};

std::uint32_t parent_body(const Robot& robot, std::uint32_t body) {
  const std::uint32_t carrier = robot.bodies[body].carrier;
  return carrier == kNoIndex ? kNoIndex : robot.joints[carrier].parent;
}

bool same_parts(const std::vector<Part>& a, const std::vector<Part>& b,
                const Tolerance& tolerance) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&tolerance](const Part& x, const Part& y) {
                      return near(x.X_BS, y.X_BS, tolerance) && near(x.shape, y.shape, tolerance);
                    });
}

bool same_content(const Body& a, const Body& b, const Tolerance& tolerance) {
  return near(a.mass.mass, b.mass.mass, tolerance) && near(a.mass.com, b.mass.com, tolerance) &&
         near(a.mass.about_com, b.mass.about_com, tolerance) &&
         same_parts(a.collisions, b.collisions, tolerance) &&
         same_parts(a.visuals, b.visuals, tolerance);
}

class RobotMatcher {
 public:
  RobotMatcher(const Robot& a, const Robot& b, const Correspondence& names,
               const Tolerance& tolerance)
      : a_(a), b_(b), names_(names), tolerance_(tolerance) {}

  Match match() {
    start(a_, match_.a);
    start(b_, match_.b);
    match_.renamed_body.resize(a_.bodies.size());
    match_.renamed_joint.resize(a_.joints.size());
    match_.substitutes.resize(a_.joints.size());
    bodies_by_name();
    joints_by_name();
    bodies_by_joint();
    bodies_by_content();
    joints_by_ends();
    match_axes();
    find_ancestors(a_, match_.a);
    find_ancestors(b_, match_.b);
    find_reference();
    find_root_joint(a_, match_.a);
    find_root_joint(b_, match_.b);
    find_silent(a_, b_, match_.a);
    find_silent(b_, a_, match_.b);
    return std::move(match_);
  }

 private:
  static void start(const Robot& robot, Match::Side& side) {
    side.body.assign(robot.bodies.size(), kNoIndex);
    side.joint.assign(robot.joints.size(), kNoIndex);
    side.ancestor.assign(robot.bodies.size(), kNoIndex);
    side.silent_body.resize(robot.bodies.size());
    side.silent_joint.resize(robot.joints.size());
  }

  void pair_bodies(std::uint32_t a, std::uint32_t b) {
    match_.a.body[a] = b;
    match_.b.body[b] = a;
  }
  void pair_joints(std::uint32_t a, std::uint32_t b) {
    match_.a.joint[a] = b;
    match_.b.joint[b] = a;
  }

  void bodies_by_name() {
    NameIndex in_b(b_.bodies);
    for (std::uint32_t i = 0; i < a_.bodies.size(); ++i) {
      const auto given = names_.links.find(a_.bodies[i].name);
      const std::string& name = given == names_.links.end() ? a_.bodies[i].name : given->second;
      const std::uint32_t found = in_b.find(name, match_.b.body);
      if (found != kNoIndex) pair_bodies(i, found);
    }
  }

  void joints_by_name() {
    NameIndex in_b(b_.joints);
    for (std::uint32_t i = 0; i < a_.joints.size(); ++i) {
      const auto given = names_.joints.find(a_.joints[i].name);
      if (given == names_.joints.end() || given->second.empty()) {
        const std::uint32_t found = in_b.find(a_.joints[i].name, match_.b.joint);
        if (found != kNoIndex) pair_joints(i, found);
        continue;
      }
      for (const std::string& name : given->second) {
        const std::uint32_t found = in_b.find(name, match_.b.joint);
        if (found == kNoIndex) continue;
        pair_joints(i, found);
        if (given->second.size() > 1) match_.substitutes[i].push_back(found);
      }
    }
  }

  /// At the ends of one joint: another name.
  void bodies_by_joint() {
    const auto pair = [this](std::uint32_t a, std::uint32_t b) {
      if (match_.a.body[a] != kNoIndex || match_.b.body[b] != kNoIndex) return;
      if (a_.bodies[a].name == kWorldBody || b_.bodies[b].name == kWorldBody) return;
      pair_bodies(a, b);
      match_.renamed_body[a] = true;
    };
    for (std::uint32_t i = 0; i < a_.joints.size(); ++i) {
      const std::uint32_t j = match_.a.joint[i];
      if (j == kNoIndex || !match_.substitutes[i].empty()) continue;
      pair(a_.joints[i].parent, b_.joints[j].parent);
      pair(a_.joints[i].child, b_.joints[j].child);
    }
  }

  /// Under the same parent, with the same content: another name.
  void bodies_by_content() {
    using Key = std::array<std::size_t, 3>;
    const auto key = [](const Body& body, std::uint32_t parent) {
      return Key{parent, body.collisions.size(), body.visuals.size()};
    };
    std::map<Key, std::vector<std::uint32_t>> free_in_b;
    for (const std::uint32_t i : b_.order) {
      if (match_.b.body[i] == kNoIndex && b_.bodies[i].name != kWorldBody) {
        free_in_b[key(b_.bodies[i], parent_body(b_, i))].push_back(i);
      }
    }
    if (free_in_b.empty()) return;
    for (const std::uint32_t i : a_.order) {
      if (match_.a.body[i] != kNoIndex || a_.bodies[i].name == kWorldBody) continue;
      const std::uint32_t parent = parent_body(a_, i);
      const std::uint32_t parent_b = parent == kNoIndex ? kNoIndex : match_.a.body[parent];
      if (parent != kNoIndex && parent_b == kNoIndex) continue;
      const auto group = free_in_b.find(key(a_.bodies[i], parent_b));
      if (group == free_in_b.end()) continue;
      std::size_t tried = 0;
      for (const std::uint32_t candidate : group->second) {
        if (match_.b.body[candidate] != kNoIndex || ++tried > kMaxCandidates) continue;
        if (!is_renamed(i, candidate)) continue;
        pair_bodies(i, candidate);
        match_.renamed_body[i] = true;
        break;
      }
    }
  }

  bool is_renamed(std::uint32_t a, std::uint32_t b) const {
    if (!same_content(a_.bodies[a], b_.bodies[b], tolerance_)) return false;
    const std::uint32_t joint_a = a_.bodies[a].carrier, joint_b = b_.bodies[b].carrier;
    if (joint_a == kNoIndex || joint_b == kNoIndex) return joint_a == joint_b;
    const Joint& x = a_.joints[joint_a];
    const Joint& y = b_.joints[joint_b];
    return match_.a.joint[joint_a] == joint_b ||
           (x.type == y.type && near(x.X_PJ, y.X_PJ, tolerance_));
  }

  void joints_by_ends() {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> free_in_b;
    for (std::uint32_t i = 0; i < b_.joints.size(); ++i) {
      if (match_.b.joint[i] != kNoIndex) continue;
      free_in_b.try_emplace({b_.joints[i].parent, b_.joints[i].child}, i);
    }
    for (std::uint32_t i = 0; i < a_.joints.size(); ++i) {
      if (match_.a.joint[i] != kNoIndex) continue;
      const Joint& joint = a_.joints[i];
      const auto found = free_in_b.find({match_.a.body[joint.parent], match_.a.body[joint.child]});
      if (found == free_in_b.end() || match_.b.joint[found->second] != kNoIndex) continue;
      pair_joints(i, found->second);
      match_.renamed_joint[i] = !joint.name.empty();
    }
  }

  void match_axes() {
    match_.axes.resize(a_.joints.size());
    for (std::uint32_t i = 0; i < a_.joints.size(); ++i) {
      const auto& several = match_.substitutes[i];
      for (std::uint32_t k = 0; k < a_.joints[i].axes.size(); ++k) {
        Match::Axis axis{several.empty() ? match_.a.joint[i] : kNoIndex, k};
        if (k < several.size()) axis = {several[k], 0};
        if (axis.joint != kNoIndex && axis.axis >= b_.joints[axis.joint].axes.size()) axis = {};
        match_.axes[i].push_back(axis);
      }
    }
  }

  static void find_ancestors(const Robot& robot, Match::Side& side) {
    for (const std::uint32_t i : robot.order) {
      const std::uint32_t parent = parent_body(robot, i);
      if (parent == kNoIndex) continue;
      side.ancestor[i] = side.body[parent] != kNoIndex ? parent : side.ancestor[parent];
    }
  }

  void find_reference() {
    for (const std::uint32_t i : a_.order) {
      if (match_.a.body[i] == kNoIndex) continue;
      match_.reference_a = i;
      match_.reference_b = match_.a.body[i];
      return;
    }
  }

  static void find_root_joint(const Robot& robot, Match::Side& side) {
    const auto root = std::find_if(robot.order.begin(), robot.order.end(), [&](std::uint32_t i) {
      return robot.bodies[i].name != kWorldBody;
    });
    if (root == robot.order.end() || side.body[*root] != kNoIndex) return;
    if (robot.bodies[*root].carrier != kNoIndex || !is_helper(robot.bodies[*root])) return;
    for (std::uint32_t i = 0; i < robot.joints.size(); ++i) {
      const Joint& joint = robot.joints[i];
      if (joint.parent != *root || side.body[joint.child] == kNoIndex) continue;
      if (is_fixed(joint)) side.root_joint = i;
      return;
    }
  }

  /// What only `robot` has and the other can do without.
  void find_silent(const Robot& robot, const Robot& other, Match::Side& side) const {
    std::set<std::uint32_t> substitutes;
    if (&robot == &b_) {
      for (const auto& several : match_.substitutes) {
        substitutes.insert(several.begin(), several.end());
      }
    }
    for (std::uint32_t i = 0; i < robot.bodies.size(); ++i) {
      if (side.body[i] != kNoIndex || !shapeless(robot.bodies[i])) continue;
      const std::uint32_t carrier = robot.bodies[i].carrier;
      const bool substitute = carrier != kNoIndex &&
                              (substitutes.contains(carrier) || follows_substitute(robot, carrier));
      const bool fixed = carrier == kNoIndex || is_fixed(robot.joints[carrier]);
      const bool world = robot.bodies[i].name == kWorldBody;
      side.silent_body[i] =
          substitute ||
          (names_.helpers == Helpers::kIgnored && fixed && is_helper(robot.bodies[i]) &&
           (!world || other.is_static.value_or(false) || stands_apart(other)));
    }
    for (std::uint32_t i = 0; i < robot.joints.size(); ++i) {
      if (side.joint[i] != kNoIndex) continue;
      const Joint& joint = robot.joints[i];
      const bool of_helper = side.silent_body[joint.parent] || side.silent_body[joint.child];
      const std::uint32_t child = side.body[joint.child];
      const bool free = joint.type == model::JointType::kFloating && child != kNoIndex &&
                        other.bodies[child].carrier == kNoIndex;
      side.silent_joint[i] =
          free || (of_helper && is_fixed(joint)) || (of_helper && follows_substitute(robot, i));
    }
  }

  /// What stands between substituted joints may need a little mass to live in a
  /// simulator.
  static bool shapeless(const Body& body) {
    return body.collisions.empty() && body.visuals.empty();
  }
  static bool is_fixed(const Joint& joint) { return joint.type == model::JointType::kFixed; }
  static bool stands_apart(const Robot& robot) {
    return robot.X_WM && *robot.X_WM != model::Pose{};
  }
  /// Half of a screw: it slides as the other half turns.
  static bool follows_substitute(const Robot& robot, std::uint32_t joint) {
    const auto& axes = robot.joints[joint].axes;
    return axes.size() == 1 && axes[0].follow.has_value();
  }

  const Robot& a_;
  const Robot& b_;
  const Correspondence& names_;
  const Tolerance& tolerance_;
  Match match_;
};

}  // namespace

bool is_helper(const Body& body) {
  return body.mass == mass::MassProperties{} && body.collisions.empty() && body.visuals.empty();
}

std::string plain_name(const std::string& name) {
  std::string plain;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const bool separator = name.compare(i, 2, "::") == 0;
    plain += separator ? "__" : std::string(1, name[i]);
    if (separator) ++i;
  }
  return plain;
}

Match match(const Robot& a, const Robot& b, const Correspondence& correspondence,
            const Tolerance& tolerance) {
  return RobotMatcher(a, b, correspondence, tolerance).match();
}

}  // namespace rigor::robot
