// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstdint>
#include <string_view>

#include <rigor/rules/rule.h>

namespace rigor::rules::material_script_incomplete {

/// Whether the script has a value under this name. In SDF 1.0 these were attributes. `__default__` is
/// libsdformat's own sign for "nothing was written", which old Gazebo wrote into files.
bool is_given(const model::Field<std::string>& field) {
  return !field.value.empty() && field.value != "__default__";
}

void check(const model::Visual& visual, Context& context) {
  constexpr int kFirstVersionWithUri = 2;
  const model::Material& material = visual.material;
  if (context.root().version < kFirstVersionWithUri || material.script.span.nowhere()) return;
  const bool uri = is_given(material.script_uri);
  if (uri && is_given(material.name)) return;
  context.report({.where = material.script.name,
                  .message = uri ? "this material <script> has no <name>"
                                 : "this material <script> has no <uri>"});
}

Rule rule() {
  return {
      .name = "material-script-incomplete",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways},
      .formats = Formats::kSdf,
      .summary = "a material script lacks its uri or its name",
      .why = "libsdformat refuses the file: of a <script> it needs the file and the name of the "
             "material in it.",
      .what_to_do =
          "Write <uri> and <name>, or colours in place of the script: new Gazebo reads no scripts.",
      .checks = {on<model::Visual>(check)},
  };
}

}  // namespace rigor::rules::material_script_incomplete
