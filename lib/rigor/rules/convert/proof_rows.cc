// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What reading the result again proves.

#include <span>

#include <rigor/rules/convert/rows.h>

namespace rigor::rules::conversion {

using convert::NoteKind;

std::span<const Row> proof_rows() {
  static constexpr Row kRows[] = {
      {.rule = {"convert-not-the-same", NoteKind::kNotTheSame, Severity::kError},
       .message = "not the same robot: {written}",
       .summary = "the result is another robot",
       .why = "What was written is read again and moved through random joint positions beside the "
              "source; here the two are not the same. Either a loss that was allowed shows, or "
              "rigor has an error.",
       .what_to_do = "Look at the losses above it; when there is none, please report it."},
      {.rule = {"convert-rejected", NoteKind::kRefused, Severity::kError},
       .message = "urdfdom rejects the result: {written}",
       .summary = "the official parser rejects the result",
       .why = "Whatever reads the file next will reject it as well.",
       .what_to_do = "Please report it, with the file."},
      {.rule = {"convert-rejected-by-libsdformat", NoteKind::kRefusedSdf, Severity::kError},
       .message = "libsdformat rejects the result: {written}",
       .summary = "libsdformat would reject the result",
       .why =
           "libsdformat 12, which Gazebo loads SDF with, rejects a file for this; the source has "
           "it already, and the conversion keeps what the source says.",
       .what_to_do =
           "Correct the source. For an inertia: `--inertia nearest` writes the nearest that a "
           "rigid "
           "body can have, and `rigor inertia MODEL --diff` computes one from the shapes. "
           "`--allow-loss` writes the result in any case."},
      {.rule = {"convert-reference-lost", NoteKind::kDangling, Severity::kWarning, Formats::kUrdf},
       .message = "in the result {written}",
       .summary = "a reference of the result is undefined",
       .why = "A plugin or sensor of the source names something that the result does not have "
              "under this name: it will not work in Gazebo.",
       .what_to_do = "Give the plugin the name that the result has."},
  };
  return kRows;
}

}  // namespace rigor::rules::conversion
