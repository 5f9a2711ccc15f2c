// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Waits for something to happen in folders, for the commands that look again when it did.
//
//   end_well_on_interrupt();
//   FolderEvents events(disk.folders(), "--watch");
//   while (disk.still_so()) events.wait();

#pragma once

#include <set>
#include <string>

#include <rigor/process/descriptor.h>

namespace rigor::tool {

/// Wakes up when something happens in one of the folders.
class FolderEvents {
 public:
  /// A UsageError, which begins with `option`, when the system gives no watch.
  FolderEvents(const std::set<std::string>& folders, const std::string& option);
  FolderEvents(const FolderEvents&) = delete;
  FolderEvents& operator=(const FolderEvents&) = delete;

  /// Until it is quiet again, or a second after the first event.
  void wait() const;

 private:
  process::Descriptor descriptor_;
};

/// From now on Ctrl-C ends the program with 0, in the middle of anything as well.
void end_well_on_interrupt();

}  // namespace rigor::tool
