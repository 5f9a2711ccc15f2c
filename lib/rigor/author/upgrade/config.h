// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The `model.config` beside a file that is brought to another version: what it says of the file's version
// is brought along. Consumers choose among several files by what it says, so where that would make them
// choose another one, it is left as it is.
//
//   ConfigUpgrade config = upgrade_config(disk, "my_robot/model.sdf", schema::Version{9});
//   if (config.change) write(config.change->path, config.change->text);

#pragma once

#include <optional>
#include <string>
#include <vector>

#include <rigor/author/upgrade/upgrade.h>
#include <rigor/schema/version.h>
#include <rigor/text/disk.h>

namespace rigor::author {

struct ConfigUpgrade {
  std::optional<FileChange>
      change;                      ///< nothing when there is nothing to say, or it is left as it is
  std::vector<UpgradeNote> notes;  ///< why it is left as it is
};

ConfigUpgrade upgrade_config(const Disk& disk, const std::string& sdf, schema::Version to);

}  // namespace rigor::author
