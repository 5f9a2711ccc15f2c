// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor fmt PATH...`: model files laid out in one style, what they say kept.

#include <charconv>
#include <cstdint>
#include <iostream>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <rigor/author/format/configured_style.h>
#include <rigor/author/format/formatted.h>
#include <rigor/read/discover.h>
#include <rigor/read/workspace.h>
#include <rigor/report/terminal/printable.h>
#include <rigor/report/terminal/summary.h>
#include <rigor/rules/environment.h>
#include <rigor/text/diff.h>
#include <rigor/text/for_each_index.h>
#include <rigor/text/path.h>

#include "command/command.h"
#include "option/file_options.h"
#include "output/atomic_file.h"
#include "output/output.h"
#include "project/config_file.h"

namespace rigor::tool {
namespace {

using author::FormatOutcome;

/// 1-based, both included.
struct Lines {
  std::uint32_t first = 1;
  std::uint32_t last = UINT32_MAX;
};

Lines lines_in(const std::string& text) {
  Lines lines;
  const char* end = text.data() + text.size();
  const auto [colon, first] = std::from_chars(text.data(), end, lines.first);
  const auto tail = first == std::errc() && colon != end && *colon == ':'
                        ? std::from_chars(colon + 1, end, lines.last)
                        : std::from_chars_result{end, std::errc::invalid_argument};
  if (tail.ec != std::errc() || tail.ptr != end || lines.first < 1 || lines.last < lines.first)
    throw UsageError("--lines takes FIRST:LAST, not \"" + text + '"');
  return lines;
}

class Fmt final : public Command {
 public:
  CLI::App* declare(CLI::App& program) override {
    CLI::App* app = add_command(program, "fmt", "Lay model files out in one style",
                                {"rigor fmt .", "rigor fmt --check models urdf",
                                 "rigor fmt --diff robot.urdf.xacro", "rigor fmt - < robot.sdf"});
    app->add_option("paths", paths_,
                    "Files and folders (default: .); - is stdin, written to stdout")
        ->type_name("PATH");
    auto* check = app->add_flag("--check", check_,
                                "Change nothing, and exit 1 when a file is laid out otherwise");
    app->add_flag("--diff", diff_, "Show what would change, and exit 1 when anything does")
        ->excludes(check);
    app->add_option("--lines", lines_, "Only these lines, of one file")->type_name("FIRST:LAST");
    app->add_flag("--stdin", stdin_, "Read stdin and write to stdout, as with -");
    app->add_option("--stdin-filename", stdin_filename_, "File name for stdin (-)")
        ->type_name("PATH");
    files_.declare(*app);
    config_.declare(*app);
    return app;
  }

  int run() override {
    config_.open();
    environment_.emplace(disk_, read::SearchPaths{});
    order_.emplace(environment_->sdf, environment_->urdf);
    if (!lines_.empty()) range_ = lines_in(lines_);
    const bool dash = paths_.size() == 1 && paths_.front() == "-";
    if (stdin_ && !paths_.empty() && !dash) throw UsageError("--stdin takes no paths");
    if (stdin_ || dash) return run_stdin();
    const std::vector<std::string> files = files_of();
    if (!lines_.empty() && files.size() != 1) throw UsageError("--lines is for one file");
    for (const std::string& path : files) take(path);
    summarize(files.size());
    const bool would_change = changed_ > 0 && (check_ || diff_);
    if (faults_ > 0) return kInternal;
    return would_change || refused_ > 0 ? kFindings : kClean;
  }

 private:
  std::vector<std::string> asked() const {
    return paths_.empty() ? std::vector<std::string>{"."} : paths_;
  }

  std::vector<std::string> files_of() const {
    read::DiscoverOptions options = files_.discover();
    options.excluded = [this](const std::string& inside, PathKind kind) {
      return config_.why_excluded(inside, kind);
    };
    read::Discovered found = read::discover(disk_, asked(), options);
    if (!found.unusable.empty()) throw UsageError(found.unusable.front());
    for (read::LeftOut& left : found.left_out) {
      if (!left.excluded && read::is_template(left.path))
        found.files.push_back(std::move(left.path));
    }
    if (found.files.empty()) throw UsageError("no model file in " + asked().front());
    return std::move(found.files);
  }

  /// A file as it is on the disk: templates are formatted as they are written.
  void take(const std::string& path) {
    Sources sources;
    read::Workspace workspace(disk_, sources);
    const read::File& file = workspace.open(path);
    if (!file.document) throw UsageError(path + ": " + file.problem);
    const author::Formatted result = formatted(path, *file.document);
    if (result.outcome != FormatOutcome::kDone) {
      ++refused_;
      if (result.outcome == FormatOutcome::kWouldDiffer) ++faults_;
      return say("rigor: " + report::printable(path) + " is unchanged: " + result.refused);
    }
    if (result.edits.empty()) return;
    ++changed_;
    if (diff_) {
      write({0, {}}, unified_diff(path, file.document->bytes(), result.edits));
    } else if (check_) {
      write({0, {}}, path + '\n');
    } else {
      replace_found(asked(), path, result.text);
    }
  }

  int run_stdin() const {
    const std::string bytes{std::istreambuf_iterator<char>(std::cin), {}};
    const std::string path = stdin_filename_.empty() ? "stdin" : stdin_filename_;
    const xml::Document document = xml::parse(bytes, SourceId{0});
    const author::Formatted result = formatted(path, document);
    if (result.outcome != FormatOutcome::kDone) {
      say("rigor: " + report::printable(path) + ": " + result.refused);
      return result.outcome == FormatOutcome::kWouldDiffer ? kInternal : kFindings;
    }
    if (diff_) {
      write({0, {}}, unified_diff(path, bytes, result.edits));
    } else if (!check_) {
      write({0, {}}, result.text);
    }
    return (check_ || diff_) && !result.edits.empty() ? kFindings : kClean;
  }

  author::Formatted formatted(const std::string& path, const xml::Document& document) const {
    const author::FormatStyle style = author::configured_style(config_.of(path).layout);
    return lines_.empty() ? author::formatted(document, style, *order_)
                          : author::formatted_in_lines(document, style, range_.first, range_.last);
  }

  void summarize(std::size_t files) const {
    const std::string words = check_ || diff_ ? "would be formatted" : "formatted";
    std::string line =
        fmt::format("rigor: {} of {} {}", changed_, report::counted(files, "file"), words);
    if (refused_ > 0) line += ", " + report::counted(refused_, "file") + " left unchanged";
    say(line);
  }

  std::vector<std::string> paths_;
  bool check_ = false;
  bool diff_ = false;
  bool stdin_ = false;
  std::string lines_;
  std::string stdin_filename_;
  FileOptions files_;
  ConfigOptions config_;
  RealDisk disk_;
  std::optional<Environment> environment_;  // while it runs
  std::optional<author::ChildOrder> order_;
  Lines range_;
  std::size_t changed_ = 0;
  std::size_t refused_ = 0;
  std::size_t faults_ = 0;
};

}  // namespace

std::unique_ptr<Command> fmt_command() { return std::make_unique<Fmt>(); }

}  // namespace rigor::tool
