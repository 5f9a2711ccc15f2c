// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>

#include <rigor/rules/mesh/file_fault.h>
#include <rigor/rules/rule.h>
#include <rigor/text/path.h>

namespace rigor::rules::mesh_format_unsupported {

constexpr std::string_view kFormats[] = {".stl", ".dae", ".obj", ".glb", ".gltf", ".ply", ".fbx"};

std::string read_by_none(const std::string& extension) {
  if (extension == ".mesh") return "RViz alone reads Ogre's format '.mesh': no simulator does";
  return "no simulator is known to read meshes of the format '" + extension + "'";
}

void check(const MeshUse& use, Context& context) {
  const std::string& uri = use.mesh.uri.value;
  const std::size_t dot = uri.rfind('.');
  const std::size_t slash = uri.rfind('/');
  if (uri.empty()) return;
  const bool none = dot == std::string::npos || (slash != std::string::npos && dot < slash);
  const std::string extension = none ? "" : uri.substr(dot);
  const std::string format = rigor::extension(uri);
  if (std::find(std::begin(kFormats), std::end(kFormats), format) != std::end(kFormats)) return;
  context.report({.where = use.mesh.uri.span,
                  .message = none ? "the mesh has no file extension: its format is unknown"
                                  : read_by_none(extension),
                  .subject = use.subject});
}

/// Of a file by itself there is no URI: then its bytes are of an unknown format.
void check_file(const MeshFile& file, Context& context) {
  if (file.use != nullptr || !fault_of(file, mesh::FaultKind::kUnknownFormat)) return;
  report_mesh(file, context, "the format is none that simulators are known to read");
}

Rule rule() {
  return {
      .name = "mesh-format-unsupported",
      .severity = Severity::kWarning,
      .summary = "a mesh has a format that simulators do not read",
      .why = "Gazebo reads STL, DAE, OBJ, glTF and, by assimp, a few more; RViz much the same. "
             "Formats of CAD programs (STEP, IGES, SLDPRT) and of renderers (blend, vtk) are read "
             "by none, Ogre's own (.mesh) by RViz alone.",
      .what_to_do = "Export the mesh as STL, OBJ, DAE or glTF.",
      .checks = {on<MeshUse>(check), on<MeshFile>(check_file)},
  };
}

}  // namespace rigor::rules::mesh_format_unsupported
