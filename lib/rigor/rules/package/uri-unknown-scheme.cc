// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/rules/edits.h>
#include <rigor/rules/package/uris.h>
#include <rigor/rules/rule.h>
#include <rigor/schema/suggest.h>

namespace rigor::rules::uri_unknown_scheme {

constexpr std::array<std::string_view, 6> kSchemes = {"model", "package", "file",
                                                      "http",  "https",   "fuel"};

/// What stands before ":/", if that looks like a scheme; a single letter is a drive.
std::string_view scheme_of(std::string_view uri) {
  const std::size_t end = uri.find(":/");
  if (end == std::string_view::npos || end < 2) return {};
  const std::string_view scheme = uri.substr(0, end);
  return scheme.find('/') == std::string_view::npos ? scheme : std::string_view();
}

std::optional<Fix> with_scheme(const Uri& uri, std::string_view scheme,
                               const std::vector<std::string_view>& near, const Context& context) {
  if (near.size() != 1 || !context.bytes(uri.where).starts_with(scheme)) return std::nullopt;
  std::size_t slashes = scheme.size() + 1;
  while (slashes < uri.text.size() && uri.text[slashes] == '/') ++slashes;
  Span begin = uri.where;
  begin.end = begin.begin + static_cast<std::uint32_t>(slashes);
  const std::string meant = std::string(near.front()) + "://";
  return Fix{"write " + meant, Applicability::kUnsafe, {{begin, meant}}};
}

void check(const model::Root& /*root*/, Context& context) {
  const std::vector<std::string_view> known(kSchemes.begin(), kSchemes.end());
  for (const Uri& uri : context.uris()) {
    const std::string_view scheme = scheme_of(uri.text);
    const bool listed = std::find(known.begin(), known.end(), scheme) != known.end();
    const bool slashes = uri.text.substr(scheme.size()).starts_with("://");
    if (scheme.empty() || (listed && (slashes || scheme == "file"))) continue;
    const auto near = listed ? std::vector{scheme} : schema::near(scheme, known);
    context.report({.where = uri.where,
                    .message = "'" + std::string(uri.text.substr(0, scheme.size() + 2)) +
                               "' begins no URI that is known",
                    .help = near.empty() ? "known are model://, package://, file:// and https://"
                                         : "did you mean '" + std::string(near.front()) + "://'?",
                    .fix = with_scheme(uri, scheme, near, context)});
  }
}

Rule rule() {
  return {
      .name = "uri-unknown-scheme",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "unknown URI scheme",
      .why = "Gazebo and ROS find files by model://, package://, file:// and https://. Anything "
             "else is taken for a path, and not found.",
      .what_to_do = "Write one of these schemes, with two slashes.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::uri_unknown_scheme
