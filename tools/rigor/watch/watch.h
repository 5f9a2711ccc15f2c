// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `--watch`: checks, waits until something that was examined changes, and says what that did.
//
//   return watch(
//       disk,
//       [&](const Disk& disk, Sources& sources) { return rules::validate(…, sources); },
//       [](const rules::ValidateResult& result) { say(report::summary(result)); }, color);
//
// What is watched is what the check asked of the disk: models, includes, meshes, configuration, and files
// that were missed. Ctrl-C ends the program with 0.

#pragma once

#include <functional>

#include <rigor/report/terminal/color.h>
#include <rigor/rules/validate.h>
#include <rigor/text/disk.h>
#include <rigor/text/sources.h>

namespace rigor::tool {

/// One run over all, on this disk.
using WatchedCheck = std::function<rules::ValidateResult(const Disk& disk, Sources& sources)>;

/// A UsageError of the first check is thrown; one of a later check, as of a configuration that was edited,
/// is reported. Comes back only when the first check could use none of its arguments (then with the exit code of a wrong
/// invocation). `conclude` is called after each check. Findings go to stdout.
int watch(const Disk& real, const WatchedCheck& check,
          const std::function<void(const rules::ValidateResult&)>& conclude, report::Color color,
          Severity least);

}  // namespace rigor::tool
