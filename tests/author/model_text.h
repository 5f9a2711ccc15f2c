// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A model file from memory, read, among files that need only be there.

#pragma once

#include <map>
#include <string>
#include <utility>

#include <rigor/read/load.h>
#include <rigor/read/workspace.h>
#include <rigor/rules/environment.h>
#include <rigor/text/disk.h>
#include <rigor/text/sources.h>

namespace rigor::test {

struct ModelText {
  ModelText(std::map<std::string, std::string> files, const std::string& path, std::string text)
      : disk(std::move(files)),
        environment(disk, {}),
        workspace(disk, sources),
        loaded(read::load({workspace, environment.resolver, environment.sdf, environment.urdf},
                          workspace.put(path, std::move(text)))) {}

  MemoryDisk disk;
  Environment environment;
  Sources sources;
  read::Workspace workspace;
  read::Loaded loaded;
};

}  // namespace rigor::test
