// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The file as a whole.

#include <span>

#include <rigor/rules/convert/rows.h>

namespace rigor::rules::conversion {

using convert::NoteKind;

std::span<const Row> file_rows() {
  static constexpr Row kRows[] = {
      {.rule = {"convert-several-models", NoteKind::kSeveralModels, Severity::kError},
       .message = "the file has several models: {written}; choose one with --model",
       .summary = "several models in the file, and none is selected for conversion",
       .why = "A URDF file holds one robot. Taking the first model of a world would be a guess, "
              "and converting all of them would weld strangers together.",
       .what_to_do = "Name the model: `--model NAME`."},
      {.rule = {"convert-no-model", NoteKind::kNoModel, Severity::kError},
       .message =
           [](const convert::Note& note) {
             return note.written.empty() ? "the file holds no model"
                                         : "the file holds no model {written}";
           },
       .summary = "there is no model to convert",
       .why = "The file holds no model, or none of the name that was asked for. An empty robot "
              "would be read as success by whatever runs next.",
       .what_to_do = "Name a file that holds a model, and one of its models."},
      {.rule = {"convert-world", NoteKind::kWorld, Severity::kWarning, Formats::kSdf},
       .message = "{written} of the world is not converted: a URDF has the robot alone",
       .summary = "content of the world outside the model is not in the robot",
       .why = "URDF describes one robot and nothing around it: gravity, lights, physics and other "
              "models of the world are not converted.",
       .what_to_do = "Keep the world file, and include the robot from it."},
      {.rule = {"convert-unresolved", NoteKind::kUnresolved, Severity::kError},
       .message = "{written}: the robot cannot be converted",
       .summary = "a reference or an include does not exist",
       .why = "Where a part of the model cannot be found or placed, any robot that is written "
              "would be another one.",
       .what_to_do = "Correct the reference; `rigor validate` lists what was tried."},
  };
  return kRows;
}

}  // namespace rigor::rules::conversion
