// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/config/configs.h>
#include <rigor/config/starter.h>
#include <rigor/report/terminal/printable.h>
#include <rigor/text/disk.h>
#include <rigor/text/path.h>

#include "command/command.h"
#include "output/atomic_file.h"
#include "output/output.h"

namespace rigor::tool {
namespace {

class Init final : public Command {
 public:
  CLI::App* declare(CLI::App& program) override {
    CLI::App* app = add_command(program, "init", "Write a rigor.toml that explains itself",
                                {"rigor init", "rigor init my_workspace/src"});
    app->add_option("folder", folder_, "Where to (default: .)")->type_name("FOLDER");
    return app;
  }

  int run() override {
    const RealDisk disk;
    if (disk.kind(folder_) != PathKind::kFolder) throw UsageError(folder_ + ": no such folder");
    const std::string path = join_path(folder_, config::kConfigName);
    if (disk.kind(path) != PathKind::kMissing) {
      throw UsageError(path + ": already exists and is left unchanged");
    }
    put_file(folder_, config::kConfigName, config::starter_config());
    say("wrote " + report::printable(path) +
        ": every setting is in it as a comment; `rigor validate --show-config FILE` tells what "
        "holds");
    return kClean;
  }

 private:
  std::string folder_ = ".";
};

}  // namespace

std::unique_ptr<Command> init_command() { return std::make_unique<Init>(); }

}  // namespace rigor::tool
