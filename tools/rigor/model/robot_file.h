// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A model file as a robot that can be compared with another.

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/convert/settings.h>
#include <rigor/mass/mesh/survey.h>
#include <rigor/read/documents.h>
#include <rigor/read/load.h>
#include <rigor/read/workspace.h>
#include <rigor/robot/compare.h>
#include <rigor/robot/robot.h>
#include <rigor/rules/environment.h>
#include <rigor/text/sources.h>

namespace rigor::tool {

class RobotFiles {
 public:
  RobotFiles(const Environment& environment, Sources& sources, read::Workspace& workspace)
      : environment_(environment),
        sources_(sources),
        workspace_(workspace),
        surveys_(environment.disk, {.workers = &environment.workers}) {}

  /// What `open_model` takes. A UsageError when it cannot be read.
  read::Loaded load(const std::string& path);
  /// A template with arguments of its own: by the number of a set of them, from 1.
  read::Loaded load(const std::string& path, std::size_t set,
                    const read::TemplateArguments& arguments);

  /// Of several models the one that is named; the only one whatever it is called. Nothing, and said on
  /// stderr, when the file does not say where all of it is. A UsageError when none is meant.
  std::optional<robot::Robot> robot(const read::Loaded& loaded, const std::string& model);

  /// What the two models tell simulators differently (convert/settings.h). Nothing where they are of two
  /// formats and one of them tells something. Both are files that `robot` takes.
  std::optional<std::vector<robot::Difference>> settings(const read::Loaded& a,
                                                         const std::string& model_a,
                                                         const read::Loaded& b,
                                                         const std::string& model_b);

  struct SettingsReview {
    std::vector<robot::Difference> differences;
    std::string_view not_compared;  ///< in words; empty: all is compared
    std::string why;                ///< "one is SDF and one is URDF"
  };
  /// The same for a review, with what edits and conversions leave aside.
  SettingsReview review_settings(const read::Loaded& a, const std::string& model_a,
                                 const read::Loaded& b, const std::string& model_b);

 private:
  convert::SettingsSource settings_source(const read::Loaded& loaded, const std::string& model,
                                          const read::Documents& documents) const;

  const Environment& environment_;
  Sources& sources_;
  read::Workspace& workspace_;
  mass::MeshSurveys surveys_;
};

}  // namespace rigor::tool
