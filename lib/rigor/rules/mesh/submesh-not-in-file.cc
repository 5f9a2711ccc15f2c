// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstdint>
#include <string>

#include <rigor/mass/mesh/survey.h>
#include <rigor/read/resolver.h>
#include <rigor/rules/rule.h>
#include <rigor/text/disk.h>
#include <rigor/xml/document.h>

namespace rigor::rules::submesh_not_in_file {

/// Gazebo's Collada loader names a submesh by the nearest node that has a name, which need not be the one that
/// the triangles are in.
bool is_collada_node(const MeshUse& use, Context& context) {
  constexpr std::uint64_t kLargest = 64 << 20;  // bytes
  const read::Resolution& found = context.resolve(use.mesh.uri.value);
  if (!found.path) return false;
  const ReadResult file = context.disk().read(*found.path, kLargest);
  if (!file.bytes) return false;
  const xml::Document document = xml::parse(*file.bytes, kNoSource);
  if (!document.root() || document.root()->name() != "COLLADA") return false;
  for (std::uint32_t i = 0; i < document.element_count(); ++i) {
    const xml::Element element = document.element(i);
    const auto name = element.name() == "node" ? element.attribute("name") : std::nullopt;
    if (name && name->value() == use.mesh.submesh.value) return true;
  }
  return false;
}

void check(const MeshUse& use, Context& context) {
  const auto& submesh = use.mesh.submesh;
  if (submesh.value.empty()) return;
  const mass::MeshSurvey* survey = context.survey(use.mesh);
  if (survey == nullptr || survey->usable()) return;
  // A file that is empty as a whole is reported by mesh-empty, which has no such
  // words.
  const std::string words = "it has no part named " + submesh.value;
  const auto says_so = [&words](const mesh::Fault& fault) { return fault.detail == words; };
  if (std::none_of(survey->faults.begin(), survey->faults.end(), says_so)) return;
  if (is_collada_node(use, context)) return;
  context.report(
      {.where = submesh.span,
       .message = "'" + use.mesh.uri.value + "' has no part named '" + submesh.value + "'",
       .subject = use.subject});
}

Rule rule() {
  return {
      .name = "submesh-not-in-file",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .summary = "submesh does not exist in the mesh file",
      .why = "The simulator finds no such submesh and omits the shape: it is not drawn and does "
             "not collide. The checker (ign sdf -k, gz sdf -k) opens no meshes.",
      .what_to_do = "Write the name of the part in the file: in OBJ after o or g, in Collada that "
                    "of the node.",
      .checks = {on<MeshUse>(check)},
  };
}

}  // namespace rigor::rules::submesh_not_in_file
