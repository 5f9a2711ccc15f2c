// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/robot/semantic/srdf_check.h>

#include <algorithm>
#include <string_view>
#include <tuple>

#include <rigor/model/motion.h>
#include <rigor/robot/semantic/soft_limits.h>

namespace rigor::robot {
namespace {

/// What people write for a limit has few digits; a state at the limit is within it.
constexpr double kLimitTolerance = 1e-4;

bool is_ancestor(const SemanticTarget& robot, const std::string& base, std::string_view tip) {
  // Where joints go round in a circle the way up has no end.
  for (std::size_t steps = 0; steps <= robot.parents.size(); ++steps) {
    if (tip == base) return true;
    const auto parent = robot.parents.find(tip);
    if (parent == robot.parents.end()) return false;
    tip = parent->second;
  }
  return false;
}

class SrdfChecker {
 public:
  SrdfChecker(const read::Srdf& srdf, const std::vector<const SemanticTarget*>& robots)
      : srdf_(srdf), robots_(robots) {}

  std::vector<SrdfFact> run() && {
    for (const read::SrdfReference& reference : srdf_.references) check_name(reference);
    for (const read::SrdfChain& chain : srdf_.chains) check_chain(chain);
    for (const read::SrdfPosition& position : srdf_.positions) check_position(position);
    check_neighbors();
    std::stable_sort(facts_.begin(), facts_.end(), [](const SrdfFact& a, const SrdfFact& b) {
      return a.where.begin < b.where.begin;
    });
    return std::move(facts_);
  }

 private:
  template <class Has>
  bool any(const Has& has) const {
    return std::any_of(robots_.begin(), robots_.end(),
                       [&](const auto* each) { return has(*each); });
  }

  bool has_link(const std::string& name) const {
    return any([&](const SemanticTarget& robot) { return robot.links.contains(name); });
  }

  void add_undefined(SrdfFactKind kind, const read::SrdfName& name) {
    facts_.push_back({.kind = kind, .where = name.where, .name = name.text});
  }

  void check_name(const read::SrdfReference& reference) {
    const std::string& name = reference.name.text;
    switch (reference.kind) {
      case read::SrdfNameKind::kLink:
        if (!has_link(name)) add_undefined(SrdfFactKind::kLinkUndefined, reference.name);
        return;
      case read::SrdfNameKind::kJoint:
        if (srdf_.virtual_joints.contains(name)) return;
        if (any([&](const SemanticTarget& robot) { return robot.joints.contains(name); })) return;
        return add_undefined(SrdfFactKind::kJointUndefined, reference.name);
      case read::SrdfNameKind::kGroup:
        if (!srdf_.groups.contains(name))
          add_undefined(SrdfFactKind::kGroupUndefined, reference.name);
        return;
    }
  }

  void check_chain(const read::SrdfChain& chain) {
    if (!has_link(chain.base.text) || !has_link(chain.tip.text)) return;  // reported by its name
    SrdfFact fact{.where = chain.tip.where, .name = chain.base.text, .other = chain.tip.text};
    if (chain.base.text == chain.tip.text) {
      fact.kind = SrdfFactKind::kChainEmpty;
    } else if (any([&](const SemanticTarget& robot) {
                 return is_ancestor(robot, chain.base.text, chain.tip.text);
               })) {
      return;
    } else {
      fact.kind = SrdfFactKind::kChainBroken;
    }
    facts_.push_back(std::move(fact));
  }

  void check_position(const read::SrdfPosition& position) {
    const JointRange* range = nullptr;
    for (const SemanticTarget* robot : robots_) {
      const auto joint = robot->joints.find(position.joint.text);
      if (joint == robot->joints.end()) continue;
      range = &joint->second;
      if (position.value >= range->lower - kLimitTolerance &&
          position.value <= range->upper + kLimitTolerance)
        return;
    }
    if (range == nullptr) return;
    facts_.push_back({.kind = SrdfFactKind::kStateOutside,
                      .where = position.where,
                      .name = position.joint.text,
                      .value = position.value,
                      .lower = range->lower,
                      .upper = range->upper,
                      .in_meters = range->in_meters});
  }

  void check_neighbors() {
    if (srdf_.disabled.empty() || robots_.empty()) return;
    SrdfFact fact{.kind = SrdfFactKind::kPairsChecked, .where = srdf_.robot.where};
    for (const auto& pair : robots_.front()->neighbors) {
      if (srdf_.disabled.contains(pair) || srdf_.disabled_by_default.contains(pair.first) ||
          srdf_.disabled_by_default.contains(pair.second))
        continue;
      const bool in_all =
          std::all_of(robots_.begin(), robots_.end(), [&](const SemanticTarget* robot) {
            return std::find(robot->neighbors.begin(), robot->neighbors.end(), pair) !=
                   robot->neighbors.end();
          });
      if (!in_all) continue;
      if (fact.count++ == 0) std::tie(fact.name, fact.other) = pair;
    }
    if (fact.count > 0) facts_.push_back(std::move(fact));
  }

  const read::Srdf& srdf_;
  const std::vector<const SemanticTarget*>& robots_;
  std::vector<SrdfFact> facts_;
};

}  // namespace

SemanticTarget semantic_target(const model::Root& root) {
  SemanticTarget target;
  std::set<std::string_view> with_collision;
  for (const model::Link& link : root.links) {
    target.links.insert(link.name.value);
    if (!link.collisions.empty()) with_collision.insert(link.name.value);
  }
  for (const model::Joint& joint : root.joints) {
    JointRange range;
    range.moves = joint.type != model::JointType::kFixed;
    range.in_meters = joint.type == model::JointType::kPrismatic;
    const bool is_limited =
        joint.type == model::JointType::kRevolute || joint.type == model::JointType::kPrismatic;
    if (is_limited && !joint.axes.empty() && joint.axes[0].limit_written) {
      const PositionRange bounds =
          within_soft_limits({model::position_limit(joint.axes[0].lower.value),
                              model::position_limit(joint.axes[0].upper.value)},
                             joint);
      range.lower = bounds.lower;
      range.upper = bounds.upper;
    }
    target.joints.emplace(joint.name.value, range);
    target.parents.emplace(joint.child.value, joint.parent.value);
    if (with_collision.contains(joint.parent.value) && with_collision.contains(joint.child.value))
      target.neighbors.push_back(std::minmax(joint.parent.value, joint.child.value));
  }
  return target;
}

std::vector<SrdfFact> check_srdf(const read::Srdf& srdf,
                                 const std::vector<const SemanticTarget*>& robots) {
  return SrdfChecker(srdf, robots).run();
}

}  // namespace rigor::robot
