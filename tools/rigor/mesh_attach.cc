// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor mesh-check FILE --attach MODEL::LINK::SHAPE` and `--test-world`: a mesh put into a model.

#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>

#include <rigor/author/attach_mesh.h>
#include <rigor/author/test_world.h>
#include <rigor/mass/mesh_survey.h>
#include <rigor/read/load.h>
#include <rigor/report/printable.h>
#include <rigor/text/path.h>

#include "atomic_file.h"
#include "command.h"
#include "mesh_check.h"
#include "model_file.h"

namespace rigor::tool {
namespace {

std::string absolute(const std::string& path) {
  return std::filesystem::absolute(path).lexically_normal().generic_string();
}

std::string all_of(const std::vector<std::string>& names) {
  return listed({names.begin(), names.end()});
}

void refuse(const author::AttachedMesh& done, const std::string& name) {
  using author::AttachProblem;
  const std::string what = "--attach " + name + ": ";
  switch (done.problem) {
    case AttachProblem::kNone: return;
    case AttachProblem::kNotFound:
      throw UsageError(what + "no collision or visual has that name" +
                       (done.candidates.empty() ? "" : "; did you mean " + all_of(done.candidates)) +
                       "?");
    case AttachProblem::kAmbiguous:
      throw UsageError(what + "several have that name; write one of " + all_of(done.candidates));
    case AttachProblem::kIncluded:
      throw UsageError(what + "it stands in the included file " + done.path + "; attach it there");
    case AttachProblem::kPose: throw UsageError(what + "its pose cannot be read");
    case AttachProblem::kCutDocument: throw UsageError(what + "the model file is damaged");
  }
}

/// "robots/my_robot" and "chassis::visual" of "robots/my_robot::chassis::visual".
std::pair<std::string, std::string> split_model(const std::string& text) {
  const std::size_t colons = text.find("::");
  if (colons == std::string::npos || colons == 0) {
    throw UsageError("--attach " + text + ": is MODEL::LINK::VISUAL, with MODEL a model's path");
  }
  return {text.substr(0, colons), text.substr(colons + 2)};
}

}  // namespace

void attach(const MeshCheckArguments& a, const MeshChecking& checking, const std::string& path) {
  const auto [model, name] = split_model(a.attach);
  const Environment& environment = checking.environment();
  Sources sources;
  read::Workspace workspace(checking.disk(), sources);
  const read::Reader reader{workspace, environment.resolver, environment.sdf, environment.urdf};
  if (checking.disk().kind(model) == PathKind::kMissing) {
    throw UsageError("--attach " + a.attach + ": there is no model at " + model);
  }
  const read::Loaded loaded = load(reader, open_model(workspace, absolute(model)));
  const mass::MeshFacts facts = mass::mesh_facts(checking.disk(), path, mass::MeshDepth::kFile);
  const author::AttachedMesh done = author::attach_mesh(environment, sources, loaded, name,
                                                        {absolute(path), facts.bounds});
  refuse(done, name);
  const auto text = apply_edits(sources.bytes(loaded.root.source), done.edits);
  if (!text) throw std::logic_error("the edits of " + loaded.file->path + " overlap");
  if (done.copy) {
    const ReadResult bytes = checking.disk().read(done.copy->from, mesh::kMaxMeshBytes);
    if (!bytes.bytes) throw UsageError(path + ": " + bytes.problem);
    std::filesystem::create_directories(parent_path(done.copy->to));
    replace_file(done.copy->to, *bytes.bytes);
    say("rigor: copied to " + report::printable(done.copy->to));
  }
  replace_file(loaded.file->path, *text);
  say("rigor: " + report::printable(done.subject) + " is now " + report::printable(done.uri) +
      ", in " + report::printable(loaded.file->path));
}

int write_test_world(const MeshCheckArguments& a, const MeshChecking& checking) {
  const std::string& path = a.paths.front();
  // Where the world lies decides how it names the mesh.
  const std::string world = a.out.empty() ? "world.sdf" : a.out;
  const auto from = std::filesystem::path(absolute(world)).parent_path();
  const std::string uri = std::filesystem::path(absolute(path)).lexically_relative(from).generic_string();
  const std::string file(file_name(path));
  const std::string name = file.substr(0, file.size() - extension(file).size());
  const mass::MeshSurvey survey = mass::survey_mesh(checking.disk(), {path});
  const std::string text = author::test_world({name.empty() ? "mesh" : name, uri}, survey);
  if (a.out.empty()) {
    write({0, {}}, text);
    return kClean;
  }
  replace_file(a.out, text);
  return checking.conclude({.written = {{a.out, survey.triangles}}});
}

}  // namespace rigor::tool
