// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What the verbs of `rigor edit` are asked for on the command line; private to the command.

#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/author/verbs/change.h>

namespace rigor::tool {

/// The options of all verbs, as they are written; empty where they are not.
struct EditOptions {
  std::string to;
  std::string pose;
  std::string frame;
  std::string joint;
  std::string plane;
  std::string rename;
  std::string prefix;
  std::string target;
  std::string parameters;
  std::string tool_frame;
  std::string macro;
  std::vector<std::string> macro_parameters;
  std::string lower, upper, effort, velocity;
  std::string take, mass, name;  ///< of split; name of merge, too
  std::string max_error, from;   ///< of simplify-collisions
  std::string kind;              ///< of rename
  bool subtree = false;
  bool include = false;     ///< of attach and merge
  bool allow_loss = false;  ///< of downgrade
};

struct EditRequest {
  std::vector<std::string> words;  ///< before the files
  std::vector<std::string> files;  ///< the model's first
  std::vector<std::string> named;  ///< what the files were found by: themselves, or their folders
  std::vector<std::string> found;  ///< others of its workspace that may hold a name of the model
  std::string tool;                ///< the file behind the model's of a verb that `takes_tool`
  std::string out;                 ///< where the result goes; empty when that is not said
  EditOptions options;
};

struct EditVerb {
  std::string_view name;
  std::string_view words;  ///< "OLD NEW"; separated by a blank, empty for none
  /// Options that it takes, by their names on the command line, separated by blanks.
  std::string_view options;
  author::Change (*change)(const EditRequest& request, author::ModelReader& reader,
                           const author::EditedModel& edited);
  /// Whether a second model is read, which stays as it is: FILE TOOL.
  bool takes_tool = false;
  /// Whether other files of the workspace go along.
  bool searches = false;
};

/// All but `rename`, `upgrade` and `downgrade`.
std::span<const EditVerb> edit_verbs();

}  // namespace rigor::tool
