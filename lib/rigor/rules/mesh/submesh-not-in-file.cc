// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <string>

#include <rigor/mass/mesh/survey.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::submesh_not_in_file {

void check(const MeshUse& use, Context& context) {
  const auto& submesh = use.mesh.submesh;
  if (submesh.value.empty()) return;
  const mass::MeshSurvey* survey = context.survey(use.mesh);
  if (survey == nullptr || survey->usable()) return;
  // A file that is empty as a whole is told by mesh-empty, which has no such
  // words.
  const std::string words = "it has no part named " + submesh.value;
  const auto says_so = [&words](const mesh::Fault& fault) { return fault.detail == words; };
  if (std::none_of(survey->faults.begin(), survey->faults.end(), says_so)) return;
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
      .summary = "a shape takes a part of a mesh file that the file does not have",
      .why = "The simulator finds no such submesh and leaves the shape out: nothing is seen, or "
             "collided with. ign sdf -k opens no meshes.",
      .what_to_do = "Write the name that the part has in the file: in OBJ behind o or g.",
      .checks = {on<MeshUse>(check)},
  };
}

}  // namespace rigor::rules::submesh_not_in_file
