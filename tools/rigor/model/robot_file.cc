// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "model/robot_file.h"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <vector>

#include <rigor/report/inspect/inspect.h>
#include <rigor/report/robot_diff/robot_diff.h>
#include <rigor/report/terminal/printable.h>
#include <rigor/report/terminal/summary.h>
#include <rigor/robot/lookups.h>
#include <rigor/rules/mesh_finder.h>
#include <rigor/text/path.h>

#include "command/command.h"
#include "model/model_file.h"
#include "output/output.h"

namespace rigor::tool {
namespace {

using model::Id;

/// One file has one name, from wherever it is examined.
std::string whole_path(const std::string& path) {
  std::error_code error;
  return path.empty() ? path : join_path(std::filesystem::current_path(error).string(), path);
}

/// What keeps a file from being compared; empty when nothing does.
std::string unreadable(const read::Loaded& loaded) {
  if (!loaded.file->document->complete()) return " is not well-formed";
  const model::Format format = loaded.root.format;
  if (format != model::Format::kSdf && format != model::Format::kUrdf &&
      format != model::Format::kMjcf) {
    return " is no robot model";
  }
  if (loaded.root.models.empty()) return " has no model";
  if (const std::string unread = unread_part(loaded); !unread.empty()) return ' ' + unread;
  const std::size_t lost = lost_includes(loaded);
  if (lost == 0) return {};
  return ": " + report::counted(lost, "include") + " could not be followed";
}

/// Of several the one that is named; the only one whatever it is called.
Id<model::Model> chosen(const read::Loaded& loaded, const std::string& model) {
  const std::vector<Id<model::Model>> models = report::top_models(loaded.root);
  if (models.size() == 1) return models.front();
  std::vector<std::string> names;
  for (const Id<model::Model> id : models) names.push_back(loaded.root[id].name.value);
  const std::vector<std::string_view> known(names.begin(), names.end());
  if (model.empty()) {
    throw UsageError(loaded.file->path + ": " + report::counted(models.size(), "model") +
                     "; choose one with --model: " + listed(known));
  }
  return models[choice(loaded.file->path + ": model", model, known)];
}

std::string_view format_name(model::Format format) {
  switch (format) {
    case model::Format::kSdf: return "SDF";
    case model::Format::kUrdf: return "URDF";
    case model::Format::kMjcf: return "MJCF";
    default: return "of another format";
  }
}

}  // namespace

read::Loaded RobotFiles::load(const std::string& path) {
  const read::Reader reader{workspace_, environment_.resolver, environment_.sdf, environment_.urdf};
  return read::load(reader, open_model(workspace_, path));
}

read::Loaded RobotFiles::load(const std::string& path, std::size_t set,
                              const read::TemplateArguments& arguments) {
  const read::Reader reader{workspace_, environment_.resolver, environment_.sdf, environment_.urdf};
  return read::load(reader, open_model(workspace_, path, set, arguments));
}

std::optional<robot::Robot> RobotFiles::robot(const read::Loaded& loaded,
                                              const std::string& model) {
  std::string why = unreadable(loaded);
  if (why.empty()) {
    robot::Lookups lookups = robot::lookups_in(loaded.root, workspace_, environment_.resolver);
    lookups.find_mesh = rules::mesh_finder(environment_.resolver, sources_, surveys_);
    lookups.find_file = [find = lookups.find_file](const std::string& uri, SourceId from) {
      return whole_path(find(uri, from));
    };
    const model::Frames frames(loaded.root);
    robot::Robot robot = robot::robot_of(loaded.root, frames, chosen(loaded, model), lookups);
    if (robot.unknown.empty()) return robot;
    why = ": " + robot.unknown.front();
  }
  say("rigor: " + report::printable(loaded.file->path + why) +
      "; run `rigor validate` for details");
  return std::nullopt;
}

std::optional<std::vector<robot::Difference>> RobotFiles::settings(const read::Loaded& a,
                                                                   const std::string& model_a,
                                                                   const read::Loaded& b,
                                                                   const std::string& model_b) {
  const read::Documents documents(workspace_);
  const convert::SettingsSource x = settings_source(a, model_a, documents),
                                y = settings_source(b, model_b, documents);
  if (x.root[x.model].format == y.root[y.model].format) return convert::compare_settings(x, y);
  if (convert::has_settings(x) || convert::has_settings(y)) return std::nullopt;
  return std::vector<robot::Difference>{};
}

RobotFiles::SettingsReview RobotFiles::review_settings(const read::Loaded& a,
                                                       const std::string& model_a,
                                                       const read::Loaded& b,
                                                       const std::string& model_b) {
  const read::Documents documents(workspace_);
  const convert::SettingsSource x = settings_source(a, model_a, documents),
                                y = settings_source(b, model_b, documents);
  const auto has_any = [](const convert::SettingsSource& source) {
    return convert::has_settings(source) || convert::has_further_settings(source) ||
           convert::has_uncompared_settings(source);
  };
  const model::Format format_a = x.root[x.model].format, format_b = y.root[y.model].format;
  SettingsReview review;
  if (format_a != format_b) {
    if (!has_any(x) && !has_any(y)) return review;
    review.not_compared = report::kAllSettingsInWords;
    review.why = "one is " + std::string(format_name(format_a)) + " and one is " +
                 std::string(format_name(format_b));
    return review;
  }
  review.differences = convert::compare_settings(x, y);
  const auto further = convert::compare_further_settings(x, y);
  review.differences.insert(review.differences.end(), further.begin(), further.end());
  if (convert::has_uncompared_settings(x) || convert::has_uncompared_settings(y)) {
    review.not_compared = report::kMjcfSettingsInWords;
    review.why = "both are MJCF";
  }
  return review;
}

convert::SettingsSource RobotFiles::settings_source(const read::Loaded& loaded,
                                                    const std::string& model,
                                                    const read::Documents& documents) const {
  return {loaded.root, documents, environment_.sdf, chosen(loaded, model)};
}

}  // namespace rigor::tool
