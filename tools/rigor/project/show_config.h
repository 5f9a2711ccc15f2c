// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `--show-config FILE`: every setting that holds for a file, and who says it.

#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include "option/rule_settings.h"
#include "output/output.h"
#include "project/config_file.h"

namespace rigor::tool {

class ShowConfigOption {
 public:
  void declare(CLI::App& app);

  bool asked() const { return !file_.empty(); }

  /// Prints them, as text or JSON, and returns the exit code.
  int run(const RuleSettings& settings, const ConfigOptions& config,
          const OutputOptions& output) const;

 private:
  std::string file_;
};

}  // namespace rigor::tool
