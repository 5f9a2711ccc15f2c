// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The files of a run: each is read and parsed once, however many others include it.
//
//   Workspace workspace(disk, sources);
//   const File& file = workspace.open("robot.sdf");
//   if (file.document) walk(*file.document);

#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <rigor/read/resolver.h>
#include <rigor/read/template/expanded_file.h>
#include <rigor/text/disk.h>
#include <rigor/text/sources.h>
#include <rigor/xml/document.h>

namespace rigor::read {

/// Model files over this size are refused unread: the largest known world has 3 MB, and what is
/// read takes some twenty times its size in memory.
inline constexpr std::uint64_t kMaxModelBytes = std::uint64_t{64} << 20U;

class TemplateExpander;

struct File {
  std::string path;
  SourceId source = kNoSource;
  std::optional<xml::Document> document;  ///< nothing when the file could not be read
  std::string problem;                    ///< why not
  ReadError error = ReadError::kOther;    ///< the same, for programs
  /// What the document was made of, when the file is a xacro template; else null. It may have errors:
  /// then the document is what could be made all the same.
  std::unique_ptr<const ExpandedFile> expanded = nullptr;
};

class Workspace {
 public:
  /// Templates are expanded, with the packages and arguments of the resolver's paths. Both outlive it.
  Workspace(const Resolver& resolver, Sources& sources);
  /// All files are taken as they are.
  Workspace(const Disk& disk, Sources& sources);
  ~Workspace();

  /// The file at a path. The reference stays valid as long as the workspace. Safe across threads.
  const File& open(const std::string& path);

  /// The file at a path that is a template, expanded with other arguments: by the number of a set of them
  /// that was not asked for before, from 1.
  const File& open(const std::string& path, std::size_t set, const TemplateArguments& arguments);

  /// Takes `bytes` as what the file at `path` holds; a template is expanded.
  const File& put(const std::string& path, std::string bytes);

  /// Takes `bytes` as what the file at `path` holds wherever a template reads it. Before any is opened.
  void put_included(const std::string& path, std::string bytes);

  /// Where a URI that stands in the file `from` leads. Looked up once, however often it is included.
  const Resolution& resolve(const Resolver& resolver, const std::string& uri,
                            const std::string& from);

  /// What including the file brings, once that was counted (see include_size.h).
  std::optional<std::size_t> parts(const std::string& path);
  void keep_parts(const std::string& path, std::size_t parts);

  /// Those that were opened so far, by path.
  std::vector<const File*> files() const;

  Sources& sources() { return sources_; }
  const Disk& disk() const { return disk_; }

 private:
  const File& keep(const std::string& path, std::unique_ptr<File> file);
  std::unique_ptr<File> parsed(const std::string& path, ReadResult read) const;

  const Disk& disk_;
  std::unique_ptr<TemplateExpander> expander_;  // null where files are taken as they are
  Sources& sources_;
  mutable std::mutex mutex_;
  std::map<std::string, std::unique_ptr<File>> files_;
  std::map<std::string, std::size_t> parts_;
  std::map<std::pair<std::string, std::string>, Resolution> resolved_;  // by file and URI
};

}  // namespace rigor::read
