// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/rules/list.h>
#include <rigor/rules/registry.h>
#include "command/command.h"
#include "output/output.h"

namespace rigor::tool {
namespace {

struct RulesFormat {
  std::string_view name;
  std::string (*emit)(const rules::Registry&);
};

constexpr RulesFormat kRulesFormats[] = {{"text", report::rules_text},
                                         {"json", report::rules_json},
                                         {"markdown", report::rules_markdown}};

class Rules final : public Command {
 public:
  CLI::App* declare(CLI::App& program) override {
    CLI::App* app = add_command(program, "rules", "List the rules",
                                {"rigor rules", "rigor rules --format json"});
    output_.declare(*app, {"text", "json", "markdown"});
    return app;
  }

  int run() override {
    const rules::Registry registry;
    for (const Target& target : output_.targets()) {
      write(target, kRulesFormats[target.format].emit(registry));
    }
    return kClean;
  }

 private:
  OutputOptions output_;
};

}  // namespace

std::unique_ptr<Command> rules_command() { return std::make_unique<Rules>(); }

}  // namespace rigor::tool
