// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Which body, joint and axis of one robot is which of the other; private to the
// room.

#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <rigor/robot/compare.h>

namespace rigor::robot {

struct Match {
  struct Axis {
    std::uint32_t joint = kNoIndex;
    std::uint32_t axis = 0;
  };
  struct Side {
    std::vector<std::uint32_t> body;  ///< the other's, of each body; kNoIndex for none
    std::vector<std::uint32_t>
        joint;  ///< the other's, of each joint; of a substituted one the last
    std::vector<std::uint32_t>
        ancestor;                   ///< the nearest matched body above each, kNoIndex for none
    std::vector<bool> silent_body;  ///< unmatched, and no difference: a helper or substitute
    std::vector<bool> silent_joint;
    /// The fixed joint by which a root that only this robot has, and that is but a frame, carries a matched
    /// body: the other may have that body as its root. kNoIndex for none.
    std::uint32_t root_joint = kNoIndex;
  };
  Side a, b;
  std::vector<bool> renamed_body;   ///< of A: paired by content, not by name
  std::vector<bool> renamed_joint;  ///< of A: paired by the links it connects
  std::vector<std::vector<std::uint32_t>>
      substitutes;                      ///< of each joint of A: several of B, or none
  std::vector<std::vector<Axis>> axes;  ///< of each joint of A and its axes: those of B
  /// The bodies of A and B that poses are expressed in: the first root of A that B
  /// has. None when no body is matched.
  std::uint32_t reference_a = kNoIndex;
  std::uint32_t reference_b = kNoIndex;
};

Match match(const Robot& a, const Robot& b, const Correspondence& correspondence,
            const Tolerance& tolerance);

/// Massless and without shapes: a frame with a name.
bool is_helper(const Body& body);

/// `a::b` and `a__b` are one name.
std::string plain_name(const std::string& name);

}  // namespace rigor::robot
