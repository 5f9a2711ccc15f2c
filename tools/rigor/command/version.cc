// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/tool.h>
#include "command/command.h"
#include "output/output.h"

namespace rigor::tool {
namespace {

class Version final : public Command {
 public:
  CLI::App* declare(CLI::App& program) override {
    CLI::App* app = add_command(program, "version", "Name this version and the engines inside",
                                {"rigor --version", "rigor --version --format json"});
    output_.declare(*app, {"text", "json"});
    return app;
  }

  int run() override {
    for (const Target& target : output_.targets()) {
      write(target, target.format == 0 ? report::version_text() : report::version_json());
    }
    return kClean;
  }

 private:
  OutputOptions output_;
};

}  // namespace

std::unique_ptr<Command> version_command() { return std::make_unique<Version>(); }

}  // namespace rigor::tool
