// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/text/path.h>

#include <algorithm>
#include <iterator>
#include <vector>

#include <rigor/text/letter_case.h>

namespace rigor {

bool is_normal(std::string_view path) {
  if (path.empty() || path.front() == '.' || path.back() == '/') return false;
  for (std::size_t at = path.find('/'); at != std::string_view::npos; at = path.find('/', at + 1)) {
    if (path[at + 1] == '/' || path[at + 1] == '.') return false;
  }
  return true;
}

std::string normalize_path(std::string_view path) {
  if (is_normal(path)) return std::string(path);
  const bool absolute = is_absolute(path);
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t slash = path.find('/', begin);
    const std::size_t end = slash == std::string_view::npos ? path.size() : slash;
    const std::string_view part = path.substr(begin, end - begin);
    begin = end + 1;
    if (part.empty() || part == ".") continue;
    if (part == ".." && !parts.empty() && parts.back() != "..") {
      parts.pop_back();
    } else if (part != ".." || !absolute) {
      parts.push_back(part);
    }
  }
  std::string result = absolute ? "/" : "";
  for (const std::string_view part : parts) {
    if (!result.empty() && result.back() != '/') result += '/';
    result += part;
  }
  return result.empty() ? "." : result;
}

std::string join_path(std::string_view folder, std::string_view path) {
  if (is_absolute(path) || folder.empty()) return normalize_path(path);
  std::string joined;
  joined.reserve(folder.size() + path.size() + 1);
  joined += folder;
  joined += '/';
  joined += path;
  return is_normal(joined) ? joined : normalize_path(joined);
}

std::string relative_path(std::string_view folder, std::string_view path) {
  const std::string whole = normalize_path(path);
  const std::string from = normalize_path(folder);
  if (is_absolute(whole) != is_absolute(from)) return whole;
  std::string_view rest = whole;
  std::string_view up = from == "." ? std::string_view() : from;
  const auto first = [](std::string_view text) { return text.substr(0, text.find('/')); };
  const auto drop_first = [&first](std::string_view& text) {
    text.remove_prefix(std::min(text.size(), first(text).size() + 1));
  };
  while (!up.empty() && !rest.empty() && first(up) == first(rest)) {
    drop_first(up);
    drop_first(rest);
  }
  std::string result;
  for (; !up.empty(); drop_first(up)) {
    if (first(up) == "..") return whole;
    result += "../";
  }
  return normalize_path(result.append(rest));
}

std::string_view parent_path(std::string_view path) {
  const std::size_t slash = path.rfind('/');
  if (slash == std::string_view::npos) return ".";
  return slash == 0 ? path.substr(0, 1) : path.substr(0, slash);
}

std::string enclosing_folder(const std::string& path) {
  if (path == "." || file_name(path) == "..") return normalize_path(path + "/..");
  return std::string(parent_path(path));
}

std::string_view file_name(std::string_view path) { return path.substr(path.rfind('/') + 1); }

std::string extension(std::string_view path) {
  const std::string_view name = file_name(path);
  const std::size_t dot = name.rfind('.');
  if (dot == std::string_view::npos || dot == 0) return {};
  return lowered(name.substr(dot));
}

bool is_model_data(std::string_view path) {
  constexpr std::string_view kEndings[] = {
      ".3ds",  ".bmp", ".config", ".dae",  ".dds",  ".fbx",  ".gif",   ".glb",   ".gltf", ".hdr",
      ".jpeg", ".jpg", ".mesh",   ".mjcf", ".mtl",  ".obj",  ".ply",   ".png",   ".sdf",  ".srdf",
      ".stl",  ".tga", ".tif",    ".tiff", ".urdf", ".webp", ".world", ".xacro", ".xml",  ".xsdf"};
  return std::find(std::begin(kEndings), std::end(kEndings), extension(path)) != std::end(kEndings);
}

bool is_absolute(std::string_view path) { return path.starts_with('/'); }

}  // namespace rigor
