// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/team/report.h>

#include <iterator>
#include <string_view>
#include <utility>

#include <fmt/core.h>

#include <rigor/mesh/triangle_budget.h>
#include <rigor/report/html/finding_list.h>
#include <rigor/report/html/markup.h>
#include <rigor/report/html/page.h>
#include <rigor/report/team/script.h>
#include <rigor/report/team/section.h>
#include <rigor/report/terminal/printable.h>
#include <rigor/report/terminal/summary.h>
#include <rigor/report/tool.h>
#include <rigor/text/base64.h>
#include <rigor/text/path.h>

namespace rigor::report {
namespace {

constexpr std::string_view kReportTitle = "Robot models";

/// Of a name made from a path: with its ending it stays below the 255 bytes of file systems.
constexpr std::size_t kLongestSlug = 100;

/// Of a model's name, where its picture is described.
constexpr std::size_t kLongestName = 80;

/// What a page of a folder and one file have in common.
std::string begin_report_page(std::string_view title, TeamReportForm form) {
  return begin_page({.title = title,
                     .style = team_report_style(),
                     .images = form == TeamReportForm::kOneFile ? "data:" : "'self'",
                     .script_hash = team_report_script_hash()});
}

std::string severities(std::size_t errors, std::size_t warnings) {
  return counted(errors, "error") + ", " + counted(warnings, "warning");
}

/// "default" is what worlds are called.
bool is_name(std::string_view name) { return !name.empty() && name != "default"; }

/// "my_robot/model.sdf": so many files are called model.sdf that this alone is no name.
std::string file_with_folder(const std::string& path) {
  const std::string_view folder = file_name(parent_path(path));
  const std::string file(file_name(path));
  return folder.empty() || folder == "." || folder == ".." ? file
                                                           : std::string(folder) + '/' + file;
}

std::size_t count_of(const std::vector<const Diagnostic*>& findings, Severity severity) {
  std::size_t count = 0;
  for (const Diagnostic* each : findings) count += each->severity == severity ? each->count : 0;
  return count;
}

/// A rule's page in short, for who follows a link.
std::string rule_entry(const rules::Rule& rule) {
  return fmt::format(
      "<h3 id=\"rule-{0}\">{0}</h3>\n<p class=\"soft\">{1}, {2}</p>\n<p>{3}.</p>\n<p>{4}</p>\n"
      "<p>{5}</p>\n",
      escaped(rule.name), to_string(rule.severity), to_string(rule.category), escaped(rule.summary),
      escaped(rule.why), escaped(rule.what_to_do));
}

std::string files_left_out(const rules::ValidateResult& result) {
  std::string items;
  for (const rules::NotLookedAt& item : result.not_looked_at) {
    if (!item.index) continue;  // reported with its file
    items += fmt::format("<li>{}: {}</li>\n", escaped(item.path), escaped(printable(item.what)));
  }
  return items.empty() ? "" : "<h2>Skipped files</h2>\n<ul>\n" + items + "</ul>\n";
}

}  // namespace

TriangleCount triangles_of(const ReportedModel& model, bool collision,
                           const TriangleBudget& budget) {
  const std::uint64_t of_mesh =
      collision ? mesh::kMaxCollisionTriangles : mesh::kMaxVisualTriangles;
  const auto& of_model = collision ? budget.collision : budget.visual;
  TriangleCount count;
  for (const MeshUse& use : model.meshes) {
    if (use.collision != collision) continue;
    if (!use.triangles) ++count.unread;
    count.triangles += use.times * use.triangles.value_or(0);
    count.over_mesh = count.over_mesh || use.triangles.value_or(0) > of_mesh;
  }
  count.over_model = of_model && count.triangles > *of_model;
  return count;
}

bool over_budget(const ReportedModel& model, const TriangleBudget& budget) {
  return triangles_of(model, false, budget).over_model ||
         triangles_of(model, true, budget).over_model;
}

TeamReport::TeamReport(const Validation& validation, TeamReportOptions options)
    : validation_(validation), options_(std::move(options)), places_(validation.sources) {}

/// A name that is one in an address and on a disk: "robots/Arm/model.sdf" is "robots-arm-model-sdf".
std::string TeamReport::slug_of(const std::string& path) {
  std::string slug;
  for (const char c : path) {
    const bool upper = c >= 'A' && c <= 'Z';
    const bool plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
    if (upper || plain) {
      slug += upper ? static_cast<char>(c - 'A' + 'a') : c;
    } else if (!slug.empty() && slug.back() != '-') {
      slug += '-';
    }
  }
  if (slug.size() > kLongestSlug) slug.erase(0, slug.size() - kLongestSlug);
  while (slug.starts_with('-')) slug.erase(0, 1);
  if (slug.empty()) slug = "model";
  std::string unique = slug;
  for (std::size_t n = 2; !slugs_.insert(unique).second; ++n)
    unique = fmt::format("{}-{}", slug, n);
  return unique;
}

/// The picture itself, or where it lies; `from` leads from the page to the report's folder.
std::string TeamReport::image_html(const Image& image, std::string_view slug,
                                   std::string_view from) {
  if (image.png.empty()) return {};
  std::string source;
  if (one_file()) {
    source = "data:image/png;base64," + base64(image.png);
  } else {
    const std::string path = fmt::format("{}/{}.png", image.folder, slug);
    source = std::string(from) + path;
    pictures_.push_back({path, image.png});
  }
  return fmt::format(
      "<img src=\"{}\" alt=\"{}\" width=\"{}\" height=\"{}\" loading=\"lazy\" "
      "decoding=\"async\"/>",
      source, escaped(image.alt), kReportPictureWidth / image.share,
      kReportPictureHeight / image.share);
}

/// Without its picture.
TeamReportRow TeamReport::row_of(const ReportedModel& model, const std::string& slug) const {
  const rules::FileSummary& file = validation_.result.files[model.file];
  const std::vector<const Diagnostic*> findings = findings_of(validation_, model.file);
  TeamReportRow row{.link = one_file() ? "#model-" + slug : "models/" + slug + ".html",
                    .name = is_name(model.name) ? model.name : file_with_folder(file.path),
                    .path = printable(file.path),
                    .format = format_text(file),
                    .visual = triangles_of(model, false, options_.budget),
                    .collision = triangles_of(model, true, options_.budget),
                    .errors = count_of(findings, Severity::kError),
                    .warnings = count_of(findings, Severity::kWarning)};
  for (const TopModel& top : model.models) {
    row.links += top.totals.links;
    row.joints += top.totals.joints;
    row.mass += top.totals.mass;
  }
  if (model.simulation != nullptr) {
    const bool ran = model.simulation->blocked || !model.simulation->simulation.runs.empty();
    if (ran) row.verdict = model.simulation->verdict();
    row.no_verdict = model.simulation->scene.bodies.empty() ? "nothing moves" : "no test fits";
  } else if (!model.not_simulated.empty()) {
    row.no_verdict = "not simulated";
  }
  return row;
}

void TeamReport::add(const ReportedModel& model) {
  const std::string slug = slug_of(validation_.result.files[model.file].path);
  TeamReportRow row = row_of(model, slug);
  row.image = image_html({"thumbnails", model.thumbnail, "", kThumbnailShare}, slug, "");
  const std::string alt = "Picture of " + printable(row.name, kLongestName);
  const SectionPage page{validation_, places_, one_file() ? "#rule-" : "../index.html#rule-",
                         image_html({"pictures", model.picture, alt, 1}, slug, "../")};
  const std::string section =
      fmt::format("<section class=\"model\" id=\"model-{}\">\n{}</section>\n", slug,
                  team_report_section(model, row, page));
  if (one_file()) {
    sections_ += section;
  } else {
    pages_.push_back(
        {row.link, begin_report_page(row.name, options_.form) +
                       fmt::format("<h1><a href=\"../index.html\">{}</a></h1>\n", kReportTitle) +
                       section + end_page()});
  }
  tell_rules(findings_of(validation_, model.file));
  if (model.simulation != nullptr) {
    for (const Diagnostic& each : model.simulation->diagnostics.list()) rules_.insert(each.rule);
  }
  added_.insert(model.file);
  rows_.push_back(std::move(row));
}

void TeamReport::tell_rules(const std::vector<const Diagnostic*>& findings) {
  for (const Diagnostic* each : findings) rules_.insert(each->rule);
}

std::string TeamReport::rule_entries() const {
  std::string out;
  for (const std::string_view name : rules_) {
    if (const rules::Rule* rule = validation_.registry.find(name)) out += rule_entry(*rule);
  }
  if (out.empty()) return out;
  return "<details><summary>" + counted(rules_.size(), "rule") + " with findings</summary>\n" +
         out + "</details>\n";
}

/// Of model.config and whatever else is no model: only what is wrong with them.
std::string TeamReport::other_files() {
  std::string out;
  for (std::size_t i = 0; i < validation_.result.files.size(); ++i) {
    const std::vector<const Diagnostic*> findings = findings_of(validation_, i);
    if (added_.contains(i) || findings.empty()) continue;
    tell_rules(findings);
    out += fmt::format(
        "<details><summary>{}: {}</summary>\n{}</details>\n",
        escaped(validation_.result.files[i].path),
        severities(count_of(findings, Severity::kError), count_of(findings, Severity::kWarning)),
        finding_list(findings, places_, "#rule-"));
  }
  return out.empty() ? "" : "<h2>Findings in other files</h2>\n" + out;
}

std::vector<ReportFile> TeamReport::files() && {
  const Diagnostics& all = validation_.result.diagnostics;
  std::string paths;
  for (const std::string& path : options_.paths) paths += (paths.empty() ? "" : ", ") + path;
  std::string index = begin_report_page(kReportTitle, options_.form);
  index += fmt::format("<h1>{}</h1>\n<p class=\"soft\">{} {} on {}: {} checked, {}</p>\n",
                       kReportTitle, kToolName, tool_version(), escaped(printable(paths)),
                       counted(validation_.result.files.size(), "file"),
                       severities(all.count(Severity::kError), all.count(Severity::kWarning)));
  index += team_report_summary(rows_) + "<h2>Models</h2>\n" + team_report_table(rows_);
  index += sections_ + files_left_out(validation_.result);
  index += other_files();  // whose rules are explained, too
  index += rule_entries();
  index += fmt::format("<script>{}</script>\n", team_report_script()) + end_page();
  std::vector<ReportFile> files = std::move(pages_);
  files.insert(files.end(), std::make_move_iterator(pictures_.begin()),
               std::make_move_iterator(pictures_.end()));
  files.push_back({one_file() ? "" : "index.html", std::move(index)});
  return files;
}

}  // namespace rigor::report
