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
        surveys_(environment.disk),
        mesh_files_(environment.disk) {}

  ValidateResult run() {
    std::vector<const read::File*> named;
    if (options_.buffer) {
      named.push_back(&workspace_.put(options_.buffer->path, options_.buffer->bytes));
    }
    read::Discovered found = read::discover(environment_.disk, options_.paths);
    result_.unusable = std::move(found.unusable);
    for (read::LeftOut& left : found.left_out) {
      result_.not_looked_at.push_back({std::move(left.path), std::move(left.why)});
    }
    for (const std::string& path : found.files) named.push_back(&workspace_.open(path));
    check_all(named);
    for (const read::File* file : named) keep(*file);
    return std::move(result_);
  }

 private:
  struct Included {
    Span where;
    std::string path;
  };

  /// What checking one file gave. A file is checked once, named or included.
  struct Checked {
    bool named = false;
    FileSummary summary;
    Diagnostics diagnostics;
    std::size_t errors = 0;   ///< of the file itself
    std::string first_error;  ///< its message
    std::vector<NotLookedAt> not_looked_at;
    std::vector<Included> includes;
  };

  /// The files that were named and whatever they include. What a file says of those that it includes
  /// is left to `keep`: then all are checked, so it depends on no order.
  void check_all(const std::vector<const read::File*>& named) {
    std::vector<const read::File*> open(named.rbegin(), named.rend());
    while (!open.empty()) {
      const read::File& file = *open.back();
      open.pop_back();
      const auto [entry, is_new] = checked_.try_emplace(normalize_path(file.path));
      if (!is_new) continue;
      entry->second = check(file);
      for (const Included& included : entry->second.includes) {
        if (!checked_.contains(normalize_path(included.path))) {
          open.push_back(&workspace_.open(included.path));
        }
      }
    }
    for (const read::File* file : named) checked_.at(normalize_path(file->path)).named = true;
  }

  void keep(const read::File& file) {
    Checked& checked = checked_.at(normalize_path(file.path));
    result_.files.push_back(checked.summary);
    for (const NotLookedAt& item : checked.not_looked_at) result_.not_looked_at.push_back(item);
    Diagnostics about_includes = errors_of_includes(file, checked);
    if (!about_includes.list().empty()) {
      checked.diagnostics.take(std::move(about_includes));
      checked.diagnostics.sort();
    }
    result_.diagnostics.take(std::exchange(checked.diagnostics, {}));
  }

  Checked check(const read::File& file) {
    Checked checked;
    const read::Reader reader{workspace_, environment_.resolver, environment_.sdf,
                              environment_.urdf};
    read::Loaded loaded = read::load(reader, file);
    checked.summary = summarize(loaded);
    for (const read::Fact& fact : loaded.facts) {
      if (fact.kind != read::FactKind::kUnfollowedInclude) continue;
      checked.not_looked_at.push_back({file.path, "include of " + fact.name});
    }
    for (const model::Include& include : loaded.root.includes) {
      if (!loaded.root.own(include.site) || include.path.empty()) continue;
      checked.includes.push_back({include.uri.span, include.path});
    }
    const Meshes meshes =
        options_.meshes == MeshPolicy::kOpen ? Meshes{&surveys_, &mesh_files_} : Meshes{};
    checked.diagnostics = runner_.run(environment_, sources_, loaded, meshes);
    for (const Diagnostic& found : checked.diagnostics.list()) {
      if (found.severity != Severity::kError || told_by_includer(found.rule)) continue;
      if (checked.errors == 0) checked.first_error = found.message;
      checked.errors += found.count;
    }
    return checked;
  }

  /// Where the includes of a file lead, its includers are led too, and say so.
  static bool told_by_includer(std::string_view rule) {
    return rule == "include-cycle" || rule == "include-too-large";
  }

  /// What is wrong inside an included file is told when that file is checked; the includer gets one
  /// finding that points there.
  Diagnostics errors_of_includes(const read::File& file, const Checked& checked) {
    read::File bare;  // these facts need nothing of what the file holds
    bare.path = file.path;
    bare.source = file.source;
    read::Loaded about;
    about.file = &bare;
    about.root.format = checked.summary.format;
    for (const Included& included : checked.includes) {
      const std::string& path = at_fault(included.path);
      if (path.empty()) continue;
      const Checked& fault = checked_.at(normalize_path(path));
      about.facts.push_back({read::FactKind::kIncludeHasErrors,
                             included.where,
                             path,
                             {fault.first_error},
                             fault.errors});
    }
    if (about.facts.empty()) return {};
    return runner_.run(environment_, sources_, about, Meshes{});
  }

  /// The included file, or the first of those that it includes, that has errors of its own; empty
  /// when there is none. A file that was named says itself what is wrong with those it includes.
  const std::string& at_fault(const std::string& included) {
    const auto known = at_fault_.find(included);
    if (known != at_fault_.end()) return known->second;
    return at_fault_.emplace(included, find_at_fault(included)).first->second;
  }

  std::string find_at_fault(const std::string& included) const {
    std::set<std::string> seen;
    std::vector<std::string> open{included};
    while (!open.empty()) {
      const std::string path = std::move(open.back());
      open.pop_back();
      if (!seen.insert(normalize_path(path)).second) continue;
      const Checked& checked = checked_.at(normalize_path(path));
      if (checked.errors > 0) return path;
      if (checked.named) continue;
      for (auto next = checked.includes.rbegin(); next != checked.includes.rend(); ++next) {
        open.push_back(next->path);
      }
    }
    return {};
  }

  const Environment& environment_;
  const ValidateOptions& options_;
  Sources& sources_;
  read::Workspace workspace_;
  Runner runner_;
  mass::MeshSurveys surveys_;
  mass::MeshFiles mesh_files_;
  std::map<std::string, Checked> checked_;
  std::map<std::string, std::string> at_fault_;  // what `at_fault` gave
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
