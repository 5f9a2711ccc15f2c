// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor mesh-check FILE -o OUT`: one mesh changed, and written to one file or several.

#include <filesystem>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <rigor/mesh/asset/file_reference.h>
#include <rigor/mesh/image/picture_names.h>
#include <rigor/mesh/read.h>
#include <rigor/mesh/write/losses.h>
#include <rigor/mesh/write/write.h>
#include <rigor/report/terminal/printable.h>
#include <rigor/text/path.h>

#include "command/command.h"
#include "command/mesh/mesh_check.h"
#include "output/atomic_file.h"

namespace rigor::tool {
namespace {

/// "hull.stl" and "2" make "hull-2.stl".
std::string numbered(const std::string& path, const std::string& name) {
  const std::size_t dot = path.size() - extension(path).size();
  return path.substr(0, dot) + '-' + name + path.substr(dot);
}

/// A file beside the one that -o names, or that one.
struct OutputFile {
  std::string name;
  std::string bytes;
};

/// From the root, so that links to folders don't mislead what climbs up from them.
std::string real_place(const std::string& path) {
  std::error_code error;
  const auto folder = std::filesystem::weakly_canonical(std::string(parent_path(path)), error);
  return error ? path : join_path(folder.generic_string(), file_name(path));
}

std::vector<mesh::FileReference> pictures_of(const mass::MeshFacts& facts) {
  std::vector<mesh::FileReference> pictures = facts.asset.textures;
  for (mesh::FileReference& picture : pictures) picture.path = real_place(picture.path);
  return pictures;
}

void tell_losses(const mass::MeshFacts& facts, const std::string& out, author::OperatedMesh& done) {
  constexpr std::size_t kShown = 8;
  std::set<std::string> lost;
  std::string what;
  for (const author::NamedMesh& each : done.meshes) {
    for (const std::string& one : mesh::losses(each.mesh, out, facts.asset.textures)) {
      if (!lost.insert(one).second || lost.size() > kShown) continue;
      what += (what.empty() ? "" : ", ") + one;
    }
  }
  if (lost.size() > kShown) what += " and others";
  if (!what.empty()) done.steps.push_back({"left out", report::printable(what)});
}

/// All bytes before any file: one that cannot be written costs nothing.
std::vector<OutputFile> files_of(const author::OperatedMesh& done, const std::string& out) {
  std::vector<OutputFile> files;
  for (const author::NamedMesh& each : done.meshes) {
    const std::string path = each.name.empty() ? out : numbered(out, each.name);
    mesh::WrittenMesh written = mesh::write_mesh(each.mesh, path);
    if (!written.bytes) throw UsageError(out + ": " + written.problem);
    files.push_back({std::string(file_name(path)), std::move(*written.bytes)});
    for (mesh::SideFile& side : written.side_files) {
      files.push_back({std::move(side.name), std::move(side.bytes)});
    }
  }
  return files;
}

}  // namespace

std::vector<report::WrittenFile> write_meshes(const author::OperatedMesh& done,
                                              const std::string& out, NamedBy named_by) {
  const bool own = named_by == NamedBy::kUser;
  for (const OutputFile& file : files_of(done, out)) {
    if (own && file.name == file_name(out)) {
      replace_file(out, file.bytes);
    } else {
      put_file(std::string(parent_path(out)), file.name, file.bytes);
    }
  }
  std::vector<report::WrittenFile> written;
  for (const author::NamedMesh& each : done.meshes) {
    written.push_back({each.name.empty() ? out : numbered(out, each.name),
                       each.mesh.triangles.size(), done.hausdorff});
  }
  return written;
}

author::MeshOperations operations_of(const MeshCheckArguments& a, const mass::MeshFacts& facts) {
  author::MeshOperations operations = a.operations.operations();
  // Reading has applied the unit that the file says; it gives way to the one that the user says.
  const auto& collada = facts.asset.collada;
  if (a.operations.says_unit() && collada) operations.unit /= collada->meter.value_or(1);
  return operations;
}

int work_on_mesh(const MeshCheckArguments& a) {
  const bool one_file =
      a.paths.size() == 1 && RealDisk().kind(a.paths.front()) != PathKind::kFolder;
  if (!one_file || rules::names_model(a.paths.front())) {
    throw UsageError(
        "what changes a mesh needs one mesh file; for those of a model there is --apply");
  }
  if (a.test_world && !a.operations.given().empty()) {
    throw UsageError("--test-world shows the mesh as it is: write it with -o OUT first");
  }
  const MeshChecking checking(a);
  if (!checking.whole()) return checking.conclude();
  if (a.test_world) return write_test_world(a, checking);
  if (!a.attach.empty()) require_attachable(a, checking);

  MeshWork work;
  std::string mesh_path = a.paths.front();
  if (!a.out.empty() || !a.operations.given().empty()) {
    mesh::LoadedMesh loaded =
        mesh::read_mesh(checking.disk(), mesh_path, checking.environment().workers);
    const mass::MeshFacts& facts = *checking.result().meshes.front().facts;
    author::OperatedMesh done = author::operate(std::move(loaded.mesh), operations_of(a, facts));
    if (!done.problem.empty()) {
      checking.conclude();
      say("rigor: " + report::printable(mesh_path) + ": " + done.problem);
      return kFindings;
    }
    if (!a.out.empty()) {
      tell_losses(facts, a.out, done);
      for (author::NamedMesh& each : done.meshes) {
        each.mesh.materials = mesh::materials_at(real_place(a.out), std::move(each.mesh.materials),
                                                 pictures_of(facts));
      }
      work.written = write_meshes(done, a.out, NamedBy::kUser);
      mesh_path = a.out;
    }
    work.steps = std::move(done.steps);
    work.fit = std::move(done.primitive);
  }
  if (!a.attach.empty()) attach(a, checking, mesh_path);
  return checking.conclude(work);
}

}  // namespace rigor::tool
