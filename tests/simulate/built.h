// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Scenes made of texts, for tests of how they are made.

#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <rigor/read/load.h>
#include <rigor/schema/embedded.h>
#include <rigor/simulate/scene/build.h>
#include <rigor/simulate/scene/input.h>

#include "support/workers.h"

namespace rigor::test {

/// A scene with the text that it was made from, so that a fact's place can be read.
struct Built {
  simulate::Scene scene;
  simulate::Facts facts;
  bool blocked = false;
  std::string text;

  std::string at(const Span& where) const {
    if (where.nowhere()) return "(nowhere)";
    return text.substr(where.begin, where.end - where.begin);
  }

  /// Places of the facts of a kind, in their order.
  std::vector<std::string> places(simulate::FactKind kind) const {
    std::vector<std::string> found;
    for (const simulate::Fact& fact : facts) {
      if (fact.kind == kind) found.push_back(at(fact.where));
    }
    return found;
  }

  const simulate::SceneBody& body(const std::string& name) const {
    const auto found = std::find_if(scene.bodies.begin(), scene.bodies.end(),
                                    [&](const auto& body) { return body.name == name; });
    if (found == scene.bodies.end()) throw std::runtime_error("no body " + name);
    return *found;
  }
};

using TextFiles = std::map<std::string, std::string>;

/// `others`: further files, such as meshes, by path.
inline Built built(const std::string& text, TextFiles others = {},
                   const simulate::SceneOptions& options = {},
                   const model::JointPositions& positions = {}) {
  static const auto sdf =
      std::get<schema::Schema>(schema::Schema::parse(schema::sdf_schema_text()));
  static const auto urdf =
      std::get<schema::Schema>(schema::Schema::parse(schema::urdf_schema_text()));
  const std::string path = text.find("<sdf") == std::string::npos ? "a.urdf" : "a.sdf";
  others[path] = text;
  const MemoryDisk disk(std::move(others));
  const read::Resolver resolver(disk, {});
  Sources sources;
  read::Workspace workspace(disk, sources);
  const read::Loaded loaded = read::load({workspace, resolver, sdf, urdf}, workspace.open(path));
  const simulate::SceneFiles files(loaded, workspace, resolver, workers(), positions);
  simulate::SceneResult made = build_scene(files.input(), options);
  const bool blocked = made.blocked();
  return {std::move(made.scene), std::move(made.facts), blocked, text};
}

/// With the first `from` replaced, which there is.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

}  // namespace rigor::test
