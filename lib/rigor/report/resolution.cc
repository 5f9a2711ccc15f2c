// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/resolution.h>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <rigor/report/terminal/printable.h>
#include <rigor/report/tool.h>

namespace rigor::report {
namespace {

using Json = nlohmann::ordered_json;

/// What to do so that it is found the next time.
std::string_view advice(const read::Resolution& resolution) {
  if (!resolution.other_case.empty()) return "letter case differs: write the name as it is on disk";
  if (resolution.remote) return "rigor never downloads: fetch it into the Fuel cache first";
  if (resolution.scheme == "package") {
    return "give --package NAME=DIR, or set ROS_PACKAGE_PATH to the folder that holds the package";
  }
  if (resolution.scheme == "file") return "no such file on this machine";
  return "give --model-path DIR, or set GZ_SIM_RESOURCE_PATH to the folder that holds the model";
}

}  // namespace

std::string resolution_text(std::string_view uri, const read::Resolution& resolution) {
  std::string out = resolution.path ? printable(*resolution.path) + '\n'
                                    : fmt::format("not found: {}\n", printable(uri));
  for (const read::Tried& tried : resolution.tried) {
    const bool hit = resolution.path && &tried == &resolution.tried.back();
    out += fmt::format("  {} {}  ({})\n", hit ? "found" : "tried", printable(tried.path),
                       printable(tried.origin));
  }
  if (resolution.path) return out;
  if (!resolution.other_case.empty()) {
    out += fmt::format("  there is {}\n", printable(resolution.other_case));
  }
  return out + fmt::format("  help: {}\n", advice(resolution));
}

std::string resolution_json(std::string_view uri, const read::Resolution& resolution) {
  Json tried = Json::array();
  for (const read::Tried& place : resolution.tried) {
    tried.push_back({{"path", place.path}, {"origin", place.origin}});
  }
  Json json = {{"tool", {{"name", kToolName}, {"version", tool_version()}}},
               {"schema_version", kSchemaVersion},
               {"uri", uri},
               {"path", nullptr},
               {"tried", std::move(tried)},
               {"help", nullptr}};
  if (resolution.path) {
    json["path"] = *resolution.path;
  } else {
    json["help"] = advice(resolution);
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace rigor::report
