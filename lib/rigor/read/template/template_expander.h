// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Makes the file that everything else reads of a template: expanded with packages as a source tree has
// them, and with the arguments that are given.
//
//   TemplateExpander expander(resolver);
//   std::unique_ptr<File> file = expander.expand("robot.urdf.xacro", sources);
//   if (!file->expanded->ok()) tell(file->expanded->expansion().facts);

#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/read/resolver.h>
#include <rigor/read/workspace.h>
#include <rigor/text/sources.h>
#include <rigor/xacro/expand.h>

namespace rigor::read {

/// By its name: `robot.urdf.xacro`, `arm.xacro`.
bool is_template(std::string_view path);

/// Safe across threads.
class TemplateExpander {
 public:
  /// It outlives this.
  explicit TemplateExpander(const Resolver& resolver);

  /// From now on the file at a path has these bytes: what an editor holds, or a fix would make of it. Not
  /// while others expand.
  void replace(const std::string& path, std::string bytes);

  /// With the arguments of the resolver's paths.
  std::unique_ptr<File> expand(const std::string& path, Sources& sources);
  std::unique_ptr<File> expand(const std::string& path, const TemplateArguments& arguments,
                               Sources& sources);
  /// The expansion alone.
  xacro::Expansion expansion(const std::string& path, const TemplateArguments& arguments,
                             Sources& sources);

 private:
  static std::unique_ptr<File> file_of(const std::string& path, xacro::Expansion made,
                                       Sources& sources);
  /// Of a package, as the file writes paths: below the folder of the run they stay relative.
  std::optional<std::string> package_folder(std::string_view package, std::string_view file);

  const Resolver& resolver_;
  const TemplateInputs& inputs_;
  std::map<std::string, std::string> buffers_;  // by path from the working folder
};

}  // namespace rigor::read
