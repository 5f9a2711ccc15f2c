// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A tool that is a macro of a template, called in the template of an arm.
//
//   MacroRequest request;
//   request.attach.link = "tool0";
//   const Change change = attached_by_macro(reader, *arm, "gripper.xacro", request);
//
// A required parameter called `parent` (or one of its common synonyms) is the link, one called `prefix` the prefix, and a
// block called `origin` is the pose; others have to be given. A macro without such a parent gets a fixed joint. The
// robot that must come out is that of the arm with what the macro makes by itself.

#pragma once

#include <map>
#include <string>

#include <rigor/author/verbs/attach.h>

namespace rigor::author {

struct MacroRequest {
  AttachRequest attach;
  std::string macro;                              ///< its name; empty: the only one
  std::map<std::string, std::string> parameters;  ///< by name, as they are written
};

/// Refused: an arm that is no template, a macro that is not there or needs more parameters, names that are taken.
Change attached_by_macro(ModelReader& reader, const EditedModel& arm, const std::string& tool,
                         const MacroRequest& request);

}  // namespace rigor::author
