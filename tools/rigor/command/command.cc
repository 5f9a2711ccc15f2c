// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "command/command.h"

#include <algorithm>
#include <iterator>
#include <sstream>
#include <utility>

#include <rigor/schema/suggest.h>

namespace rigor::tool {
namespace {

/// CLI11's help, with the examples before it.
class ExamplesFirst : public CLI::Formatter {
 public:
  explicit ExamplesFirst(std::vector<std::string> examples) : examples_(std::move(examples)) {}

  std::string make_help(const CLI::App* app, std::string name,
                        CLI::AppFormatMode mode) const override {
    std::string text = examples_.size() == 1 ? "Example:\n" : "Examples:\n";
    for (const std::string& example : examples_) text += "  " + example + '\n';
    return text + '\n' + CLI::Formatter::make_help(app, std::move(name), mode);
  }

  const std::vector<std::string>& examples() const { return examples_; }

 private:
  std::vector<std::string> examples_;
};

constexpr const char* kOffer = "offer";

/// CLI11 tells how many there are only by throwing.
std::vector<CLI::Validator*> validators_of(CLI::Option& option) {
  std::vector<CLI::Validator*> validators;
  try {
    for (int i = 0;; ++i) validators.push_back(option.get_validator(i));
  } catch (const CLI::OptionNotFound&) {
    return validators;
  }
}

}  // namespace

void examples_first(CLI::App& app, const std::vector<std::string>& examples) {
  const auto formatter = std::make_shared<ExamplesFirst>(examples);
  formatter->column_width(34);
  app.formatter(formatter);
}

std::vector<std::string> examples_of(const CLI::App& app) {
  const auto formatter = std::dynamic_pointer_cast<ExamplesFirst>(app.get_formatter());
  return formatter ? formatter->examples() : std::vector<std::string>();
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

std::size_t choice(std::string_view what, std::string_view name, Names known) {
  const auto found = std::find(known.begin(), known.end(), name);
  if (found != known.end()) return static_cast<std::size_t>(found - known.begin());
  std::string message = "unknown " + std::string(what) + " \"" + std::string(name) + '"';
  const std::vector<std::string_view> all(known.begin(), known.end());
  const std::string hint = did_you_mean(name, all);
  throw UsageError(message + (hint.empty() ? "; known are " + listed(all) : hint));
}

CLI::Option* offer(CLI::Option* option, Names known) {
  std::string names;
  for (const std::string_view name : known) names += std::string(name) + ' ';
  // Switched off, it carries the names, and checks and describes nothing.
  return option->check(CLI::Validator(names).active(false), kOffer);
}

std::vector<std::string> offered_by(CLI::Option& option) {
  for (const CLI::Validator* validator : validators_of(option)) {
    if (validator->get_name() != kOffer) continue;
    std::istringstream names(CLI::Validator(*validator).active().get_description());
    return {std::istream_iterator<std::string>(names), {}};
  }
  return {};
}

std::string value_name(CLI::Option& option) {
  std::string checks;
  for (const CLI::Validator* validator : validators_of(option)) {
    const std::string check = validator->get_description();
    if (!check.empty()) checks += ':' + check;
  }
  std::string name = option.get_type_name();
  name.resize(name.size() - checks.size());
  return name;
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
