// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor mesh-check FILE --attach MODEL::LINK::SHAPE` and `--test-world`: a mesh put into a model.

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <rigor/author/attach_mesh.h>
#include <rigor/author/test_world.h>
#include <rigor/mass/mesh/survey.h>
#include <rigor/mesh/read.h>
#include <rigor/process/absolute_path.h>
#include <rigor/read/load.h>
#include <rigor/report/number.h>
#include <rigor/report/terminal/printable.h>
#include <rigor/text/path.h>

#include "command/command.h"
#include "command/mesh/mesh_check.h"
#include "model/model_file.h"
#include "output/atomic_file.h"

namespace rigor::tool {
namespace {

constexpr int kAngleDigits = 8;

std::string all_of(const std::vector<std::string>& names) {
  return listed({names.begin(), names.end()});
}

void refuse(const author::AttachedMesh& done, const std::string& name) {
  using author::AttachProblem;
  const std::string what = "--attach " + name + ": ";
  switch (done.problem) {
    case AttachProblem::kNone: return;
    case AttachProblem::kNotFound:
      throw UsageError(
          what + "no collision or visual has that name" +
          (done.candidates.empty() ? "" : "; did you mean " + all_of(done.candidates)) + "?");
    case AttachProblem::kAmbiguous:
      throw UsageError(what + "several have that name; write one of " + all_of(done.candidates));
    case AttachProblem::kIncluded:
      throw UsageError(what + "it is in the included file " + done.path + "; attach it there");
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

/// What the mesh is compared with: "the shape that it replaces about z".
std::string expected_text(const author::AxisMismatch& mismatch) {
  const std::string about = std::string(" about ") + author::to_letter(mismatch.expected);
  if (mismatch.joint.empty()) return "the shape that it replaces" + about;
  return "joint '" + report::printable(mismatch.joint) + "' rotates it" + about;
}

/// With the rotation that would bring the axes together.
std::string mismatch_text(const author::AttachedMesh& done) {
  const author::AxisMismatch& mismatch = *done.mismatch;
  const model::Vector3 turn = author::turn_between(mismatch.mesh, mismatch.expected);
  std::string text = report::printable(done.uri) + " is round about its " +
                     author::to_letter(mismatch.mesh) + " axis, " + expected_text(mismatch) +
                     ": rotate its pose by \"";
  for (const double angle : {turn.x, turn.y, turn.z}) {
    text += report::number(angle, kAngleDigits) + ' ';
  }
  text.back() = '"';
  return text + " (roll, pitch, yaw)";
}

struct FileCopy {
  std::string to;
  std::string bytes;
};

/// The model and the shape in it.
class Attachment {
 public:
  Attachment(const MeshCheckArguments& a, const MeshChecking& checking)
      : checking_(checking), attach_(a.attach), workspace_(checking.disk(), sources_) {
    const auto [model, name] = split_model(attach_);
    name_ = name;
    if (checking.disk().kind(model) == PathKind::kMissing) {
      throw UsageError("--attach " + attach_ + ": there is no model at " + model);
    }
    const Environment& environment = checking.environment();
    const read::Reader reader{workspace_, environment.resolver, environment.sdf, environment.urdf};
    loaded_ = load(reader, open_plain_model(workspace_, process::absolute_path(model)));
  }

  /// How the mesh comes into the model; a UsageError when it can't.
  author::AttachedMesh with(const author::NewMesh& mesh) const {
    author::AttachedMesh done =
        author::attach_mesh(checking_.environment(), sources_, loaded_, name_, mesh);
    refuse(done, name_);
    return done;
  }

  void write(const std::string& path) const {
    const mesh::LoadedMesh loaded =
        mesh::read_mesh(checking_.disk(), path, checking_.environment().workers);
    const mass::MeshFacts facts =
        mass::mesh_facts(checking_.disk(), path, loaded, mass::MeshDepth::kFile);
    const author::AttachedMesh done = with({.path = process::absolute_path(path),
                                            .bounds = facts.bounds,
                                            .vertices = loaded.mesh.positions});
    const auto text = apply_edits(sources_.bytes(loaded_.root.source), done.edits);
    if (!text) throw std::logic_error("the edits of " + loaded_.file->path + " overlap");
    for (const FileCopy& copy : copies(facts, done)) {
      const std::string folder(parent_path(parent_path(done.copy->to)));
      put_file(folder, relative_path(folder, copy.to), copy.bytes);
      say("rigor: copied to " + report::printable(copy.to));
    }
    replace_found({process::absolute_path(split_model(attach_).first)}, loaded_.file->path, *text);
    say("rigor: " + report::printable(done.subject) + " is now " + report::printable(done.uri) +
        ", in " + report::printable(loaded_.file->path));
    if (done.mismatch) say("rigor: warning: " + mismatch_text(done));
  }

 private:
  /// The mesh and what it names, so far as it comes to lie in the model too: pictures, a library of
  /// materials, buffers. A file that is there already and another one is never replaced: other shapes
  /// may be drawn with it.
  std::vector<FileCopy> copies(const mass::MeshFacts& facts,
                               const author::AttachedMesh& done) const {
    if (!done.copy) return {};
    std::vector<FileCopy> result;
    add(result, done.copy->from, done.copy->to);
    const std::string from(parent_path(done.copy->from));
    const std::string to(parent_path(done.copy->to));
    const std::string model(parent_path(to));
    for (const mesh::FileReference& named : named_by(facts.asset)) {
      const std::string file = process::absolute_path(named.path);
      const std::string copy =
          (std::filesystem::path(to) / std::filesystem::path(file).lexically_relative(from))
              .lexically_normal()
              .generic_string();
      if (copy.starts_with(model + '/')) {
        add(result, file, copy);
      } else {
        say("rigor: " + report::printable(named.written) +
            ", which the mesh names, is left where it is: put it where the model finds it");
      }
    }
    return result;
  }

  static std::vector<mesh::FileReference> named_by(const mesh::Asset& asset) {
    std::vector<mesh::FileReference> all = asset.textures;
    if (asset.obj) all.insert(all.end(), asset.obj->libraries.begin(), asset.obj->libraries.end());
    if (asset.gltf) all.insert(all.end(), asset.gltf->buffers.begin(), asset.gltf->buffers.end());
    std::erase_if(all, [](const mesh::FileReference& one) { return !is_there(one); });
    return all;
  }

  void add(std::vector<FileCopy>& copies, const std::string& from, const std::string& to) const {
    const bool known = std::any_of(copies.begin(), copies.end(),
                                   [&to](const FileCopy& copy) { return copy.to == to; });
    if (known) return;
    ReadResult bytes = checking_.disk().read(from, mesh::kMaxMeshBytes);
    if (!bytes.bytes) throw UsageError(from + ": " + bytes.problem);
    const bool is_new = checking_.disk().kind(to) == PathKind::kMissing;
    if (!is_new) {
      const ReadResult old = checking_.disk().read(to, mesh::kMaxMeshBytes);
      if (old.bytes == bytes.bytes) return;
      throw UsageError("--attach " + attach_ + ": " + to +
                       " is there already, and another file; give the mesh another name");
    }
    copies.push_back({to, std::move(*bytes.bytes)});
  }

  const MeshChecking& checking_;
  const std::string& attach_;
  std::string name_;
  Sources sources_;
  read::Workspace workspace_;
  read::Loaded loaded_;
};

}  // namespace

void require_attachable(const MeshCheckArguments& a, const MeshChecking& checking) {
  const auto& facts = *checking.result().meshes.front().facts;
  Attachment(a, checking)
      .with({.path = process::absolute_path(a.paths.front()), .bounds = facts.bounds});
}

void attach(const MeshCheckArguments& a, const MeshChecking& checking, const std::string& path) {
  Attachment(a, checking).write(path);
}

int write_test_world(const MeshCheckArguments& a, const MeshChecking& checking) {
  const std::string& path = a.paths.front();
  const std::string ending = extension(a.out);
  if (!a.out.empty() && ending != ".sdf" && ending != ".world") {
    throw UsageError("--test-world writes a world: -o " + a.out + " must end in .sdf or .world");
  }
  // Where the world lies decides how it names the mesh.
  const std::string world = a.out.empty() ? "world.sdf" : a.out;
  const auto from = std::filesystem::path(process::absolute_path(world)).parent_path();
  const std::string uri =
      std::filesystem::path(process::absolute_path(path)).lexically_relative(from).generic_string();
  const std::string file(file_name(path));
  const std::string name = file.substr(0, file.size() - extension(file).size());
  const mass::MeshSurvey survey =
      mass::survey_mesh(checking.disk(), {path}, checking.environment().workers);
  const std::string text = author::test_world({name.empty() ? "mesh" : name, uri}, survey);
  if (a.out.empty()) {
    write({0, {}}, text);
    return kClean;
  }
  replace_file(a.out, text);
  return checking.conclude({.written = {{a.out}}});
}

}  // namespace rigor::tool
