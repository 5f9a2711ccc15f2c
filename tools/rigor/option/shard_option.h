// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Which part of the work this machine does: `--shard 2/5`, or `--shard auto` for what the CI service says of the
// jobs that run beside this one.

#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include <rigor/text/shard.h>

namespace rigor::tool {

class ShardOption {
 public:
  /// `help` says of what it is a part; `group` is the heading that it stands under in the help, if any.
  void declare(CLI::App& app, const std::string& help, const std::string& group = {});

  /// All of it when the option is absent; a UsageError when it means nothing.
  Shard shard() const;

 private:
  std::string shard_;
};

}  // namespace rigor::tool
