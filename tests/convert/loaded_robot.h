// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A file of an in-memory disk, read, and what a conversion needs of it, for tests.

#pragma once

#include <map>
#include <string>
#include <utility>
#include <variant>

#include <rigor/convert/sdf_to_urdf.h>
#include <rigor/model/frames.h>
#include <rigor/read/documents.h>
#include <rigor/read/load.h>
#include <rigor/read/resolver.h>
#include <rigor/read/workspace.h>
#include <rigor/schema/embedded.h>
#include <rigor/schema/schema.h>
#include <rigor/text/disk.h>
#include <rigor/text/sources.h>

#include "support/workers.h"

namespace rigor::test {

/// The text as the file at `path`; all that it was made of lives as long.
class LoadedRobot {
 public:
  explicit LoadedRobot(std::string text, const std::string& path = "a.urdf")
      : sdf_(std::get<schema::Schema>(schema::Schema::parse(schema::sdf_schema_text()))),
        urdf_(std::get<schema::Schema>(schema::Schema::parse(schema::urdf_schema_text()))),
        disk_(std::map<std::string, std::string>{{path, std::move(text)}}),
        resolver_(disk_, {}),
        workspace_(disk_, sources_),
        loaded_(read::load({workspace_, resolver_, sdf_, urdf_}, workspace_.open(path))),
        frames_(loaded_.root),
        documents_(workspace_),
        path_(path) {}

  const read::Loaded& loaded() const { return loaded_; }
  const model::Root& root() const { return loaded_.root; }
  const model::Frames& frames() const { return frames_; }
  convert::Source source() const {
    const bool sdf = root().format == model::Format::kSdf;
    return {root(), frames_, documents_, resolver_, sdf ? sdf_ : urdf_, workers(), path_};
  }

 private:
  schema::Schema sdf_, urdf_;
  MemoryDisk disk_;
  read::Resolver resolver_;
  Sources sources_;
  read::Workspace workspace_;
  read::Loaded loaded_;
  model::Frames frames_;
  read::Documents documents_;
  std::string path_;
};

}  // namespace rigor::test
