// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/validation.h>

#include <algorithm>
#include <cstddef>
#include <set>

#include <fmt/core.h>

#include <rigor/report/terminal/printable.h>
#include <rigor/text/grouping.h>
#include <rigor/text/path.h>

namespace rigor::report {
namespace {

/// Other places that are listed: more do not fit a line, and JSON has them all.
constexpr std::size_t kMaxPlaces = 8;

/// The last file that was named, so that its further lines need no path.
class PlaceList {
 public:
  PlaceList(const Diagnostic& first, Places& places)
      : places_(places), path_(places.path(first)), in_first_(!first.where.nowhere()) {}

  void add(const Diagnostic& other) {
    const std::string_view path = places_.path(other);
    const bool same = path == path_;
    const std::string line =
        other.where.nowhere() ? "" : fmt::format("{}", places_.begin(other.where).line);
    if (same && line == line_) return;  // of two on a line one is enough
    if (!text_.empty()) text_ += ", ";
    if (!same) {
      text_ += printable(path) + (line.empty() ? "" : ":" + line);
    } else if (line.empty()) {
      text_ += "the same file";
    } else {
      text_ += (in_first_ && text_.empty() ? "line " : "") + line;
      if (in_first_ && text_.find(',') != std::string::npos && text_.starts_with("line ")) {
        text_.insert(4, "s");
      }
    }
    if (!same) in_first_ = false;
    path_ = path;
    line_ = line;
  }

  const std::string& text() const { return text_; }

 private:
  Places& places_;
  std::string_view path_;
  std::string line_;
  bool in_first_;  // as long as no other file was named
  std::string text_;
};

}  // namespace

rules::ValidateResult grouped(const rules::ValidateResult& result, GroupScope scope) {
  rules::ValidateResult shown{
      result.files, {}, result.all_files, result.not_looked_at, result.unusable};
  const std::vector<Diagnostic>& all = result.diagnostics.list();
  Grouping grouping;
  std::size_t done = 0;
  for (rules::FileSummary& file : shown.files) {
    for (; done < file.first_finding; ++done) grouping.add(all[done]);
    if (scope == GroupScope::kFile) grouping.close();
    file.first_finding = grouping.size();
    for (; done < file.end_finding; ++done) grouping.add(all[done]);
    file.end_finding = grouping.size();
  }
  for (; done < all.size(); ++done) grouping.add(all[done]);
  shown.diagnostics = grouping.take();
  return shown;
}

std::string project_path(const Validation& validation, std::string_view path) {
  const ProjectFolders& folders = validation.folders;
  if (folders.root.empty()) return normalize_path(path);
  return relative_path(folders.root, join_path(folders.working, path));
}

std::string place_text(const Diagnostic& diagnostic, Places& places) {
  std::string text = printable(places.path(diagnostic));
  if (diagnostic.where.nowhere()) return text;
  const Position begin = places.begin(diagnostic.where);
  return text + fmt::format(":{}:{}", begin.line, begin.column);
}

std::string other_places(const Diagnostic& diagnostic, Places& places) {
  if (diagnostic.others.empty()) return {};
  PlaceList list(diagnostic, places);
  const std::size_t listed = std::min(diagnostic.others.size(), kMaxPlaces);
  for (std::size_t i = 0; i < listed; ++i) list.add(diagnostic.others[i]);
  std::set<std::string_view> files{places.path(diagnostic)};
  for (const Diagnostic& other : diagnostic.others) files.insert(places.path(other));
  return fmt::format("{} more{}: {}{}", diagnostic.others.size(),
                     files.size() == 1 ? "" : fmt::format(" in {} files", files.size()),
                     list.text(), listed < diagnostic.others.size() ? ", …" : "");
}

std::vector<std::string> origin_lines(const Diagnostic& diagnostic, Places& places) {
  constexpr std::size_t kMaxParameters = 3;
  std::vector<std::string> lines;
  for (const MacroCall& call : diagnostic.origin) {
    std::string line = fmt::format("in macro '{}'", call.macro);
    // Those of the calls around it are rarely what a reader looks for.
    const std::size_t listed =
        lines.empty() ? std::min(call.params.size(), kMaxParameters) : std::size_t{0};
    for (std::size_t i = 0; i < listed; ++i) {
      line += fmt::format("{}{}='{}'", i == 0 ? " (" : ", ", call.params[i].first,
                          call.params[i].second);
    }
    if (listed > 0) line += listed < call.params.size() ? ", …)" : ")";
    if (!call.where.nowhere()) {
      line +=
          fmt::format(", called at {}:{}", places.path(call.where), places.begin(call.where).line);
    }
    lines.push_back(printable(line));
  }
  return lines;
}

std::string concise_line(const Diagnostic& diagnostic, Places& places) {
  const std::string others = other_places(diagnostic, places);
  return fmt::format("{}: {}: {}{} [{}]", place_text(diagnostic, places),
                     to_string(diagnostic.severity), printable(diagnostic.message),
                     others.empty() ? "" : " (and " + others + ')', diagnostic.rule);
}

bool keeps_from_reading(const Diagnostic& diagnostic) {
  if (diagnostic.severity != Severity::kError) return false;
  return diagnostic.category == to_string(rules::Category::kXml) ||
         diagnostic.rule == "file-unreadable" || diagnostic.rule == "file-too-large";
}

}  // namespace rigor::report
