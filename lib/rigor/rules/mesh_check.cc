// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/mesh_check.h>

#include <algorithm>
#include <iterator>
#include <utility>
#include <variant>

#include <rigor/model/subject.h>
#include <rigor/read/discover.h>
#include <rigor/read/load.h>
#include <rigor/read/template/template_expander.h>
#include <rigor/read/workspace.h>
#include <rigor/rules/runner.h>
#include <rigor/rules/suppression.h>
#include <rigor/rules/xacro/template_findings.h>
#include <rigor/text/path.h>

namespace rigor::rules {
namespace {

constexpr std::string_view kModels[] = {".sdf",   ".world", ".urdf",  ".config",
                                        ".xacro", ".erb",   ".jinja", ".xml"};

Selection meshes_unless_selected(const MeshCheckOptions& options, const std::string& path) {
  Selection selection = options.selection_for ? options.selection_for(path) : options.selection;
  if (selection.select.empty()) selection.select = {std::string(to_string(Category::kMesh))};
  return selection;
}

class MeshRun {
 public:
  MeshRun(const Environment& environment, const MeshCheckOptions& options, mass::MeshFiles& files,
          Sources& sources)
      : environment_(environment),
        options_(options),
        files_(files),
        sources_(sources),
        workspace_(environment.resolver, sources) {}

  MeshCheckResult run() {
    for (const std::string& path : options_.paths) {
      const bool is_file = environment_.disk.kind(path) == PathKind::kFile;
      if (is_file && !names_model(path)) {
        check_file(path);
      } else {
        check_models(path);
      }
    }
    return std::move(result_);
  }

 private:
  void check_file(const std::string& path) {
    const mass::MeshFacts& facts = files_.find(path, mass::MeshDepth::kFile);
    result_.meshes.push_back({&facts});
    result_.diagnostics.take(runner_of(path).run(environment_, sources_, facts));
  }

  Runner runner_of(const std::string& path) const {
    return {environment_.registry, meshes_unless_selected(options_, path)};
  }

  /// Of what keeps a model from being read.
  Runner reader_of(const std::string& path) const {
    return {environment_.registry, {.ignore = meshes_unless_selected(options_, path).ignore}};
  }

  void check_models(const std::string& path) {
    read::Discovered found = read::discover(environment_.disk, {path});
    std::move(found.unusable.begin(), found.unusable.end(), std::back_inserter(result_.unusable));
    for (read::LeftOut& left : found.left_out) {
      if (left.path == path && !left.excluded && read::is_template(path)) {
        check_model(path);
      } else {
        result_.left_out.push_back(std::move(left));
      }
    }
    for (const std::string& file : found.files) check_model(file);
  }

  void check_model(const std::string& path) {
    const read::Reader reader{workspace_, environment_.resolver, environment_.sdf,
                              environment_.urdf};
    const read::Loaded loaded = read::load(reader, workspace_.open(path));
    if (loaded.file->expanded && !loaded.file->expanded->ok()) {
      const std::vector<xacro::Fact>& facts = loaded.file->expanded->expansion().facts;
      Diagnostics found = reader_of(path).run(environment_, sources_, loaded, facts);
      return result_.diagnostics.take(with_calls(std::move(found), facts));
    }
    if (!is_read(loaded)) return tell_unread(loaded);
    first_of_model_ = result_.meshes.size();
    list_meshes(loaded, loaded.root.collisions);
    list_meshes(loaded, loaded.root.visuals);
    Diagnostics found = runner_of(path).run(environment_, sources_, loaded, {.files = &files_});
    const auto& document = loaded.file->document;
    if (document) found = Suppressions(*document).uncovered(std::move(found));
    TemplateFindings once(sources_);
    once.add(in_source(std::move(found), *loaded.file, sources_));
    result_.diagnostics.take(once.take());
  }

  static bool is_read(const read::Loaded& loaded) {
    const auto& document = loaded.file->document;
    return document && document->complete() && loaded.root.format != model::Format::kUnknown;
  }

  /// It is unknown which meshes such a file would name.
  void tell_unread(const read::Loaded& loaded) {
    const Diagnostics found =
        reader_of(loaded.file->path).run(environment_, sources_, loaded, Meshes{});
    for (const Diagnostic& one : found.list()) {
      if (one.severity == Severity::kError) result_.diagnostics.add(one);
    }
  }

  template <class Entity>
  void list_meshes(const read::Loaded& loaded, const std::vector<Entity>& entities) {
    for (const Entity& entity : entities) {
      const auto* mesh = std::get_if<model::Mesh>(&entity.geometry.shape);
      if (mesh == nullptr || !loaded.root.own(entity.site) || mesh->uri.value.empty()) continue;
      const auto found = environment_.resolver.resolve(mesh->uri.value, loaded.file->path);
      if (!found.path) continue;
      const mass::MeshFacts& facts = files_.find(*found.path, mass::MeshDepth::kFile);
      entry(facts, mesh->scale.value).uses.push_back(model::subject(loaded.root, entity));
    }
  }

  CheckedMesh& entry(const mass::MeshFacts& facts, const model::Vector3& scale) {
    auto& meshes = result_.meshes;
    const auto begin = meshes.begin() + static_cast<std::ptrdiff_t>(first_of_model_);
    const auto known = std::find_if(begin, meshes.end(), [&](const CheckedMesh& mesh) {
      return mesh.facts == &facts && mesh.scale == scale;
    });
    if (known != meshes.end()) return *known;
    return meshes.emplace_back(CheckedMesh{&facts, scale, {}});
  }

  const Environment& environment_;
  const MeshCheckOptions& options_;
  mass::MeshFiles& files_;
  Sources& sources_;
  read::Workspace workspace_;
  std::size_t first_of_model_ = 0;
  MeshCheckResult result_;
};

}  // namespace

bool names_model(std::string_view path) {
  const std::string ending = extension(path);
  return std::find(std::begin(kModels), std::end(kModels), ending) != std::end(kModels);
}

MeshCheckResult mesh_check(const Environment& environment, const MeshCheckOptions& options,
                           mass::MeshFiles& files, Sources& sources) {
  return MeshRun(environment, options, files, sources).run();
}

}  // namespace rigor::rules
