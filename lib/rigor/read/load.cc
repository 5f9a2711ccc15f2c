// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/load.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>

#include <rigor/read/mjcf/mjcf.h>
#include <rigor/read/sdf_reader.h>
#include <rigor/read/urdf.h>
#include <rigor/read/values.h>
#include <rigor/text/other_case.h>
#include <rigor/text/path.h>

namespace rigor::read {
namespace {

/// An SRDF has a robot's name and refers to it, and is none.
bool is_srdf(std::string_view path, xml::Element root) {
  return extension(path) == ".srdf" && root.name() == "robot";
}

/// What a document's root element says it is.
model::Format format_of(xml::Element root) {
  const std::string_view name = root.name();
  if (name == "sdf" || name == "gazebo") return model::Format::kSdf;
  if (name == "robot") return model::Format::kUrdf;
  if (name == "mujoco") return model::Format::kMjcf;
  if (name == "model" && root.child("sdf")) return model::Format::kModelConfig;
  return model::Format::kUnknown;
}

class FileLoader {
 public:
  FileLoader(const Reader& reader, const File& file) : reader_(reader) {
    loaded_.file = &file;
    loaded_.root.source = file.source;
  }

  Loaded load() {
    const File& file = *loaded_.file;
    if (!file.document) {
      const bool large = file.error == ReadError::kTooLarge;
      add(large ? FactKind::kFileTooLarge : FactKind::kFileUnreadable, {}, file.problem);
      return std::move(loaded_);
    }
    const auto top = file.document->root();
    if (!top) return std::move(loaded_);
    loaded_.root.site = site_of(*top);
    if (is_srdf(file.path, *top)) return std::move(loaded_);
    reserve_entities(*file.document);
    loaded_.root.format = format_of(*top);
    if (file_name(file.path) == "model.config" && top->name() == "model") {
      loaded_.root.format = model::Format::kModelConfig;
    }
    switch (loaded_.root.format) {
      case model::Format::kSdf: load_sdf(*top); break;
      case model::Format::kUrdf: load_urdf(*top); break;
      case model::Format::kModelConfig: load_config(); break;
      case model::Format::kMjcf: load_mjcf(); break;
      case model::Format::kUnknown:
        if (file.document->complete()) {
          add(FactKind::kUnknownRoot, top->name_span(), std::string(top->name()));
        }
        break;
    }
    return std::move(loaded_);
  }

 private:
  void add(FactKind kind, Span where, std::string name = {}) {
    loaded_.facts.push_back({kind, where, std::move(name), {}});
  }

  /// Entities are large, and all are moved when a list of them grows.
  void reserve_entities(const xml::Document& document) {
    std::size_t links = 0, joints = 0, visuals = 0, collisions = 0;
    for (std::uint32_t i = 0; i < document.element_count(); ++i) {
      const std::string_view name = document.element(i).name();
      links += name == "link" ? 1 : 0;
      joints += name == "joint" ? 1 : 0;
      visuals += name == "visual" ? 1 : 0;
      collisions += name == "collision" ? 1 : 0;
    }
    constexpr std::size_t kMost = 10'000;  // whatever a file says
    loaded_.root.links.reserve(std::min(links, kMost));
    loaded_.root.joints.reserve(std::min(joints, kMost));
    loaded_.root.visuals.reserve(std::min(visuals, kMost));
    loaded_.root.collisions.reserve(std::min(collisions, kMost));
  }

  void load_sdf(xml::Element top) {
    model::Root& root = loaded_.root;
    if (top.name() == "gazebo") add(FactKind::kOldRoot, top.name_span(), "gazebo");
    root.version_text = string_field(attribute_text(top, "version"));
    const auto version = schema::parse_version(root.version_text.value);
    root.version = reader_.sdf.latest().minor;
    if (!root.version_text.written) {
      add(FactKind::kVersionMissing, top.tag_span());
    } else if (!version || (*version < reader_.sdf.latest() && !reader_.sdf.knows(*version))) {
      add(FactKind::kVersionUnknown, root.version_text.span, root.version_text.value);
    } else if (*version > reader_.sdf.latest()) {
      add(FactKind::kVersionTooNew, root.version_text.span, root.version_text.value);
    }
    if (version) root.version = reader_.sdf.nearest(*version).minor;
    SdfReader(reader_, root, loaded_.facts, {loaded_.file->path}, root.version).read_top(top);
  }

  void load_urdf(xml::Element top) {
    model::Root& root = loaded_.root;
    root.version_text = string_field(attribute_text(top, "version"), "1.0");
    const auto version = schema::parse_version(root.version_text.value);
    root.version = reader_.urdf.nearest(version.value_or(schema::Version{0})).minor;
    if (root.version_text.written && (!version || !reader_.urdf.knows(*version))) {
      add(FactKind::kVersionUnknown, root.version_text.span, root.version_text.value);
    }
    read_urdf(root, top, {});
  }

  void load_mjcf() {
    loaded_.root.version_text.value = "1.0";
    loaded_.mjcf_includes =
        read_mjcf(loaded_.root, reader_.workspace, *loaded_.file, loaded_.mjcf_facts);
  }

  void load_config() {
    loaded_.config = read_model_config(*loaded_.file->document);
    const ModelConfig& config = loaded_.config;
    if (config.name.value.empty()) {
      loaded_.config_facts.push_back({ConfigFactKind::kNameMissing, config.site.tag, {}, {}});
    }
    if (config.entries.empty()) {
      loaded_.config_facts.push_back({ConfigFactKind::kNoSdf, config.site.tag, {}, {}});
    }
    for (const SdfEntry& entry : config.entries) check_entry(entry, config.entries.size() > 1);
  }

  void check_entry(const SdfEntry& entry, bool of_several) {
    auto& facts = loaded_.config_facts;
    if (!entry.version.written) {
      facts.push_back({ConfigFactKind::kVersionMissing, entry.site.tag, entry.file.value, {}});
    }
    const std::string path = join_path(parent_path(loaded_.file->path), entry.file.value);
    const Disk& disk = reader_.workspace.disk();
    if (entry.file.value.empty() || disk.kind(path) != PathKind::kFile) {
      const Span where = entry.file.value.empty() ? entry.site.tag : entry.file.span;
      const std::string other = OtherCase(disk).find(path);
      facts.push_back({ConfigFactKind::kFileMissing, where, entry.file.value,
                       other.empty() ? "" : relative_path(parent_path(loaded_.file->path), other)});
      return;
    }
    const File& file = reader_.workspace.open(path);
    const auto top = file.document ? file.document->root() : std::nullopt;
    if (!entry.version.written || !top || top->name() != "sdf") return;
    const std::string found = string_field(attribute_text(*top, "version")).value;
    if (!found.empty() && found != entry.version.value) {
      facts.push_back({ConfigFactKind::kVersionMismatch, entry.version.span, entry.version.value,
                       found, of_several});
    }
  }

  const Reader& reader_;
  Loaded loaded_;
};

}  // namespace

Loaded load(const Reader& reader, const File& file) { return FileLoader(reader, file).load(); }

const File* open_model(const Reader& reader, const std::string& path, Span where,
                       std::vector<Fact>& facts) {
  std::string target = path;
  const auto fail = [&](FactKind kind, std::string name) {
    facts.push_back({kind, where, std::move(name), {}});
    return nullptr;
  };
  if (reader.workspace.disk().kind(path) == PathKind::kFolder) {
    const File& config = reader.workspace.open(join_path(path, "model.config"));
    if (!config.document) return fail(FactKind::kConfigWithoutSdf, config.path);
    const ModelConfig read = read_model_config(*config.document);
    const SdfEntry* entry = choose(read);
    if (entry == nullptr) return fail(FactKind::kConfigWithoutSdf, config.path);
    target = join_path(path, entry->file.value);
  }
  const File& file = reader.workspace.open(target);
  if (!file.document) return fail(FactKind::kIncludeUnreadable, target + " " + file.problem);
  if (!file.document->complete()) {
    return fail(FactKind::kIncludeUnreadable, target + " is not well-formed XML");
  }
  return &file;
}

}  // namespace rigor::read
