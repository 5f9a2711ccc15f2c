// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Which of the format's lists of values libsdformat holds a file to.

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/read/conformance.h>
#include <rigor/read/values.h>
#include <rigor/rules/context.h>
#include <rigor/rules/edits.h>
#include <rigor/rules/schema/value_text.h>
#include <rigor/schema/suggest.h>

namespace rigor::rules {

/// Who reports a value that is in no list.
enum class ListKeeper {
  kOwnRule,    ///< the rule for types of joints, sensors or physics engines, or for mimics
  kRefuses,    ///< libsdformat refuses the file
  kUnchecked,  ///< not checked: the simulator does as it likes
};

inline bool of_force_torque_frame(const read::SchemaFact& fact) {
  return fact.element.name() == "frame" && fact.ancestor(1) == "force_torque";
}

inline bool of_camera_noise(const read::SchemaFact& fact) {
  return fact.element.name() == "type" && fact.ancestor(1) == "noise" &&
         fact.ancestor(2) == "camera";
}

inline ListKeeper keeper_of(const read::SchemaFact& fact) {
  const std::string_view element = fact.element.name();
  const std::string_view attribute = fact.attribute ? fact.attribute->name() : "";
  if (attribute == "type" && (element == "joint" || element == "sensor" || element == "physics")) {
    return ListKeeper::kOwnRule;
  }
  if (element == "mimic" && attribute == "axis") return ListKeeper::kOwnRule;
  const bool refused =
      (element == "light" && attribute == "type") || (element == "shader" && attribute == "type") ||
      element == "format" || (element == "particle_emitter" && attribute == "type") ||
      (element == "atmosphere" && attribute == "type") || element == "surface_model" ||
      element == "world_frame_orientation" || attribute == "rotation_format" ||
      of_force_torque_frame(fact) || of_camera_noise(fact);
  return refused ? ListKeeper::kRefuses : ListKeeper::kUnchecked;
}

/// Since when the value is one of the list, if a later version of the format has it; of that
/// `value-newer-than-version` speaks.
inline std::optional<schema::Version> listed_since(const read::SchemaFact& fact) {
  return fact.node->listed_since(read::trimmed(fact.text));
}

inline std::vector<std::string_view> listed_values(const read::SchemaFact& fact) {
  const auto known = fact.node->enumeration();
  return {known.begin(), known.end()};
}

/// "did you mean 'x'?", or the whole list.
inline std::string values_of(const read::SchemaFact& fact) {
  const std::vector<std::string_view> all = listed_values(fact);
  const auto near = schema::near(fact.text, all);
  if (!near.empty()) return "did you mean '" + std::string(near.front()) + "'?";
  std::string text;
  for (const std::string_view value : all) {
    text += (text.empty() ? "it is one of " : ", ") + std::string(value);
  }
  return text;
}

/// Reports it as one that is in no list.
inline void report_unlisted(const read::SchemaFact& fact, Context& context) {
  context.report({.where = fact.where,
                  .message = quoted_fault(fact) + " is none of the values of " + owner_of(fact),
                  .subject = subject_of(fact.element),
                  .help = values_of(fact),
                  .fix = nearest_instead(fact.text, listed_values(fact), fact.where)});
}

}  // namespace rigor::rules
