// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Where reports go: `--format NAME` to stdout, `--output FORMAT[:FILE]` to stdout or a file.
//
//   for (const Target& target : output_.targets()) write(target, emit(target.format));

#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/report/terminal/color.h>
#include <CLI/CLI.hpp>

namespace rigor::tool {

struct Target {
  std::size_t format;  ///< index in the command's formats
  std::string file;    ///< empty for stdout
};

class OutputOptions {
 public:
  /// The first format is the default. `names` are those of the option that takes FORMAT[:FILE].
  void declare(CLI::App& app, std::vector<std::string_view> formats,
               const std::string& names = "--output");

  /// Where to write what. At most one target is stdout.
  std::vector<Target> targets() const;

  /// The same for a command that has other formats for some of what it does: of these, the first is
  /// the default.
  std::vector<Target> targets_of(std::vector<std::string_view> formats) const;

 private:
  Target parse(const std::string& text) const;

  std::vector<std::string_view> formats_;
  std::string format_;
  std::vector<std::string> outputs_;
};

/// `--color`, and the environment variables that stand in for it.
class ColorOption {
 public:
  void declare(CLI::App& app);

  /// For what is written to the target: a file gets color only with `--color always`.
  report::Color of(const Target& target) const;

 private:
  std::string when_ = "auto";
};

/// To stdout or, replaced in one step, to the file.
void write(const Target& target, std::string_view text);

/// To stderr, with a line break.
void say(std::string_view line);

}  // namespace rigor::tool
