// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/xacro/file_pattern.h>

#include <algorithm>

namespace rigor::xacro {
namespace {

/// Whether `c` is in the set that begins behind a `[`, and where the set ends; npos where it does not.
std::size_t end_of_set(std::string_view pattern, std::size_t at) {
  std::size_t end = at;
  if (end < pattern.size() && pattern[end] == '!') ++end;
  if (end < pattern.size() && pattern[end] == ']') ++end;
  return pattern.find(']', end);
}

bool in_set(char c, std::string_view set) {
  const bool negated = set.starts_with('!');
  if (negated) set.remove_prefix(1);
  bool found = false;
  for (std::size_t i = 0; i < set.size(); ++i) {
    if (i + 2 < set.size() && set[i + 1] == '-') {
      found = found || (c >= set[i] && c <= set[i + 2]);
      i += 2;
    } else {
      found = found || c == set[i];
    }
  }
  return found != negated;
}

struct Search {
  const Disk& disk;
  std::size_t most;
  std::vector<std::string> found;

  void run(const std::string& before, std::string_view rest) {
    if (found.size() >= most) return;
    const std::size_t slash = rest.find('/');
    const std::string_view part = rest.substr(0, slash);
    const bool last = slash == std::string_view::npos;
    const std::string_view after = last ? std::string_view{} : rest.substr(slash + 1);
    if (!is_file_pattern(part)) {
      const std::string path = before + std::string(part);
      if (!last) return run(path + '/', after);
      if (disk.kind(path) != PathKind::kMissing) found.push_back(path);
      return;
    }
    for (const std::string& name : disk.list(before.empty() ? "." : before)) {
      if ((name.starts_with('.') && !part.starts_with('.')) || !matches_part(name, part)) continue;
      if (last) {
        found.push_back(before + name);
      } else if (disk.kind(before + name) == PathKind::kFolder) {
        run(before + name + '/', after);
      }
    }
  }
};

}  // namespace

bool is_file_pattern(std::string_view path) {
  return std::any_of(path.begin(), path.end(),
                     [](char c) { return c == '*' || c == '[' || c == '?'; });
}

bool matches_part(std::string_view name, std::string_view pattern) {
  std::size_t n = 0;
  std::size_t p = 0;
  std::size_t star = std::string_view::npos;  // where to go on when what follows the last `*` fails
  std::size_t retry = 0;
  while (n < name.size() || p < pattern.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = ++p;
      retry = n;
      continue;
    }
    if (n < name.size() && p < pattern.size()) {
      const std::size_t set_end =
          pattern[p] == '[' ? end_of_set(pattern, p + 1) : std::string_view::npos;
      const bool set = set_end != std::string_view::npos;
      if (set ? in_set(name[n], pattern.substr(p + 1, set_end - p - 1))
              : pattern[p] == '?' || pattern[p] == name[n]) {
        ++n;
        p = set ? set_end + 1 : p + 1;
        continue;
      }
    }
    if (star == std::string_view::npos || retry >= name.size()) return false;
    n = ++retry;
    p = star;
  }
  return true;
}

std::vector<std::string> matching_files(const Disk& disk, std::string_view pattern,
                                        std::size_t most) {
  Search search{disk, most, {}};
  const bool rooted = pattern.starts_with('/');
  search.run(rooted ? "/" : "", rooted ? pattern.substr(1) : pattern);
  std::sort(search.found.begin(), search.found.end());
  return std::move(search.found);
}

}  // namespace rigor::xacro
