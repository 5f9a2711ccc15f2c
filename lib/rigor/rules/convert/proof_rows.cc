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
      {.rule = {"convert-refused", NoteKind::kRefused, Severity::kError},
       .message = "urdfdom refuses the result: {written}",
       .summary = "the official parser refuses the result",
       .why = "Whatever reads the file next will refuse it as well.",
       .what_to_do = "Please report it, with the file."},
  };
  return kRows;
}

}  // namespace rigor::rules::conversion
