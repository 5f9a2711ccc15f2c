// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/scaffold.h>

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <utility>

#include <rigor/author/embedded_templates.h>

namespace rigor::author {
namespace {

constexpr std::string_view kCommonFolder = "common";
constexpr std::string_view kRos2Folder = "ros2";
constexpr std::string_view kAddFolder = "add";  // of verbs/add_template.h
constexpr std::string_view kNamePlaceholder = "@NAME@";

std::string_view template_of(const EmbeddedFile& file) {
  return file.path.substr(0, file.path.find('/'));
}

// Of ASCII alone, whatever the locale.
bool is_name_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_name_char(char c) {
  return is_name_letter(c) || (c >= '0' && c <= '9') || c == '_' || c == '-';
}

std::string lower_name(std::string_view name) {
  std::string lower(name);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

/// Files that Windows takes for devices, with any ending and in any case.
bool is_device_name(std::string_view name) {
  constexpr std::string_view kDevices[] = {"aux", "con", "nul", "prn"};
  const std::string lower = lower_name(name);
  if (std::find(std::begin(kDevices), std::end(kDevices), lower) != std::end(kDevices)) return true;
  return lower.size() == 4 && (lower.starts_with("com") || lower.starts_with("lpt")) &&
         lower[3] >= '1' && lower[3] <= '9';
}

/// SDF and URDF mean the world by it, wherever a link can be named.
constexpr std::string_view kWorldName = "world";

bool is_taken_name(std::string_view name) {
  return lower_name(name) == kWorldName || is_device_name(name);
}

/// What cannot be taken is an underscore, and several of them are one.
std::string name_like(std::string_view name) {
  std::string result;
  for (const char c : name) {
    const char kept = is_name_char(c) ? c : '_';
    const bool again = !result.empty() && result.back() == kept && (kept == '_' || kept == '-');
    if (!again) result += kept;
  }
  const auto is_sign = [](char c) { return c == '_' || c == '-'; };
  while (!result.empty() && is_sign(result.front())) result.erase(result.begin());
  if (result.size() > kMaxNameLength) result.resize(kMaxNameLength);
  while (!result.empty() && is_sign(result.back())) result.pop_back();
  if (result.empty()) return "my_robot";
  constexpr std::string_view kBefore = "model_";
  if (!is_name_letter(result.front())) {
    result = std::string(kBefore) + result.substr(0, kMaxNameLength - kBefore.size());
  }
  if (is_taken_name(result)) result += "_model";
  return result;
}

std::string what_of_name(std::string_view name) {
  if (name.empty()) return "is empty";
  const auto strange = std::find_if_not(name.begin(), name.end(), is_name_char);
  if (strange != name.end()) {
    if (*strange == ' ') return "has a space";
    if (*strange > ' ' && *strange <= '~') return "has a '" + std::string(1, *strange) + "'";
    // A byte of a longer character is no text by itself.
    const bool control = *strange >= 0 && *strange < ' ';
    return control || *strange == '\x7f' ? "has a control character"
                                         : "has a character beyond ASCII";
  }
  if (!is_name_letter(name.front())) return "begins with '" + std::string(1, name.front()) + "'";
  // XML has no place for them in a comment, where people will name the model.
  if (name.find("--") != std::string_view::npos) return "has two hyphens in a row";
  if (lower_name(name) == kWorldName) return "is what SDF and URDF call the world itself";
  if (is_device_name(name)) return "is a device's for Windows, which then has no such folder";
  if (name.size() > kMaxNameLength) {
    return "is longer than " + std::to_string(kMaxNameLength) + " characters";
  }
  return {};
}

std::string with_name(std::string_view text, std::string_view name) {
  std::string result;
  for (std::size_t begin = 0;;) {
    const std::size_t found = text.find(kNamePlaceholder, begin);
    result += text.substr(begin, found - begin);
    if (found == std::string_view::npos) return result;
    result += name;
    begin = found + kNamePlaceholder.size();
  }
}

/// The files of some folders of templates/, in the order of their paths.
std::vector<ScaffoldFile> files_of(std::initializer_list<std::string_view> folders,
                                   std::string_view name) {
  std::vector<ScaffoldFile> files;
  for (const EmbeddedFile& file : embedded_templates()) {
    const std::string_view folder = template_of(file);
    if (std::find(folders.begin(), folders.end(), folder) == folders.end()) continue;
    files.push_back(
        {with_name(file.path.substr(folder.size() + 1), name), with_name(file.text, name)});
  }
  std::sort(files.begin(), files.end(),
            [](const ScaffoldFile& a, const ScaffoldFile& b) { return a.path < b.path; });
  return files;
}

/// In lowercase, with single underscores in place of hyphens, and none at the end, where the suffix brings one.
std::string ros2_name_like(std::string_view name) {
  std::string result;
  for (const char c : lower_name(name)) {
    const char kept = c == '-' ? '_' : c;
    if (kept != '_' || !result.ends_with('_')) result += kept;
  }
  while (result.ends_with('_')) result.pop_back();
  return result;
}

/// Of a name that is a model's, but not a package's.
std::string what_of_ros2_name(std::string_view name) {
  if (lower_name(name) != name) return "has a capital letter";
  if (name.find('-') != std::string_view::npos) return "has a '-'";
  return name.ends_with('_') ? "ends with '_'" : "has two underscores in a row";
}

}  // namespace

std::vector<std::string_view> template_names() {
  std::vector<std::string_view> names;
  for (const EmbeddedFile& file : embedded_templates()) {
    const std::string_view name = template_of(file);
    if (name == kCommonFolder || name == kRos2Folder || name == kAddFolder) continue;
    if (names.empty() || names.back() != name) names.push_back(name);
  }
  return names;
}

std::optional<NameProblem> name_problem(std::string_view name) {
  std::string what = what_of_name(name);
  if (what.empty()) return std::nullopt;
  return NameProblem{std::move(what), name_like(name)};
}

std::vector<ScaffoldFile> scaffold(std::string_view model_template, std::string_view name) {
  const std::vector<std::string_view> names = template_names();
  if (std::find(names.begin(), names.end(), model_template) == names.end()) return {};
  return files_of({model_template, kCommonFolder}, name);
}

std::optional<NameProblem> ros2_name_problem(std::string_view name) {
  if (auto problem = name_problem(name)) {
    problem->suggestion = ros2_name_like(problem->suggestion);
    return problem;
  }
  std::string like = ros2_name_like(name);
  if (like == name) return std::nullopt;
  return NameProblem{what_of_ros2_name(name), std::move(like)};
}

std::vector<ScaffoldFile> scaffold_ros2_package(std::string_view name) {
  return files_of({kRos2Folder}, name);
}

}  // namespace rigor::author
