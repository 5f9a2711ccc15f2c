// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <rigor/read/resolver.h>
#include <rigor/rules/package/uri_fix.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mesh_case_mismatch {

std::string_view folder(std::string_view path) {
  return path.substr(0, path.rfind('/') + 1);  // npos + 1 is 0
}
std::string_view last(std::string_view path) { return path.substr(folder(path).size()); }

/// Puts the file's own spelling in, when only the last part of the URI differs.
std::optional<Fix> fix(const model::Field<std::string>& uri, const read::Resolution& found,
                       const Context& context) {
  const bool same_folder =
      std::any_of(found.tried.begin(), found.tried.end(), [&found](const read::Tried& tried) {
        return folder(tried.path) == folder(found.other_case);
      });
  const std::string_view name = last(uri.value);
  const std::size_t at = context.bytes(uri.span).rfind(name);
  if (!same_folder || name.empty() || at == std::string_view::npos) return std::nullopt;
  Span span = uri.span;
  span.begin += static_cast<std::uint32_t>(at);
  span.end = span.begin + static_cast<std::uint32_t>(name.size());
  const std::string right(last(found.other_case));
  return Fix{"write " + right, fix_of_uri(span, context), {{span, right}}};
}

void check(const MeshUse& use, Context& context) {
  const auto& uri = use.mesh.uri;
  if (uri.value.empty()) return;
  const read::Resolution& found = context.resolve(uri.value);
  if (found.path || found.other_case.empty()) return;
  context.report({.where = uri.span,
                  .message = "the mesh '" + uri.value + "' is not found, but '" + found.other_case +
                             "' is: only the case of letters differs",
                  .subject = use.subject,
                  .fix = fix(uri, found, context)});
}

Rule rule() {
  return {
      .name = "mesh-case-mismatch",
      .severity = Severity::kError,
      .fix = FixGrade::kSafe,
      .summary = "a mesh file is written with other upper and lower case",
      .why = "It opens on Windows and macOS, and is not found on Linux, where the simulators "
             "mostly run.",
      .what_to_do = "Write the name as the file has it.",
      .checks = {on<MeshUse>(check)},
  };
}

}  // namespace rigor::rules::mesh_case_mismatch
