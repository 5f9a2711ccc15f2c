// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "command/command.h"

#include <algorithm>

#include <rigor/schema/suggest.h>

namespace rigor::tool {
namespace {

/// CLI11's help, with the examples before it.
class ExamplesFirst : public CLI::Formatter {
 public:
  explicit ExamplesFirst(std::string examples) : examples_(std::move(examples)) {}

  std::string make_help(const CLI::App* app, std::string name,
                        CLI::AppFormatMode mode) const override {
    return examples_ + CLI::Formatter::make_help(app, std::move(name), mode);
  }

 private:
  std::string examples_;
};

}  // namespace

void examples_first(CLI::App& app, const std::vector<std::string>& examples) {
  std::string text = examples.size() == 1 ? "Example:\n" : "Examples:\n";
  for (const std::string& example : examples) text += "  " + example + '\n';
  const auto formatter = std::make_shared<ExamplesFirst>(text + '\n');
  formatter->column_width(34);
  app.formatter(formatter);
}

CLI::App* add_command(CLI::App& program, const std::string& name, const std::string& description,
                      const std::vector<std::string>& examples) {
  CLI::App* app = program.add_subcommand(name, description);
  examples_first(*app, examples);
  return app;
}

std::string did_you_mean(std::string_view name, const std::vector<std::string_view>& candidates) {
  const std::vector<std::string_view> near = schema::near(name, candidates);
  if (near.empty()) return {};
  std::string text = "; did you mean ";
  for (std::size_t i = 0; i < near.size(); ++i) {
    if (i > 0) text += i + 1 == near.size() ? " or " : ", ";
    text += '"' + std::string(near[i]) + '"';
  }
  return text + '?';
}

std::size_t choice(std::string_view what, std::string_view name,
                   const std::vector<std::string_view>& known) {
  const auto found = std::find(known.begin(), known.end(), name);
  if (found != known.end()) return static_cast<std::size_t>(found - known.begin());
  std::string message = "unknown " + std::string(what) + " \"" + std::string(name) + '"';
  const std::string hint = did_you_mean(name, known);
  throw UsageError(message + (hint.empty() ? "; known are " + listed(known) : hint));
}

std::string listed(const std::vector<std::string_view>& names) {
  std::string text;
  for (const std::string_view name : names) {
    if (!text.empty()) text += ", ";
    text += name;
  }
  return text;
}

}  // namespace rigor::tool
