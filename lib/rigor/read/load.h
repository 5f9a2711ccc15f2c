// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Reads a model file of any known format, follows its includes, and gives what it could build along
// with what it found wrong. It always gives something: a damaged file gives what stands before the
// damage.
//
//   Loaded loaded = load(reader, workspace.open("robot.sdf"));
//   for (const model::Link& link : loaded.root.links) ...

#pragma once

#include <string>
#include <vector>

#include <rigor/model/model.h>
#include <rigor/read/conformance.h>
#include <rigor/read/fact.h>
#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/read/mjcf/mjcf_includes.h>
#include <rigor/read/model_config.h>
#include <rigor/read/resolver.h>
#include <rigor/read/workspace.h>
#include <rigor/schema/schema.h>

namespace rigor::read {

struct Loaded {
  const File* file = nullptr;
  model::Root root;
  std::vector<Fact> facts;
  ModelConfig config;  ///< when `root.format` is kModelConfig
  std::vector<ConfigFact> config_facts;
  std::vector<MjcfFact> mjcf_facts;  ///< when `root.format` is kMjcf
  MjcfIncludes mjcf_includes;
};

/// What a reader works with; all of it outlives the reading.
struct Reader {
  Workspace& workspace;
  const Resolver& resolver;
  const schema::Schema& sdf;
  const schema::Schema& urdf;
};

/// `file` may lack a document; then only its facts say so.
Loaded load(const Reader& reader, const File& file);

}  // namespace rigor::read
