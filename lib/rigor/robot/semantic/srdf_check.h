// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// An SRDF held against the robots that may be meant by it: names that do not exist, chains that are none,
// positions outside the limits, and neighbors that a planner would check against each other.
//
//   const SemanticTarget target = semantic_target(loaded.root);
//   for (const SrdfFact& fact : check_srdf(srdf, {&target})) explain(fact);

#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <rigor/model/model.h>
#include <rigor/read/srdf/srdf.h>
#include <rigor/text/span.h>

namespace rigor::robot {

struct JointRange {
  double lower = -std::numeric_limits<double>::infinity();  ///< rad or m
  double upper = std::numeric_limits<double>::infinity();
  bool moves = true;       ///< false of a fixed joint
  bool in_meters = false;  ///< of a prismatic joint; else an angle
};

/// What of a robot an SRDF refers to.
struct SemanticTarget {
  std::set<std::string, std::less<>> links;
  std::map<std::string, JointRange, std::less<>> joints;
  std::map<std::string, std::string, std::less<>> parents;  ///< of links, by the link
  /// Links that one joint connects, both with a collision; of two, the one that sorts first stands first.
  std::vector<std::pair<std::string, std::string>> neighbors;
};

/// Of a URDF, by the names that are written. Ranges are MoveIt's (soft_limits.h).
SemanticTarget semantic_target(const model::Root& root);

enum class SrdfFactKind : std::uint8_t {
  kLinkUndefined,
  kJointUndefined,
  kGroupUndefined,
  kChainEmpty,    ///< from a link to itself
  kChainBroken,   ///< the tip is not on a path of joints from the base
  kStateOutside,  ///< `value` is outside `lower` to `upper`
  kPairsChecked,  ///< `count` neighbors are not disabled; `name` and `other` are the first
};

struct SrdfFact {
  SrdfFactKind kind = SrdfFactKind::kLinkUndefined;
  Span where;
  std::string name;
  std::string other = {};
  double value = 0, lower = 0, upper = 0;  ///< rad, or m
  bool in_meters = false;
  std::size_t count = 0;
};

/// In the order of the file. Of several robots with one name it is enough that one of them has what is named, and
/// allows what is said. A pair that is reported is a neighbor in all of them. A file without `<disable_collisions>`
/// has no matrix, and none is missed.
std::vector<SrdfFact> check_srdf(const read::Srdf& srdf,
                                 const std::vector<const SemanticTarget*>& robots);

}  // namespace rigor::robot
