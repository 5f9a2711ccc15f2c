// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The proof of a change to templates: each expands to the same bytes as before.
//
//   if (std::string fault = expansion_fault(context, {"robot.urdf.xacro"}, edits); !fault.empty()) refuse(fault);

#pragma once

#include <string>
#include <vector>

#include <rigor/author/names/rename.h>
#include <rigor/text/edit.h>

namespace rigor::author {

/// What is wrong with the edits, as the end of a sentence: the first of the templates that would expand to something
/// else. Empty when none would. The edits may be of any files that the templates read.
std::string expansion_fault(const RenameContext& context, const std::vector<std::string>& templates,
                            const std::vector<Edit>& edits);

}  // namespace rigor::author
