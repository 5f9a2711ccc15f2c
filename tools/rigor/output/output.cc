// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "output/output.h"

#include <cstdio>
#include <cstdlib>

#include <unistd.h>

#include "command/command.h"
#include "output/atomic_file.h"

namespace rigor::tool {
namespace {

constexpr std::string_view kWhen[] = {"auto", "always", "never"};

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

/// Whether a terminal on stdout is to be colored; https://no-color.org, https://bixense.com/clicolors.
bool terminal_wants_color() {
  if (!variable("NO_COLOR").empty()) return false;
  const std::string force = variable("CLICOLOR_FORCE");
  if (!force.empty() && force != "0") return true;
  return variable("TERM") != "dumb" && isatty(STDOUT_FILENO) == 1;
}

bool looks_like_file(std::string_view text) {
  return text.find_first_of("./") != std::string_view::npos;
}

}  // namespace

void OutputOptions::declare(CLI::App& app, std::vector<std::string_view> formats,
                            const std::string& names) {
  formats_ = std::move(formats);
  offer(app.add_option("--format", format_, "What to print on stdout: " + listed(formats_))
            ->type_name("NAME"),
        formats_);
  app.add_option(names, outputs_, "Write a format to a file; may be given several times")
      ->type_name("FORMAT[:FILE]")
      ->allow_extra_args(false);
}

Target OutputOptions::parse(const std::string& text) const {
  const std::size_t colon = text.find(':');
  const std::string name = text.substr(0, colon);
  const std::vector<std::string_view>& known = formats_;
  const bool unknown = std::find(known.begin(), known.end(), name) == known.end();
  if (unknown && looks_like_file(name)) {
    throw UsageError("--output takes FORMAT[:FILE], and \"" + text +
                     "\" looks like a file; did you mean -o " + text + ", or --output " +
                     std::string(known.front()) + ":" + text + "?");
  }
  const std::size_t format = choice("format", name, known);
  if (colon == std::string::npos) return {format, {}};
  if (colon + 1 == text.size()) throw UsageError("--output " + text + " names no file");
  return {format, text.substr(colon + 1)};
}

std::vector<Target> OutputOptions::targets() const {
  std::vector<Target> targets;
  if (!format_.empty()) targets.push_back({choice("format", format_, formats_), {}});
  for (const std::string& output : outputs_) targets.push_back(parse(output));
  if (targets.empty()) return {{0, {}}};
  std::size_t to_stdout = 0;
  for (const Target& target : targets) to_stdout += target.file.empty() ? 1 : 0;
  if (to_stdout > 1) {
    throw UsageError("only one format can go to stdout: give the others a file, --output " +
                     std::string(formats_[targets.back().format]) + ":FILE");
  }
  return targets;
}

std::vector<Target> OutputOptions::targets_of(std::vector<std::string_view> formats) const {
  OutputOptions other = *this;
  other.formats_ = std::move(formats);
  return other.targets();
}

void ColorOption::declare(CLI::App& app) {
  offer(app.add_option("--color", when_, "auto, always or never")->type_name("WHEN"), kWhen);
}

report::Color ColorOption::of(const Target& target) const {
  const std::size_t when = choice("--color value", when_, kWhen);
  const bool wanted = when == 1 || (when == 0 && target.file.empty() && terminal_wants_color());
  return wanted ? report::Color::kAnsi : report::Color::kPlain;
}

void write(const Target& target, std::string_view text) {
  if (!target.file.empty()) return replace_file(target.file, text);
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (!written || std::fflush(stdout) != 0) throw UsageError("stdout cannot be written");
}

void say(std::string_view line) {
  std::fwrite(line.data(), 1, line.size(), stderr);
  std::fputc('\n', stderr);
}

}  // namespace rigor::tool
