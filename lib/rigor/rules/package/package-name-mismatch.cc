// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstddef>
#include <set>
#include <string>
#include <string_view>

#include <rigor/rules/package/own_package.h>
#include <rigor/rules/package/uris.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::package_name_mismatch {

constexpr std::string_view kScheme = "package://";

void check(const model::Root& /*root*/, Context& context) {
  std::set<std::string_view> looked_at;
  for (const Uri& uri : context.uris()) {
    if (!uri.text.starts_with(kScheme)) continue;
    const std::string_view rest = uri.text.substr(kScheme.size());
    const std::size_t slash = rest.find('/');
    if (slash == std::string_view::npos || slash == 0) continue;
    const std::string_view name = rest.substr(0, slash);
    if (looked_at.count(name) != 0) continue;
    const auto& path = context.resolve(std::string(uri.text)).path;
    if (!path) continue;
    looked_at.insert(name);
    const std::string inside = normalize_path(rest.substr(slash + 1));
    if (!path->ends_with("/" + inside)) continue;
    const auto package = package_in(path->substr(0, path->size() - inside.size() - 1), context);
    if (!package || package->name == name) continue;
    context.report({.where = uri.where,
                    .message = "the folder '" + std::string(name) + "' holds the package '" +
                               package->name + "', and ROS finds packages by that name"});
  }
}

Rule rule() {
  return {
      .name = "package-name-mismatch",
      .severity = Severity::kWarning,
      .summary = "a package:// URI names the folder, and not the package in it",
      .why = "rigor, and simulators that look through folders, find the file by the name of its "
             "folder. ROS uses the <name> in the package.xml: RViz and MoveIt do not find it.",
      .what_to_do = "Write the name of the package. It is reported once for each folder.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::package_name_mismatch
