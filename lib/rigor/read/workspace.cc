// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/workspace.h>

#include <utility>

#include <rigor/read/template/template_expander.h>

namespace rigor::read {

Workspace::Workspace(const Resolver& resolver, Sources& sources)
    : disk_(resolver.disk()),
      expander_(std::make_unique<TemplateExpander>(resolver)),
      sources_(sources) {}

Workspace::Workspace(const Disk& disk, Sources& sources) : disk_(disk), sources_(sources) {}

Workspace::~Workspace() = default;

const File& Workspace::open(const std::string& path) {
  {
    const std::lock_guard lock(mutex_);
    const auto found = files_.find(path);
    if (found != files_.end()) return *found->second;
  }
  if (expander_ && is_template(path)) {
    return keep(path, expander_->expand(path, sources_));
  }
  return keep(path, parsed(path, disk_.read(path, kMaxModelBytes)));
}

const File& Workspace::open(const std::string& path, std::size_t set,
                            const TemplateArguments& arguments) {
  // No path ends like this, so no file is meant by it.
  return keep(path + '\n' + std::to_string(set), expander_->expand(path, arguments, sources_));
}

const File& Workspace::put(const std::string& path, std::string bytes) {
  if (expander_ && is_template(path)) {
    expander_->replace(path, std::move(bytes));
    return keep(path, expander_->expand(path, sources_));
  }
  return keep(path, parsed(path, {std::move(bytes), {}}));
}

void Workspace::put_included(const std::string& path, std::string bytes) {
  if (expander_) expander_->replace(path, std::move(bytes));
}

const Resolution& Workspace::resolve(const Resolver& resolver, const std::string& uri,
                                     const std::string& from) {
  std::pair key(from, uri);
  {
    const std::lock_guard lock(mutex_);
    const auto found = resolved_.find(key);
    if (found != resolved_.end()) return found->second;
  }
  Resolution resolution = resolver.resolve(uri, from);
  const std::lock_guard lock(mutex_);
  return resolved_.try_emplace(std::move(key), std::move(resolution)).first->second;
}

std::optional<std::size_t> Workspace::parts(const std::string& path) {
  const std::lock_guard lock(mutex_);
  const auto found = parts_.find(path);
  if (found == parts_.end()) return std::nullopt;
  return found->second;
}

void Workspace::keep_parts(const std::string& path, std::size_t parts) {
  const std::lock_guard lock(mutex_);
  parts_.try_emplace(path, parts);
}

std::vector<const File*> Workspace::files() const {
  const std::lock_guard lock(mutex_);
  std::vector<const File*> files;
  for (const auto& [path, file] : files_) files.push_back(file.get());
  return files;
}

std::unique_ptr<File> Workspace::parsed(const std::string& path, ReadResult read) const {
  auto file = std::make_unique<File>();
  file->path = path;
  file->problem = std::move(read.problem);
  file->error = read.error;
  if (read.bytes) {
    file->source = sources_.add(path, std::move(*read.bytes));
    file->document = xml::parse(sources_.bytes(file->source), file->source);
  }
  return file;
}

const File& Workspace::keep(const std::string& path, std::unique_ptr<File> file) {
  // Two threads may have read the same file; the first to come here wins.
  const std::lock_guard lock(mutex_);
  return *files_.try_emplace(path, std::move(file)).first->second;
}

}  // namespace rigor::read
