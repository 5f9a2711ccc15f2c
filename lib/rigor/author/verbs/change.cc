// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/verbs/change.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include <fmt/core.h>

#include <rigor/author/names/name_graph.h>
#include <rigor/author/names/parameter_names.h>
#include <rigor/convert/settings.h>
#include <rigor/read/documents.h>
#include <rigor/text/path.h>

namespace rigor::author {
namespace {

using robot::Difference;

/// The step's edits as edits of what the template's author wrote; nothing where that is an expression.
std::optional<std::vector<Edit>> as_written(const EditedModel& edited,
                                            const std::vector<Edit>& step) {
  const read::File& file = *edited.loaded.file;
  const auto is_expanded = [&](const Edit& edit) {
    return edit.span.source == edited.document().source();
  };
  if (!file.expanded || std::none_of(step.begin(), step.end(), is_expanded)) return step;
  Diagnostic finding;
  finding.where = step.front().span;
  finding.fixes.push_back(Fix{"", Applicability::kUnsafe, step});
  const Diagnostic written =
      file.expanded->in_source(edited.document(), std::move(finding), edited.sources);
  if (written.fixes.empty()) return std::nullopt;
  return written.fixes.front().edits;
}

/// The files that the steps change, each with its text after them; or why not.
std::string collect(const EditedModel& edited, const std::vector<std::vector<Edit>>& steps,
                    std::vector<EditedFile>& files) {
  std::map<std::string, EditedFile> by_path;
  for (const std::vector<Edit>& step : steps) {
    if (step.empty()) continue;
    const auto written = as_written(edited, step);
    if (!written) {
      const Span where = step.front().span;
      const read::Origin origin =
          edited.loaded.file->expanded->origin(edited.document(), where, edited.sources);
      const std::string place =
          fmt::format("{}:{}", edited.sources.path(origin.where.source),
                      edited.sources.position(origin.where.source, origin.where.begin).line);
      const bool is_added = std::all_of(step.begin(), step.end(),
                                        [](const Edit& edit) { return edit.span.size() == 0; });
      return is_added
                 ? "nothing can be added at " + place + ", which a macro or an expression makes"
                 : place + " is computed by an expression";
    }
    for (const Edit& edit : *written) {
      EditedFile& file = by_path[normalize_path(edited.sources.path(edit.span.source))];
      file.source = edit.span.source;
      file.edits.push_back(edit);
    }
  }
  for (auto& [path, file] : by_path) {
    file.path = edited.sources.path(file.source);
    // A macro's text is changed once, however many elements were made of it.
    std::stable_sort(file.edits.begin(), file.edits.end(), [](const Edit& a, const Edit& b) {
      return std::tie(a.span.begin, a.span.end, a.text) <
             std::tie(b.span.begin, b.span.end, b.text);
    });
    file.edits.erase(std::unique(file.edits.begin(), file.edits.end()), file.edits.end());
    auto text = apply_edits(edited.sources.bytes(file.source), file.edits);
    if (!text) return path + " would be changed twice in one place";
    file.text = *std::move(text);
    files.push_back(std::move(file));
  }
  return {};
}

/// Of sums that are zero but for rounding nothing relative can be asked: kg·m and kg·m².
constexpr double kRoundingOfSums = 1e-12;

bool is_rounding(const Difference& difference) {
  return (difference.kind == robot::DifferenceKind::kTotalFirst ||
          difference.kind == robot::DifferenceKind::kTotalSecond) &&
         difference.distance <= kRoundingOfSums;
}

std::vector<Difference> settings_between(const EditedModel& before, const EditedModel& after) {
  const read::Documents documents(before.workspace);
  const read::Documents changed(after.workspace);
  return convert::compare_settings({before.root(), documents, before.environment.sdf, before.model},
                                   {after.root(), changed, after.environment.sdf, after.model});
}

/// Names in a file that mean something.
std::size_t references_in(const EditedModel& edited, const std::string& path) {
  NameGraph graph(edited.workspace, edited.environment.resolver);
  graph.add_robot(edited.path());
  return graph.uses(path).size();
}

/// Why a file that changed lost the meaning of a name; empty when none did.
std::string lost_reference(const EditedModel& before, const EditedModel& after,
                           const std::string& path) {
  if (parameter_format(path)) return {};
  const std::size_t was = references_in(before, path), is = references_in(after, path);
  if (is >= was) return {};
  return fmt::format("{} names in {} refer to something before, {} after", was, path, is);
}

}  // namespace

bool is_of_pose(const Difference& difference) {
  const std::string_view what = difference.what;
  return what.ends_with("pose") || what.ends_with("origin/xyz") || what.ends_with("origin/rpy");
}

Change refusal(std::string reason) {
  Change change;
  change.refused = std::move(reason);
  return change;
}

ProvenChange prove(ModelReader& reader, const EditedModel& edited, const Change& change) {
  ProvenChange proven;
  proven.refused = change.refused;
  if (!proven.refused.empty()) return proven;
  proven.refused = collect(edited, change.steps, proven.files);
  if (!proven.refused.empty()) return proven;
  std::map<std::string, std::string> texts;
  for (const EditedFile& file : proven.files) texts[file.path] = file.text;
  OpenedModel opened =
      reader.open_changed(edited.path(), edited.root()[edited.model].name.value, texts);
  if (!opened.model) {
    proven.refused = "the result cannot be read: " + opened.problem;
    return proven;
  }
  proven.after = std::move(opened.model);
  const robot::Correspondence all{.helpers = robot::Helpers::kReported,
                                  .placement = robot::Placement::kReported};
  proven.asked = robot::compare(edited.robot, proven.after->robot, all);
  proven.unasked = robot::compare(change.expected, proven.after->robot, all);
  std::erase_if(proven.unasked, is_rounding);
  for (Difference& difference : settings_between(edited, *proven.after)) {
    const bool asked = change.asks_for_setting && change.asks_for_setting(difference);
    (asked ? proven.asked : proven.unasked).push_back(std::move(difference));
  }
  if (change.references == References::kKept) {
    std::vector<std::string> paths{edited.path()};
    for (const EditedFile& file : proven.files) paths.push_back(file.path);
    for (const std::string& path : paths) {
      if (proven.refused.empty()) proven.refused = lost_reference(edited, *proven.after, path);
    }
  }
  return proven;
}

}  // namespace rigor::author
