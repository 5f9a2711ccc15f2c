// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/json/settings.h>

#include <utility>

#include <rigor/report/json/values.h>
#include <rigor/report/tool.h>

namespace rigor::report {

std::string settings_json(const std::string& file, const std::vector<std::string>& configurations,
                          const std::vector<SettingLine>& settings) {
  Json list = Json::array();
  for (const SettingLine& each : settings) {
    Json json = {{"key", each.key},
                 {"value", each.value},
                 {"option", nullptr},
                 {"path", nullptr},
                 {"line", nullptr}};
    if (!each.option.empty()) json["option"] = each.option;
    if (!each.path.empty()) {
      json["path"] = each.path;
      json["line"] = each.line;
    }
    list.push_back(std::move(json));
  }
  const Json json = {{"tool", {{"name", kToolName}, {"version", tool_version()}}},
                     {"schema_version", kSchemaVersion},
                     {"path", file},
                     {"configurations", configurations},
                     {"settings", std::move(list)}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace rigor::report
