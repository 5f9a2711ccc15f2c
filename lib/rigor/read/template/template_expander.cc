// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/template/template_expander.h>

#include <algorithm>

#include <rigor/read/package_index.h>
#include <rigor/read/template/installed_path.h>
#include <rigor/text/path.h>
#include <rigor/xacro/print.h>

namespace rigor::read {
namespace {

/// A disk on which some files have other bytes, by their paths from the working folder.
class DiskWithBuffers final : public Disk {
 public:
  DiskWithBuffers(const Disk& disk, const std::string& working_folder,
                  const std::map<std::string, std::string>& buffers)
      : disk_(disk), working_folder_(working_folder), buffers_(buffers) {}

  std::unique_ptr<OpenFile> open(const std::string& path) const override {
    return disk_.open(path);
  }
  ReadResult read(const std::string& path, std::uint64_t max_bytes) const override {
    if (buffers_.empty()) return disk_.read(path, max_bytes);
    const auto buffer = buffers_.find(join_path(working_folder_, path));
    if (buffer == buffers_.end()) return disk_.read(path, max_bytes);
    if (buffer->second.size() <= max_bytes) return {buffer->second, {}};
    return {std::nullopt, "is too large", ReadError::kTooLarge};
  }
  PathKind kind(const std::string& path) const override {
    const bool has_buffer =
        !buffers_.empty() && buffers_.contains(join_path(working_folder_, path));
    return has_buffer ? PathKind::kFile : disk_.kind(path);
  }
  std::vector<std::string> list(const std::string& folder) const override {
    return disk_.list(folder);
  }
  std::string obstacle(const std::string& path) const override { return disk_.obstacle(path); }

 private:
  const Disk& disk_;
  const std::string& working_folder_;
  const std::map<std::string, std::string>& buffers_;
};

/// Folders that a template may read from without a word.
class TemplateRoots {
 public:
  void add(const std::string& folder) {
    if (!folder.empty()) roots_.push_back(normalize_path(folder));
  }
  bool has(const std::string& path) const {
    const std::string normal = normalize_path(path);
    // Without a working folder nothing is known of where relative paths are.
    if (!is_absolute(normal)) return !normal.starts_with("..");
    return std::any_of(roots_.begin(), roots_.end(), [&normal](const std::string& root) {
      return root == "/" || normal.starts_with(root + '/');
    });
  }

 private:
  std::vector<std::string> roots_;
};

}  // namespace

bool is_template(std::string_view path) { return extension(path) == ".xacro"; }

TemplateExpander::TemplateExpander(const Resolver& resolver)
    : resolver_(resolver), inputs_(resolver.paths().templates) {}

std::optional<std::string> TemplateExpander::package_folder(std::string_view package,
                                                            std::string_view file) {
  const std::string& here = inputs_.working_folder;
  std::optional<std::string> folder = resolver_.package_folder(package, join_path(here, file));
  if (folder) folder = join_path(here, *folder);
  return folder;
}

void TemplateExpander::replace(const std::string& path, std::string bytes) {
  buffers_[join_path(inputs_.working_folder, path)] = std::move(bytes);
}

xacro::Expansion TemplateExpander::expansion(const std::string& path,
                                             const TemplateArguments& arguments, Sources& sources) {
  const DiskWithBuffers disk(resolver_.disk(), inputs_.working_folder, buffers_);
  xacro::World world{disk};
  TemplateRoots roots;
  roots.add(inputs_.working_folder);
  const std::string folder(parent_path(join_path(inputs_.working_folder, path)));
  const std::string tree = tree_of(resolver_.disk(), folder);
  roots.add(tree);
  // Without a package or a repository nobody can tell where the robot's tree begins.
  const std::string above(parent_path(parent_path(folder)));
  if (tree == folder && above != "/") roots.add(above);
  world.find_package = [this, &roots](std::string_view package, std::string_view file) {
    std::optional<std::string> found = package_folder(package, file);
    if (found) roots.add(*found);
    return found;
  };
  world.outside = [this, &roots](const std::string& file) {
    return !roots.has(join_path(inputs_.working_folder, file));
  };
  world.locate = [this](const std::string& missing) {
    return source_of_installed(resolver_.disk(), missing);
  };
  world.variable = inputs_.variable;
  if (!inputs_.working_folder.empty()) world.working_folder = inputs_.working_folder;
  return xacro::expand(path, world, {.arguments = arguments}, sources);
}

std::unique_ptr<File> TemplateExpander::expand(const std::string& path, Sources& sources) {
  return expand(path, inputs_.arguments, sources);
}

std::unique_ptr<File> TemplateExpander::expand(const std::string& path,
                                               const TemplateArguments& arguments,
                                               Sources& sources) {
  return file_of(path, expansion(path, arguments, sources), sources);
}

std::unique_ptr<File> TemplateExpander::file_of(const std::string& path, xacro::Expansion made,
                                                Sources& sources) {
  auto file = std::make_unique<File>();
  file->path = path;
  if (made.files.empty()) {
    file->problem = made.facts.empty() ? "cannot be read" : made.facts.front().detail;
    return file;
  }
  std::string text = made.document != nullptr ? xacro::print(*made.document, path) : std::string();
  if (text.size() > kMaxModelBytes) text.clear();
  file->source = sources.add(path, std::move(text));
  // Of what is printed here tinyxml2 refuses only what the scanner notes, and instructions that are not the first thing.
  const std::string_view printed = sources.bytes(file->source);
  const bool is_sure = printed.find("<?", 1) == std::string_view::npos;
  if (is_sure) file->document = xml::parse_own(printed, file->source);
  if (!is_sure || !file->document->faults().empty())
    file->document = xml::parse(printed, file->source);
  file->expanded = std::make_unique<ExpandedFile>(std::move(made));
  return file;
}

}  // namespace rigor::read
