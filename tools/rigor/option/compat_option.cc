// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "option/compat_option.h"

#include <string_view>

#include "command/command.h"

namespace rigor::tool {
namespace {

constexpr std::string_view kCheckers[] = {"sdformat"};

}  // namespace

void CompatOption::declare(CLI::App& app) {
  offer(app.add_option("--compat", compat_,
                       "Judge as another checker: what it refuses is an error, what it takes is "
                       "not: sdformat")
            ->type_name("CHECKER"),
        kCheckers);
}

rules::Compat CompatOption::compat() const {
  if (compat_.empty()) return rules::Compat::kNone;
  choice("checker", compat_, kCheckers);
  return rules::Compat::kSdformat;
}

}  // namespace rigor::tool
