// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// An SRDF (http://wiki.ros.org/srdf/review) as it is written: what it refers to by name, chains, positions of
// joints, and the pairs of links that are not checked against each other. Whether the names exist decides
// robot/semantic/srdf_check.h.
//
//   const Srdf srdf = read_srdf(*document.root());
//   for (const SrdfReference& reference : srdf.references) look_up(reference.name.text);

#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <rigor/text/span.h>
#include <rigor/xml/document.h>

namespace rigor::read {

struct SrdfName {
  std::string text;
  Span where;  ///< of the text; nowhere when it is not written
};

enum class SrdfNameKind : std::uint8_t { kLink, kJoint, kGroup };

struct SrdfReference {
  SrdfNameKind kind = SrdfNameKind::kLink;
  SrdfName name;
};

struct SrdfChain {
  SrdfName base;
  SrdfName tip;
};

/// Of one joint in a `<group_state>`.
struct SrdfPosition {
  SrdfName joint;
  double value = 0;  ///< rad or m
  Span where;
  std::string state = {};  ///< name of the state
};

struct Srdf {
  SrdfName robot;
  std::set<std::string, std::less<>> groups;
  /// Joints that tie the robot to the world: the SRDF's own.
  std::set<std::string, std::less<>> virtual_joints;
  std::vector<SrdfReference> references;  ///< in the order of the file
  std::vector<SrdfChain> chains;
  std::vector<SrdfPosition> positions;  ///< of joints with one value; those of several are left out
  /// Of two links that are not checked, the one that sorts first stands first.
  std::set<std::pair<std::string, std::string>> disabled;
  /// Links that are checked against none but those that are named: `<disable_default_collisions>`.
  std::set<std::string, std::less<>> disabled_by_default;
};

/// Of a root `<robot>`; what is not understood is left out.
Srdf read_srdf(xml::Element root);

}  // namespace rigor::read
