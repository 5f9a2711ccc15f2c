// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The models that a command is about, from what the user named.

#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <rigor/model/frames.h>
#include <rigor/model/model.h>
#include <rigor/read/load.h>
#include <rigor/read/workspace.h>
#include <rigor/rules/environment.h>

namespace rigor::tool {

/// The file that is meant by a file; by a model.config, which names one, or a folder with one; or by a folder in which
/// there is one model: a UsageError where there are several or none. What does not exist is not noticed.
std::string model_path(read::Workspace& workspace, const std::string& named);

/// The file of `model_path`, read: a UsageError when it cannot be.
const read::File& open_model(read::Workspace& workspace, const std::string& path);

/// The same, of a template with arguments of its own: by the number of a set of them, from 1.
const read::File& open_model(read::Workspace& workspace, const std::string& path, std::size_t set,
                             const read::TemplateArguments& arguments);

/// The same, of a model whose text is to be edited: a UsageError when it is a template.
const read::File& open_plain_model(read::Workspace& workspace, const std::string& path);

/// What `open_model` takes, one by one: of a folder without a model.config, all files in it, and the templates
/// that are robots and expand without errors. A UsageError when a folder cannot be read.
std::vector<std::string> model_paths(const Environment& environment,
                                     const std::vector<std::string>& named);

/// A UsageError when a name is given, and no model of these is called so.
void require_model(const std::string& name, const std::vector<const model::Root*>& roots);

/// How many includes of a model lead nowhere.
/// What of the file was not read, in words; empty when all was.
std::string unread_part(const read::Loaded& loaded);

std::size_t lost_includes(const read::Loaded& loaded);

/// Tells how many are not in the Fuel cache, so that what is said is without them.
void tell_unfollowed(const read::Loaded& loaded);

/// Of `--joint NAME=VALUE`: by scoped name; a name without its scope will do when only one joint has
/// it.
model::JointPositions joint_positions(const model::Root& root,
                                      const std::vector<std::string>& assignments);

}  // namespace rigor::tool
