// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The model in a URDF text, for tests of what is computed from it.

#pragma once

#include <map>
#include <string>
#include <variant>

#include <rigor/read/load.h>
#include <rigor/schema/embedded.h>

namespace rigor::test {

/// What a text says, as it was read.
class LoadedText {
 public:
  explicit LoadedText(const std::string& text)
      : sdf_(std::get<schema::Schema>(schema::Schema::parse(schema::sdf_schema_text()))),
        urdf_(std::get<schema::Schema>(schema::Schema::parse(schema::urdf_schema_text()))),
        disk_(std::map<std::string, std::string>{{"a.urdf", text}}),
        resolver_(disk_, {}),
        workspace_(disk_, sources_),
        loaded_(read::load({workspace_, resolver_, sdf_, urdf_}, workspace_.open("a.urdf"))) {}

  const model::Root& root() const { return loaded_.root; }

 private:
  schema::Schema sdf_, urdf_;
  MemoryDisk disk_;
  read::Resolver resolver_;
  Sources sources_;
  read::Workspace workspace_;
  read::Loaded loaded_;
};

}  // namespace rigor::test
