// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "watch/watch.h"

#include <string>
#include <vector>

#include <rigor/report/changes.h>
#include <rigor/report/terminal/pretty.h>
#include <rigor/report/terminal/printable.h>
#include <rigor/report/terminal/shown.h>
#include <rigor/report/terminal/summary.h>
#include <rigor/text/grouping.h>
#include "command/command.h"
#include "output/output.h"
#include "watch/asked_disk.h"
#include "watch/folder_events.h"

namespace rigor::tool {

int watch(const Disk& real, const WatchedCheck& check,
          const std::function<void(const rules::ValidateResult&)>& conclude, report::Color color,
          Severity least) {
  end_well_on_interrupt();
  std::vector<report::KnownFinding> before;
  for (bool first = true;; first = false) {
    const AskedDisk disk(real);
    Sources sources;
    try {
      const rules::ValidateResult result = check(disk, sources);
      const Diagnostics listed = report::shown(result.diagnostics, least);
      write({0, {}}, first ? report::pretty(grouped(listed), sources, color)
                           : report::changes(before, listed, sources, color));
      conclude(result);
      if (first && result.files.empty() && !result.unusable.empty()) return kUsage;
      before = report::remembered(before, report::known_findings(listed, sources));
    } catch (const UsageError& error) {
      if (first) throw;
      say("rigor: " + report::printable(error.what()));
    }

    FolderEvents events(disk.folders(), "--watch");
    if (first) {
      write({0, {}}, "watching " + report::counted(disk.files_read(), "file") + "; Ctrl-C ends\n");
    }
    // What changed since it was read and before it was watched is no event.
    while (disk.still_so()) events.wait();
  }
}

}  // namespace rigor::tool
