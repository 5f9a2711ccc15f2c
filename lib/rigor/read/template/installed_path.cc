// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/template/installed_path.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/read/package_manifest.h>
#include <rigor/text/path.h>

namespace rigor::read {
namespace {

/// The largest known has 0.1 MB.
constexpr std::uint64_t kMaxCMakeBytes = std::uint64_t{1} << 20U;

/// The words of the command that `text` begins with, up to its closing parenthesis, without quotes and
/// comments.
std::vector<std::string> words_of_command(std::string_view text) {
  std::vector<std::string> words;
  std::string word;
  const auto end_word = [&] {
    if (!word.empty()) words.push_back(std::exchange(word, {}));
  };
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"') {
      quoted = !quoted;
    } else if (!quoted && c == '#') {
      i = std::min(text.find('\n', i), text.size());
      end_word();
    } else if (!quoted && c == ')') {
      break;
    } else if (!quoted && (c == ' ' || c == '\t' || c == '\n' || c == '\r')) {
      end_word();
    } else {
      word += c;
    }
  }
  end_word();
  return words;
}

bool is_keyword(std::string_view word) {
  constexpr std::string_view kKeywords[] = {"DESTINATION",
                                            "PATTERN",
                                            "REGEX",
                                            "USE_SOURCE_PERMISSIONS",
                                            "FILE_PERMISSIONS",
                                            "COMPONENT",
                                            "OPTIONAL",
                                            "EXCLUDE",
                                            "TYPE",
                                            "DIRECTORY_PERMISSIONS",
                                            "CONFIGURATIONS",
                                            "FILES_MATCHING"};
  return std::find(std::begin(kKeywords), std::end(kKeywords), word) != std::end(kKeywords);
}

/// What is below share/PACKAGE of a destination; nothing of any other.
std::optional<std::string> below_share(std::string_view destination) {
  std::size_t skipped = 0;
  if (destination.starts_with("share/")) {
    const std::size_t slash = destination.find('/', 6);
    skipped = slash == std::string_view::npos ? destination.size() : slash + 1;
  } else if (constexpr std::string_view kCatkin = "${CATKIN_PACKAGE_SHARE_DESTINATION}";
             destination.starts_with(kCatkin)) {
    skipped = std::min(destination.size(), kCatkin.size() + 1);
  } else {
    return std::nullopt;
  }
  std::string rest(destination.substr(skipped));
  while (rest.ends_with('/')) rest.pop_back();
  return rest;
}

void add_command(const std::vector<std::string>& words, std::vector<InstalledFolder>& folders) {
  const auto destination = std::find(words.begin(), words.end(), "DESTINATION");
  if (words.empty() || words.front() != "DIRECTORY" || destination == words.end() ||
      destination + 1 == words.end()) {
    return;
  }
  const std::optional<std::string> to = below_share(*(destination + 1));
  if (!to) return;
  for (std::size_t i = 1; i < words.size() && !is_keyword(words[i]); ++i) {
    std::string from = words[i];
    if (from.find('$') != std::string::npos) continue;
    // With a slash at its end it is what the folder holds, else the folder itself.
    const bool contents = from.ends_with('/');
    while (from.ends_with('/')) from.pop_back();
    if (from.empty() || from == ".") continue;
    folders.push_back({from, contents ? *to : join_path(*to, file_name(from))});
  }
}

}  // namespace

std::vector<InstalledFolder> installed_folders(std::string_view cmake) {
  constexpr std::string_view kInstall = "install(";
  std::vector<InstalledFolder> folders;
  for (std::size_t at = cmake.find(kInstall); at != std::string_view::npos;
       at = cmake.find(kInstall, at + 1)) {
    const std::size_t line = at == 0 ? 0 : cmake.rfind('\n', at - 1) + 1;
    if (cmake.substr(line, at - line).find('#') != std::string_view::npos) continue;  // a comment
    add_command(words_of_command(cmake.substr(at + kInstall.size())), folders);
  }
  return folders;
}

std::optional<std::string> source_of_installed(const Disk& disk, const std::string& path) {
  std::string package(parent_path(path));
  for (int up = 0; up < kMaxAncestors; ++up) {
    if (disk.kind(join_path(package, "package.xml")) == PathKind::kFile) break;
    std::string above(parent_path(package));
    if (above == package || above.empty()) return std::nullopt;
    package = std::move(above);
  }
  const ReadResult cmake = disk.read(join_path(package, "CMakeLists.txt"), kMaxCMakeBytes);
  if (!cmake.bytes) return std::nullopt;
  const std::string inside = relative_path(package, path);
  for (const InstalledFolder& folder : installed_folders(*cmake.bytes)) {
    const bool is_below = folder.to.empty() || inside.starts_with(folder.to + '/');
    if (!is_below) continue;
    const std::string_view rest =
        std::string_view(inside).substr(folder.to.empty() ? 0 : folder.to.size() + 1);
    std::string source = join_path(join_path(package, folder.from), rest);
    if (disk.kind(source) == PathKind::kFile) return source;
  }
  return std::nullopt;
}

}  // namespace rigor::read
