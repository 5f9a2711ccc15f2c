// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a team puts on its CI: one page about many models. A table of them with pictures, masses, meshes against
// their budgets and verdicts; a section for each with its findings and how it fared in simulation; the rules
// that spoke; and what was not examined.
//
//   TeamReport report(validation, {.form = TeamReportForm::kOneFile});
//   for (const ReportedModel& model : models) report.add(model);
//   for (const ReportFile& file : report.files()) write(file.path, file.bytes);
//
// The page loads nothing and is read without a script; a small one sorts and filters the table. The same input
// gives the same bytes.

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/author/simulation.h>
#include <rigor/report/inspect/inspect.h>
#include <rigor/report/places.h>
#include <rigor/report/team/table.h>
#include <rigor/report/validation.h>

namespace rigor::report {

/// Pictures inside of the page, or index.html with a page for each model and pictures as files.
enum class TeamReportForm : std::uint8_t { kOneFile, kFolder };

/// Triangles that the meshes of a model may have, shown and collided with; nothing is no limit.
struct TriangleBudget {
  std::optional<std::uint64_t> visual;
  std::optional<std::uint64_t> collision;
};

struct TeamReportOptions {
  TeamReportForm form = TeamReportForm::kOneFile;
  std::vector<std::string> paths;  ///< that were asked for, for the head
  TriangleBudget budget;           ///< of a model; that of a mesh is its rule's
};

/// A mesh as shapes of one kind use it.
struct MeshUse {
  std::string uri;
  bool collision = false;
  std::size_t times = 1;
  std::optional<std::uint64_t> triangles = {};  ///< of one use; nothing when it could not be read
};

/// A model that stands in no other one.
struct TopModel {
  std::string name;
  Totals totals;
};

/// All that is reported of a file with models, besides its findings.
struct ReportedModel {
  std::size_t file = 0;  ///< index in the files of the validation
  std::string name;      ///< of the model, or of the world around several
  std::vector<TopModel> models;
  std::vector<MeshUse> meshes;
  std::string picture;                 ///< a PNG; empty when there is none
  std::string thumbnail;               ///< the same, smaller
  std::vector<std::string> not_drawn;  ///< why there is no picture, or what is missing on it
  const author::SimulatedModel* simulation = nullptr;
  std::string not_simulated;  ///< why there is none, where one was asked for
};

/// Of the pictures, in pixels.
inline constexpr std::uint32_t kReportPictureWidth = 384;
inline constexpr std::uint32_t kReportPictureHeight = 288;
/// A thumbnail is so many times smaller along each side.
inline constexpr std::uint32_t kThumbnailShare = 3;

/// Triangles of all meshes of one kind.
TriangleCount triangles_of(const ReportedModel& model, bool collision,
                           const TriangleBudget& budget);

/// Whether the meshes of a model have more triangles than the budget of a model allows.
bool over_budget(const ReportedModel& model, const TriangleBudget& budget);

struct ReportFile {
  std::string path;  ///< "models/arm.html"; empty for a report of one file
  std::string bytes;
};

/// A model becomes text when it is added, so that its trajectories can go.
class TeamReport {
 public:
  /// All that `validation` refers to outlives it.
  TeamReport(const Validation& validation, TeamReportOptions options);

  /// In the order of the files.
  void add(const ReportedModel& model);

  /// Once, at the end. Of a folder the index is the last, so that it never names what is not there yet.
  std::vector<ReportFile> files() &&;

 private:
  struct Image {
    std::string_view folder;  ///< where it lies as a file
    const std::string& png;
    std::string alt;
    std::uint32_t share;  ///< of kReportPictureWidth and kReportPictureHeight
  };

  bool one_file() const { return options_.form == TeamReportForm::kOneFile; }
  std::string slug_of(const std::string& path);
  TeamReportRow row_of(const ReportedModel& model, const std::string& slug) const;
  std::string image_html(const Image& image, std::string_view slug, std::string_view from);
  void tell_rules(const std::vector<const Diagnostic*>& findings);
  std::string other_files();
  std::string rule_entries() const;

  Validation validation_;
  TeamReportOptions options_;
  Places places_;
  std::set<std::string> slugs_;
  std::set<std::size_t> added_;       // files
  std::set<std::string_view> rules_;  // that spoke
  std::vector<TeamReportRow> rows_;
  std::string sections_;
  std::vector<ReportFile> pages_;
  std::vector<ReportFile> pictures_;
};

}  // namespace rigor::report
