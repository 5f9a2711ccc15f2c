// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/rules/explain.h>
#include <rigor/rules/example.h>
#include <rigor/rules/registry.h>
#include "command/command.h"
#include "output/output.h"

namespace rigor::tool {
namespace {

class Explain final : public Command {
 public:
  CLI::App* declare(CLI::App& program) override {
    CLI::App* app = add_command(program, "explain", "Show one rule's page",
                                {"rigor explain joint-limit-inverted"});
    app->add_option("rule", rule_, "A rule's name")->required()->type_name("RULE");
    return app;
  }

  int run() override {
    const rules::Registry registry;
    const rules::Rule* rule = registry.find(rule_);
    if (rule == nullptr) throw UsageError(unknown(registry));
    write({0, {}}, report::explain(*rule, rules::examples_of(*rule)));
    return kClean;
  }

 private:
  std::string unknown(const rules::Registry& registry) const {
    std::vector<std::string_view> names;
    for (const rules::Rule& rule : registry.rules()) names.push_back(rule.name);
    const std::string hint = did_you_mean(rule_, names);
    return "unknown rule \"" + rule_ + '"' + (hint.empty() ? "; `rigor rules` lists them" : hint);
  }

  std::string rule_;
};

}  // namespace

std::unique_ptr<Command> explain_command() { return std::make_unique<Explain>(); }

}  // namespace rigor::tool
