// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What the rules on conversions share: a note of the account as a finding.

#pragma once

#include <string>
#include <utility>

#include <rigor/convert/note.h>
#include <rigor/rules/context.h>

namespace rigor::rules {

/// The finding where the source says it.
inline Finding refused(const convert::Note& note, std::string message) {
  return {.where = note.where, .message = std::move(message), .subject = note.subject};
}

/// With the number of elements and attributes that were lost along with the one it points at.
inline Finding told(const convert::Note& note, std::string message) {
  if (note.outcome == convert::Outcome::kLost && note.count > 1) {
    message += " (" + std::to_string(note.count) + " elements and attributes)";
  }
  return refused(note, std::move(message));
}

/// Where a thing went that URDF itself cannot hold.
inline std::string whereabouts(const convert::Note& note) {
  return note.outcome == convert::Outcome::kLost ? "is lost" : "is for Gazebo only";
}

}  // namespace rigor::rules
