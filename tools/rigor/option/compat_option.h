// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Whose judgment counts: `--compat sdformat`.

#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include <rigor/rules/compat.h>

namespace rigor::tool {

class CompatOption {
 public:
  void declare(CLI::App& app);

  /// rigor's own when the option is absent; a UsageError when it names nobody.
  rules::Compat compat() const;

 private:
  std::string compat_;
};

}  // namespace rigor::tool
