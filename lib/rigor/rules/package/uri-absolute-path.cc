// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstddef>
#include <string>
#include <string_view>

#include <rigor/rules/package/uris.h>
#include <rigor/rules/rule.h>
#include <rigor/text/path.h>

namespace rigor::rules::uri_absolute_path {

bool is_drive(std::string_view path) {
  const char letter = path.empty() ? '\0' : path.front();
  const bool is_letter = (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z');
  return is_letter && path.size() > 2 && path[1] == ':' && (path[2] == '/' || path[2] == '\\');
}

bool is_of_one_machine(std::string_view uri) {
  constexpr std::string_view kFile = "file://";
  if (uri.starts_with(kFile)) uri.remove_prefix(kFile.size());
  return is_absolute(uri) || is_drive(uri);
}

/// The first two folders of the path, which all files of one workspace share: /home/anna.
std::string_view workspace_of(std::string_view uri) {
  constexpr std::string_view kFile = "file://";
  if (uri.starts_with(kFile)) uri.remove_prefix(kFile.size());
  std::size_t end = 0;
  for (int folder = 0; folder < 2 && end != uri.npos; ++folder) {
    end = uri.find_first_of("/\\", uri.find_first_not_of("/\\", end));
  }
  return uri.substr(0, end);
}

void check(const model::Root& /*root*/, Context& context) {
  for (const Uri& uri : context.uris()) {
    if (!is_of_one_machine(uri.text)) continue;
    context.report({.where = uri.where,
                    .message = "'" + std::string(uri.text) + "' is a path of one machine",
                    .cause = std::string(workspace_of(uri.text))});
  }
}

void check_plugin(const model::Plugin& plugin, Context& context) {
  const std::string& library = plugin.filename.value;
  // No library lies at the top of a disk: the slash is there so that one of two simulators finds none.
  if (library.rfind('/') == 0) return;
  if (!is_of_one_machine(library)) return;
  context.report({.where = plugin.filename.span,
                  .message = "'" + library + "' is a path of one machine",
                  .subject = context.subject(plugin),
                  .help = "a plugin is found by the bare name of its library"});
}

Rule rule() {
  return {
      .name = "uri-absolute-path",
      .severity = Severity::kWarning,
      .summary = "a URI is a path of one machine",
      .why = "On any other machine the file is not found.",
      .what_to_do =
          "Write it relative to the model, or as model:// or package://; of a plugin the name of "
          "the library, with its folder in GZ_SIM_SYSTEM_PLUGIN_PATH or GAZEBO_PLUGIN_PATH.",
      .checks = {on<model::Root>(check), on<model::Plugin>(check_plugin)},
  };
}

}  // namespace rigor::rules::uri_absolute_path
