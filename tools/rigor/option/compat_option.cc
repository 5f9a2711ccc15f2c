// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "option/compat_option.h"

#include "command/command.h"

namespace rigor::tool {

void CompatOption::declare(CLI::App& app) {
  app.add_option(
         "--compat", compat_,
         "Judge as another checker: what it refuses is an error, what it takes is not: sdformat")
      ->type_name("CHECKER");
}

rules::Compat CompatOption::compat() const {
  if (compat_.empty()) return rules::Compat::kNone;
  choice("checker", compat_, {"sdformat"});
  return rules::Compat::kSdformat;
}

}  // namespace rigor::tool
