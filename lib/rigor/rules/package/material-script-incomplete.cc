// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstdint>
#include <string_view>

#include <rigor/read/values.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::material_script_incomplete {

/// Whether the script has a value under this name. In SDF 1.0 these were attributes. `__default__` is
/// libsdformat's own sign for "nothing was written", which old Gazebo wrote into files.
bool has(xml::Element script, std::string_view name) {
  const auto text = read::child_text(script, name);
  if (!text) return false;
  const std::string_view value = read::trimmed(text->text);
  return !value.empty() && value != "__default__";
}

void check(const model::Root& root, Context& context) {
  constexpr int kFirstVersionWithUri = 2;
  if (root.version < kFirstVersionWithUri) return;
  for (const xml::Element script : context.elements_about_files()) {
    const auto parent = script.parent();
    if (script.name() != "script" || !parent || parent->name() != "material") continue;
    const bool uri = has(script, "uri");
    if (uri && has(script, "name")) continue;
    context.report({.where = script.name_span(),
                    .message = uri ? "this material <script> has no <name>"
                                   : "this material <script> has no <uri>"});
  }
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
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::material_script_incomplete
