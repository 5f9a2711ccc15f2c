// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "project/changed_since.h"

#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

#include <rigor/process/program.h>
#include <rigor/read/workspace.h>
#include <rigor/report/terminal/summary.h>
#include <rigor/text/path.h>
#include <rigor/xml/document.h>
#include "command/command.h"

namespace rigor::tool {
namespace {

/// Git reads every file of a large repository in seconds; over a network, in minutes.
constexpr process::ProgramLimits kGitLimits{.wall_seconds = 600};

std::string git(std::vector<std::string> words, const std::string& revision) {
  // Other people's settings and locks have no say; a monitor of files is a program that they name.
  words.insert(words.begin(), {"git", "--no-optional-locks", "-c", "core.fsmonitor=false"});
  const process::ProgramResult ran = process::run_program(words, kGitLimits);
  if (ran.end == process::ProgramResult::End::kExited && ran.exit_code == 0) return ran.out;
  throw UsageError("--changed-since " + revision + ": git: " + process::describe(ran, kGitLimits));
}

std::string without_line_end(std::string text) {
  if (text.ends_with('\n')) text.pop_back();
  return text;
}

/// The commit's own name, which can be nothing but a commit.
std::string commit_of(const std::string& revision, const std::string& root) {
  const process::ProgramResult ran = process::run_program(
      {"git", "-C", root, "rev-parse", "--verify", revision + "^{commit}"}, kGitLimits);
  if (ran.end == process::ProgramResult::End::kExited && ran.exit_code == 0) {
    return without_line_end(ran.out);
  }
  throw UsageError("--changed-since " + revision + ": no such commit in " + root + " (" +
                   process::describe(ran, kGitLimits) +
                   "); a shallow clone has only the last commit: fetch it first");
}

void add_paths(const std::string& list, const std::string& root, std::set<std::string>& paths) {
  for (std::size_t begin = 0; begin < list.size();) {
    const std::size_t end = list.find('\0', begin);
    paths.insert(join_path(root, std::string_view(list).substr(begin, end - begin)));
    if (end == std::string::npos) break;
    begin = end + 1;
  }
}

/// With all links followed, as git's own paths are; what is not there is as it is written.
std::string followed_path(const std::string& path) {
  std::error_code error;
  const std::filesystem::path real = std::filesystem::weakly_canonical(path, error);
  return error ? path : real.string();
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  const std::size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

/// The folder that a repository begins with, so that git need not be asked for each of many files; where
/// none is seen the folder itself, of which git knows.
std::string repository_folder(const std::string& folder) {
  std::error_code error;
  for (std::filesystem::path at = folder;; at = at.parent_path()) {
    if (std::filesystem::exists(at / ".git", error)) return at.string();
    if (at == at.parent_path()) return folder;
  }
}

/// The tops of the repositories that files and folders are in. Those that are not there are reported elsewhere.
std::set<std::string> repositories_of(const std::vector<std::string>& paths,
                                      const std::string& revision) {
  std::set<std::string> folders;
  std::error_code error;
  for (const std::string& path : paths) {
    const std::filesystem::path real = std::filesystem::canonical(path, error);
    if (error) continue;
    const bool is_folder = std::filesystem::is_directory(real, error);
    folders.insert(repository_folder(is_folder ? real.string() : real.parent_path().string()));
  }
  std::set<std::string> roots;
  for (const std::string& folder : folders) {
    roots.insert(without_line_end(git({"-C", folder, "rev-parse", "--show-toplevel"}, revision)));
  }
  return roots;
}

}  // namespace

ChangedFiles::ChangedFiles(std::string revision, std::set<std::string> paths)
    : revision_(std::move(revision)), paths_(std::move(paths)) {
  for (const std::string& path : paths_) folders_.emplace(parent_path(path));
}

bool ChangedFiles::has(const std::string& path) const {
  for (std::string at = path; at != "/" && at != "."; at = std::string(parent_path(at))) {
    if (paths_.contains(at)) return true;
  }
  return false;
}

bool ChangedFiles::concern(const Disk& disk, const read::Resolver& resolver,
                           const std::string& path) {
  const bool is = has(followed_path(path)) || names_one(disk, resolver, path);
  ++(is ? concerned_ : others_);
  return is;
}

std::optional<std::string> ChangedFiles::nothing() const {
  if (concerned_ > 0 || others_ == 0) return std::nullopt;
  return "nothing changed since " + revision_ + ": " + report::counted(others_, "file") +
         (others_ == 1 ? " is as it was" : " are as they were");
}

/// By the names of SDF, URDF and model.config for another file, wherever they stand.
bool ChangedFiles::names_one(const Disk& disk, const read::Resolver& resolver,
                             const std::string& path) const {
  const ReadResult read = disk.read(path, read::kMaxModelBytes);
  if (!read.bytes) return false;
  const xml::Document document = xml::parse(*read.bytes, kNoSource);
  for (std::uint32_t i = 0; i < document.element_count(); ++i) {
    const xml::Element element = document.element(i);
    const std::string_view name = element.name();
    if (name == "uri" || name == "sdf" || name == "filename") {
      if (leads_to_one(resolver, element.text(), path)) return true;
    }
    if (const auto file = element.attribute("filename")) {
      if (leads_to_one(resolver, file->value(), path)) return true;
    }
  }
  return false;
}

bool ChangedFiles::leads_to_one(const read::Resolver& resolver, std::string_view uri,
                                const std::string& path) const {
  uri = trimmed(uri);
  if (uri.empty()) return false;
  // `$(find arm)/urdf/leg.xacro` of a template.
  constexpr std::string_view kFind = "$(find ";
  const std::size_t close = uri.find(')');
  std::string of_package;
  if (uri.starts_with(kFind) && close != std::string_view::npos) {
    of_package = "package://" + std::string(uri.substr(kFind.size(), close - kFind.size())) +
                 std::string(uri.substr(close + 1));
    uri = of_package;
  }
  // Those places that were tried in vain hold what is gone.
  for (const read::Tried& tried : resolver.resolve(uri, path).tried) {
    const std::string place = followed_path(tried.path);
    if (has(place) || folders_.contains(place)) return true;
  }
  return false;
}

void ChangedSinceOption::declare(CLI::App& app) {
  app.add_option("--changed-since", revision_,
                 "Only files that differ from this revision of git, or that refer to one that does")
      ->type_name("REV")
      ->check([](const std::string& revision) {
        return revision.empty() ? std::string("an empty revision; is a variable not set?")
                                : std::string();
      });
}

std::optional<ChangedFiles> ChangedSinceOption::changed(
    const std::vector<std::string>& paths) const {
  if (revision_.empty()) return std::nullopt;  // not given: an empty one is refused
  // To git it would be an option.
  if (revision_.starts_with('-')) {
    throw UsageError("--changed-since takes a revision, not \"" + revision_ + '"');
  }
  std::set<std::string> changed;
  for (const std::string& root : repositories_of(paths, revision_)) {
    const std::string commit = commit_of(revision_, root);
    add_paths(git({"-C", root, "diff", "--name-only", "-z", "--no-renames", "--no-ext-diff", commit,
                   "--"},
                  revision_),
              root, changed);
    add_paths(git({"-C", root, "ls-files", "--others", "--exclude-standard", "-z"}, revision_),
              root, changed);
  }
  return ChangedFiles(revision_, std::move(changed));
}

}  // namespace rigor::tool
