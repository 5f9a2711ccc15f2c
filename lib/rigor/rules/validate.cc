// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/validate.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include <rigor/read/discover.h>
#include <rigor/read/load.h>
#include <rigor/read/workspace.h>
#include <rigor/rules/runner.h>
#include <rigor/text/path.h>

namespace rigor::rules {
namespace {

std::size_t own_count(const model::Root& root, const auto& entities) {
  return static_cast<std::size_t>(
      std::count_if(entities.begin(), entities.end(),
                    [&root](const auto& entity) { return root.own(entity.site); }));
}

FileSummary summarize(const read::Loaded& loaded) {
  const model::Root& root = loaded.root;
  return {loaded.file->path,           root.format,
          root.version_text.value,     own_count(root, root.models),
          own_count(root, root.links), own_count(root, root.joints)};
}

class Run {
 public:
  Run(const Environment& environment, const ValidateOptions& options, Sources& sources)
      : environment_(environment),
        options_(options),
        sources_(sources),
        workspace_(environment.disk, sources),
        runner_(environment.registry, options.selection),
        meshes_(environment.disk) {}

  ValidateResult run() {
    if (options_.buffer) {
      keep(workspace_.put(options_.buffer->path, options_.buffer->bytes));
    }
    read::Discovered found = read::discover(environment_.disk, options_.paths);
    result_.unusable = std::move(found.unusable);
    for (read::LeftOut& left : found.left_out) {
      result_.not_looked_at.push_back({std::move(left.path), std::move(left.why)});
    }
    for (const std::string& path : found.files) keep(workspace_.open(path));
    return std::move(result_);
  }

 private:
  /// What checking one file gave. A file is checked once, named or included.
  struct Checked {
    FileSummary summary;
    Diagnostics diagnostics;
    std::vector<NotLookedAt> not_looked_at;
  };

  void keep(const read::File& file) {
    const Checked& checked = check(file);
    result_.files.push_back(checked.summary);
    for (const NotLookedAt& item : checked.not_looked_at) result_.not_looked_at.push_back(item);
    for (const Diagnostic& found : checked.diagnostics.list()) result_.diagnostics.add(found);
  }

  const Checked& check(const read::File& file) {
    const std::string path = normalize_path(file.path);
    // Entered before its includes are checked, so that a cycle of includes ends here.
    const auto [entry, is_new] = checked_.try_emplace(path);
    Checked& checked = entry->second;
    if (!is_new) return checked;
    const read::Reader reader{workspace_, environment_.resolver, environment_.sdf,
                              environment_.urdf};
    read::Loaded loaded = read::load(reader, file);
    add_errors_of_includes(loaded);
    checked.summary = summarize(loaded);
    for (const read::Fact& fact : loaded.facts) {
      if (fact.kind != read::FactKind::kUnfollowedInclude) continue;
      checked.not_looked_at.push_back({file.path, "include of " + fact.name});
    }
    const bool open_meshes = options_.meshes == MeshPolicy::kOpen;
    checked.diagnostics =
        runner_.run(environment_, sources_, loaded, open_meshes ? &meshes_ : nullptr);
    return checked;
  }

  /// What is wrong inside an included file is told when that file is checked; the includer gets one
  /// fact that points there.
  void add_errors_of_includes(read::Loaded& loaded) {
    for (const model::Include& include : loaded.root.includes) {
      if (!loaded.root.own(include.site) || include.path.empty()) continue;
      const Checked& included = check(workspace_.open(include.path));
      read::Fact fact{read::FactKind::kIncludeHasErrors, include.uri.span, include.path, {}};
      for (const Diagnostic& found : included.diagnostics.list()) {
        if (found.severity == Severity::kError) fact.tried.push_back(found.message);
      }
      if (!fact.tried.empty()) loaded.facts.push_back(std::move(fact));
    }
  }

  const Environment& environment_;
  const ValidateOptions& options_;
  Sources& sources_;
  read::Workspace workspace_;
  Runner runner_;
  mass::MeshSurveys meshes_;
  std::map<std::string, Checked> checked_;
  ValidateResult result_;
};

}  // namespace

std::optional<std::string> unknown_name(const Selection& selection, const Registry& registry) {
  std::set<std::string_view> known;
  for (const Rule& rule : registry.rules()) {
    known.insert(rule.name);
    known.insert(to_string(rule.category));
  }
  for (const auto* list : {&selection.select, &selection.ignore}) {
    for (const std::string& name : *list) {
      if (!known.contains(name)) return name;
    }
  }
  for (const auto& [name, level] : selection.severity) {
    if (registry.find(name) == nullptr) return name;
  }
  return std::nullopt;
}

ValidateResult validate(const Environment& environment, const ValidateOptions& options,
                        Sources& sources) {
  return Run(environment, options, sources).run();
}

}  // namespace rigor::rules
