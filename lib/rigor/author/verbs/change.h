// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a verb of `rigor edit` asks for, and its proof.
//
// A verb says two things that know nothing of each other: the edits, in the file's words, and the robot that must come
// out, computed from the robot before by the verb's law. `prove` does the edits, reads the result as any file is read,
// and compares it with that robot (robot/compare.h). So a verb that forgets a pose, or a template that uses a number
// twice, shows as a difference that nobody asked for.
//
//   const Change change = scaled(*edited, 2);
//   const ProvenChange proven = prove(reader, *edited, change);
//   if (proven.holds()) write(proven.files);
//
// In a template the edits are made where the author wrote what they change; what an expression computes is refused.

#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <rigor/author/verbs/edited_model.h>
#include <rigor/robot/compare.h>
#include <rigor/robot/robot.h>
#include <rigor/text/edit.h>

namespace rigor::author {

/// Whether what files say by name must mean as much after the change as before.
enum class References : std::uint8_t { kMayGo, kKept };

/// A file that the edited ones name and that is not there yet.
struct NewFile {
  std::string path;
  std::string bytes;
};

struct Change {
  /// Each to be done whole. In the sources of the model's file, or of others of the workspace.
  std::vector<std::vector<Edit>> steps;
  robot::Robot expected;  ///< the robot after it, by the verb's law
  /// Of the settings (convert/settings.h) that differ, those that were asked for; when empty, none.
  std::function<bool(const robot::Difference&)> asks_for_setting = {};
  References references = References::kMayGo;
  std::vector<std::string> notes;       ///< what is left to the author, a line each
  std::string refused;                  ///< why there is no change, as the end of a sentence
  std::vector<NewFile> new_files = {};  ///< to be written before those that change
  std::string product =
      {};  ///< a text of its own, which its verb has proven; then there are no steps
};

/// Whether a setting that differs is where something is: of verbs that move frames.
bool is_of_pose(const robot::Difference& difference);

/// A change that cannot be made.
Change refusal(std::string reason);

struct EditedFile {
  std::string path;
  SourceId source = kNoSource;  ///< of its bytes before
  std::vector<Edit> edits;
  std::string text;  ///< its bytes after
};

struct ProvenChange {
  std::vector<EditedFile> files;           ///< those that change
  std::vector<robot::Difference> asked;    ///< of the robot before and the one after
  std::vector<robot::Difference> unasked;  ///< of the robot that was expected and the one after
  std::string refused;                     ///< why there are no files, as the end of a sentence
  std::unique_ptr<EditedModel> after;      ///< null where it is refused

  bool holds() const { return refused.empty() && unasked.empty(); }
};

/// Views of the reader, which outlives the result.
ProvenChange prove(ModelReader& reader, const EditedModel& edited, const Change& change);

}  // namespace rigor::author
