// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include <rigor/rules/package/uri_fix.h>
#include <rigor/rules/package/uris.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::uri_backslash {

void check(const model::Root& /*root*/, Context& context) {
  for (const Uri& uri : context.uris()) {
    if (uri.text.find('\\') == std::string_view::npos) continue;
    Finding finding{.where = uri.where,
                    .message = "'" + std::string(uri.text) + "' has backslashes"};
    if (uri.verbatim) {
      std::string slashes(uri.text);
      std::replace(slashes.begin(), slashes.end(), '\\', '/');
      finding.fix = Fix{"write slashes", fix_of_uri(uri.where, context), {{uri.where, slashes}}};
    }
    context.report(std::move(finding));
  }
}

Rule rule() {
  return {
      .name = "uri-backslash",
      .severity = Severity::kWarning,
      .fix = FixGrade::kSafe,
      .summary = "a URI has backslashes",
      .why = "Only Windows takes them for slashes; elsewhere the file is not found.",
      .what_to_do = "Write slashes instead. The fix is an unsafe one where links or their mass "
                    "come with the file: in an include.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::uri_backslash
