// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/baseline.h>

#include <algorithm>
#include <charconv>
#include <iterator>
#include <utility>

#include <fmt/core.h>

#include <rigor/rules/registry.h>
#include <rigor/rules/runner.h>
#include <rigor/text/byte_order_mark.h>
#include <rigor/text/path.h>

namespace rigor::rules {
namespace {

/// Problems of a file that are reported: more of them mean the wrong file.
constexpr std::size_t kMaxBaselineProblems = 10;

/// More findings than any file has; sums of such counts still fit.
constexpr std::size_t kMaxBaselineCount = 1'000'000'000;

constexpr std::string_view kBaselineHead =
    "# Findings that are known: how many of which rule in which file. `rigor validate "
    "--baseline-write`\n";

/// The letters that represent the most usual of what is escaped.
constexpr std::pair<char, char> kBaselineEscapes[] = {
    {'\\', '\\'}, {' ', 's'}, {'\t', 't'}, {'\n', 'n'}, {'\r', 'r'}};

std::string escaped_path(std::string_view path) {
  std::string text;
  for (const char c : path) {
    const auto* const known = std::find_if(std::begin(kBaselineEscapes), std::end(kBaselineEscapes),
                                           [c](const auto& escape) { return escape.first == c; });
    const auto byte = static_cast<unsigned char>(c);
    if (known != std::end(kBaselineEscapes)) {
      text += {'\\', known->second};
    } else if (byte < 0x20 || byte == 0x7f) {
      text += fmt::format("\\x{:02x}", byte);
    } else {
      text += c;
    }
  }
  return text;
}

/// Nothing when a \ begins no escape.
std::optional<std::string> unescaped_path(std::string_view text) {
  std::string path;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\\') {
      path += text[i];
      continue;
    }
    if (++i == text.size()) return std::nullopt;
    const auto* const known =
        std::find_if(std::begin(kBaselineEscapes), std::end(kBaselineEscapes),
                     [&](const auto& escape) { return escape.second == text[i]; });
    if (known != std::end(kBaselineEscapes)) {
      path += known->first;
      continue;
    }
    unsigned byte = 0;
    const std::string_view digits = text.substr(i + 1, 2);
    const char* const end = digits.data() + digits.size();
    if (text[i] != 'x' || digits.size() < 2 ||
        std::from_chars(digits.data(), end, byte, 16).ptr != end) {
      return std::nullopt;
    }
    path += static_cast<char>(byte);
    i += 2;
  }
  return path;
}

/// Takes lines of a baseline, one after the other.
class BaselineLines {
 public:
  BaselineFile read(std::string_view bytes) {
    if (bytes.starts_with(kByteOrderMark)) bytes.remove_prefix(kByteOrderMark.size());
    while (!bytes.empty() && file_.problems.size() < kMaxBaselineProblems) {
      const std::size_t end = std::min(bytes.find('\n'), bytes.size());
      std::string_view text = bytes.substr(0, end);
      bytes.remove_prefix(std::min(end + 1, bytes.size()));
      if (text.ends_with('\r')) text.remove_suffix(1);
      ++number_;
      if (!text.empty() && !text.starts_with('#')) line(text);
    }
    return std::move(file_);
  }

 private:
  void line(std::string_view text) {
    std::size_t count = 0;
    const auto [behind, error] = std::from_chars(text.data(), text.data() + text.size(), count);
    const auto digits = static_cast<std::size_t>(behind - text.data());
    const std::size_t space = text.find(' ', std::min(digits + 1, text.size()));
    const bool whole = error == std::errc() && digits < text.size() && text[digits] == ' ' &&
                       space != std::string_view::npos && space > digits + 1 &&
                       space + 1 < text.size();
    if (!whole) return wrong("is not `count rule path`");
    if (count == 0 || count > kMaxBaselineCount) {
      return wrong(fmt::format("counts {} findings: 1 to {} is right", count, kMaxBaselineCount));
    }
    const std::string_view rest = text.substr(space + 1);
    const std::optional<std::string> path =
        rest.find_first_of(" \t") == std::string_view::npos ? unescaped_path(rest) : std::nullopt;
    if (!path)
      return wrong("has a path with a space or a '\\' that is not written '\\s' or '\\\\'");
    const std::string_view rule = text.substr(digits + 1, space - digits - 1);
    BaselineKey key{*path, std::string(current_name(rule))};
    const auto [known, is_new] = lines_.emplace(key, number_);
    if (!is_new) {
      return wrong(fmt::format("names the rule and the file of line {} again", known->second));
    }
    file_.baseline.emplace(std::move(key), count);
  }

  void wrong(std::string what) { file_.problems.push_back({number_, std::move(what)}); }

  BaselineFile file_;
  std::uint32_t number_ = 0;
  std::map<BaselineKey, std::uint32_t> lines_;
};

/// Whether a finding says that a file was not read to its end: what is not found there may be there yet.
bool tells_of_cut_file(const Registry& registry, std::string_view name) {
  const Rule* rule = registry.find(name);
  if (rule == nullptr) return false;
  return (rule->category == Category::kXml && rule->severity == Severity::kError) ||
         name == "file-unreadable" || name == "file-too-large";
}

/// The diagnostics of a result, file by file: each is kept or not.
template <class Keep>
ValidateResult kept_of(ValidateResult result, const Keep& keep) {
  const Diagnostics all = std::exchange(result.diagnostics, {});
  for (FileSummary& file : result.files) {
    const std::size_t first = result.diagnostics.list().size();
    for (std::size_t i = file.first_finding; i < file.end_finding; ++i) {
      Diagnostic diagnostic = all.list()[i];
      if (keep(file, diagnostic)) result.diagnostics.add(std::move(diagnostic));
    }
    file.first_finding = first;
    file.end_finding = result.diagnostics.list().size();
  }
  return result;
}

}  // namespace

BaselineFile read_baseline(std::string_view bytes) { return BaselineLines().read(bytes); }

std::string baseline_text(const Baseline& baseline) {
  std::string text(kBaselineHead);
  for (const auto& [key, count] : baseline) {
    text += fmt::format("{} {} {}\n", count, key.rule, escaped_path(key.path));
  }
  return text;
}

BaselineRun::BaselineRun(const Environment& environment, const ValidateOptions& options,
                         const ValidateResult& result, BaselinePlace place)
    : environment_(environment), options_(options), place_(std::move(place)) {
  for (const FileSummary& file : result.files) {
    const std::string path = name(file.path);
    checked_.emplace(path, file.path);
    for (std::size_t i = file.first_finding; i < file.end_finding; ++i) {
      const Diagnostic& diagnostic = result.diagnostics.list()[i];
      found_[{path, std::string(diagnostic.rule)}] += diagnostic.count;
      if (tells_of_cut_file(environment.registry, diagnostic.rule)) cut_.insert(path);
    }
  }
}

std::string BaselineRun::name(const std::string& path) const {
  return relative_path(place_.folder, join_path(place_.working, path));
}

/// The entries are sorted by file, so that a runner is made once a file at most.
class BaselineRun::Knower {
 public:
  explicit Knower(const BaselineRun& run) : run_(run) {}

  bool knows(const BaselineKey& key) {
    const auto checked = run_.checked_.find(key.path);
    if (checked == run_.checked_.end()) {
      const std::string path = join_path(run_.place_.folder, key.path);
      return run_.environment_.disk.kind(path) == PathKind::kMissing;
    }
    if (run_.cut_.contains(key.path)) return false;
    const Rule* rule = run_.environment_.registry.find(key.rule);
    if (rule == nullptr) return true;  // it is gone, and its findings with it
    if (needs_meshes(*rule) && run_.options_.meshes != MeshPolicy::kOpen) return false;
    return runner(checked->second).runs(key.rule);
  }

 private:
  const Runner& runner(const std::string& path) {
    if (runner_ && path == path_) return *runner_;
    path_ = path;
    const ValidateOptions& options = run_.options_;
    Selection selection = options.selection_for ? options.selection_for(path) : options.selection;
    if (!runner_ || !(selection == selection_)) {
      runner_.emplace(run_.environment_.registry, selection);
      selection_ = std::move(selection);
    }
    return *runner_;
  }

  const BaselineRun& run_;
  std::string path_;
  Selection selection_;
  std::optional<Runner> runner_;
};

BaselineCounts BaselineRun::now(const Baseline& baseline) const {
  BaselineCounts counts;
  Knower knower(*this);
  for (const auto& [key, counted] : baseline) {
    const auto found = found_.find(key);
    const std::size_t now = found == found_.end() ? 0 : found->second;
    counts.emplace(key, knower.knows(key) ? std::optional(now) : std::nullopt);
  }
  return counts;
}

BaselineResult apply_baseline(const Baseline& baseline, const BaselineRun& run,
                              ValidateResult result) {
  BaselineResult applied;
  for (const auto& [key, now] : run.now(baseline)) {
    const std::size_t counted = baseline.at(key);
    if (now && *now < counted) applied.stale.push_back({key, counted, *now});
  }
  applied.left = kept_of(std::move(result), [&](const FileSummary& file, Diagnostic& diagnostic) {
    const BaselineKey key{run.name(file.path), std::string(diagnostic.rule)};
    const auto known = baseline.find(key);
    if (known == baseline.end()) return true;
    const std::size_t now = run.found().at(key);
    if (now <= known->second) {
      applied.hidden += diagnostic.count;
      return false;
    }
    std::string said = fmt::format("{} of these in this file {} in the baseline, {} now",
                                   known->second, known->second == 1 ? "is" : "are", now);
    diagnostic.help += (diagnostic.help.empty() ? "" : "; ") + said;
    return true;
  });
  return applied;
}

Baseline next_baseline(const Baseline& before, const BaselineRun& run) {
  Baseline next = run.found();
  for (const auto& [key, now] : run.now(before)) {
    if (now) continue;
    std::size_t& count = next[key];
    count = std::max(count, before.at(key));
  }
  return next;
}

Baseline pruned_baseline(const Baseline& before, const BaselineRun& run) {
  Baseline pruned;
  for (const auto& [key, now] : run.now(before)) {
    const std::size_t count = std::min(before.at(key), now.value_or(before.at(key)));
    if (count > 0) pruned.emplace(key, count);
  }
  return pruned;
}

}  // namespace rigor::rules
