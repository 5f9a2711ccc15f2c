// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/validate.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include <rigor/mass/mesh/mesh_list.h>
#include <rigor/mass/mesh/reads.h>
#include <rigor/mass/mesh/survey.h>
#include <rigor/read/discover.h>
#include <rigor/read/load.h>
#include <rigor/read/template/argument_sets.h>
#include <rigor/read/template/stand_ins.h>
#include <rigor/read/template/template_expander.h>
#include <rigor/read/workspace.h>
#include <rigor/rules/runner.h>
#include <rigor/rules/suppression.h>
#include <rigor/rules/xacro/entry_points.h>
#include <rigor/rules/xacro/template_branches.h>
#include <rigor/rules/xacro/template_findings.h>
#include <rigor/rules/xacro/template_suppressions.h>
#include <rigor/text/for_each_index.h>
#include <rigor/text/path.h>

namespace rigor::rules {
namespace {

/// What a file takes is less than what a thread costs to begin.
constexpr std::size_t kFilesPerThread = 4;

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

/// A runner for each selection; few files differ.
class Runners {
 public:
  Runners(const Registry& registry, const ValidateOptions& options)
      : registry_(registry), options_(options) {}

  const Runner& of(const std::string& path) {
    Selection selection =
        options_.selection_for ? options_.selection_for(path) : options_.selection;
    for (const auto& [known, runner] : runners_) {
      if (known == selection) return *runner;
    }
    auto runner = std::make_unique<Runner>(registry_, selection);
    return *runners_.emplace_back(std::move(selection), std::move(runner)).second;
  }

 private:
  const Registry& registry_;
  const ValidateOptions& options_;
  std::vector<std::pair<Selection, std::unique_ptr<Runner>>> runners_;
};

class Run {
 public:
  Run(const Environment& environment, const ValidateOptions& options, Sources& sources)
      : environment_(environment),
        options_(options),
        sources_(sources),
        workspace_(environment.resolver, sources),
        runners_(environment.registry, options),
        turns_(options.threads),
        reads_(environment.disk, environment.workers, turns_),
        surveys_(environment.disk, {nullptr, &reads_}),
        mesh_files_(environment.disk, mass::MeshDepth::kFile, {nullptr, &reads_}) {
    meshes_.assembles = options.meshes != MeshPolicy::kLeaveOut;
    if (options.meshes != MeshPolicy::kOpen) return;
    meshes_.surveys = options.known.surveys ? options.known.surveys : &surveys_;
    meshes_.files = options.known.files ? options.known.files : &mesh_files_;
    if (options.mesh_listing == MeshListing::kNone) return;
    mesh_list_.emplace(environment.disk, *meshes_.files,
                       options.known.turns ? options.known.turns : &turns_);
  }

  ValidateResult run() {
    const std::vector<std::string> paths = find_files();
    check_all(paths);
    for (std::size_t i = 0; i < paths.size(); ++i) {
      if (options_.shard.has(paths[i])) keep(paths[i], i);
    }
    keep_parts();
    refuse_nothing();
    return std::move(result_);
  }

 private:
  /// All that the options mean, those of other shards too; what is left out is numbered behind them.
  std::vector<std::string> find_files() {
    std::vector<std::string> paths;
    for (const auto& included : options_.included)
      workspace_.put_included(included.path, included.bytes);
    if (options_.buffer) {
      workspace_.put(options_.buffer->path, options_.buffer->bytes);
      paths.push_back(options_.buffer->path);
      if (options_.arguments_for && read::is_template(options_.buffer->path))
        arguments_[options_.buffer->path] = options_.arguments_for(options_.buffer->path);
    }
    read::Discovered found = read::discover(environment_.disk, options_.paths, options_.discover);
    result_.unusable = std::move(found.unusable);
    std::move(found.files.begin(), found.files.end(), std::back_inserter(paths));
    std::move(found.semantic.begin(), found.semantic.end(), std::back_inserter(paths));
    std::vector<read::LeftOut> left_out;
    add_templates(found.left_out, paths, left_out);
    result_.all_files = paths.size();
    for (read::LeftOut& left : left_out) {
      const std::size_t index = result_.all_files++;
      if (!options_.shard.has(left.path)) continue;
      result_.not_looked_at.push_back({std::move(left.path), std::move(left.why), index});
    }
    return paths;
  }

  /// Expansions of templates other than the one at a path.
  std::vector<const xacro::Expansion*> others_than(const std::string& path,
                                                   const std::vector<std::string>& templates) {
    std::vector<const xacro::Expansion*> others;
    for (const std::string& other : templates) {
      const read::File& file = workspace_.open(other);
      if (other != path && file.expanded) others.push_back(&file.expanded->expansion());
    }
    return others;
  }

  /// By numbers that no set has which is checked.
  std::optional<read::TemplateArguments> stand_ins(const std::string& path,
                                                   const std::vector<std::string>& templates) {
    const read::File& file = workspace_.open(path);
    if (!file.expanded || !read::lacks_argument(file.expanded->expansion())) return std::nullopt;
    return read::stand_ins(
        file.expanded->expansion(), others_than(path, templates), sources_, environment_.disk,
        [&](std::size_t number, const read::TemplateArguments& arguments) {
          const read::File& robot =
              workspace_.open(path, read::kMaxArgumentSets + 2 + number, with_given(arguments));
          return robot.expanded && robot.expanded->is_known() && makes_robot(robot);
        });
  }

  /// Behind those that are given to all templates.
  read::TemplateArguments with_given(const read::TemplateArguments& more) const {
    read::TemplateArguments arguments = environment_.resolver.paths().templates.arguments;
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }

  /// Templates that are robots join the paths; what is left of the others is left out.
  void add_templates(std::vector<read::LeftOut>& found, std::vector<std::string>& paths,
                     std::vector<read::LeftOut>& left_out) {
    std::vector<std::string> templates;
    for (read::LeftOut& left : found) {
      if (!left.excluded && read::is_template(left.path)) {
        templates.push_back(std::move(left.path));
      } else {
        left_out.push_back(std::move(left));
      }
    }
    std::set<std::string> named(options_.paths.begin(), options_.paths.end());
    for (const std::string& path : templates) {
      if (!options_.arguments_for) break;
      auto& sets = arguments_[path] = options_.arguments_for(path);
      if (!sets.empty()) named.insert(path);
    }
    for (const std::string& path : templates) {
      if (!arguments_[path].empty()) continue;
      std::optional<read::TemplateArguments> arguments = stand_ins(path, templates);
      if (!arguments) continue;
      stand_ins_.emplace(path, *std::move(arguments));
      named.insert(path);
    }
    EntryPoints entries = entry_points(templates, named, workspace_,
                                       environment_.resolver.paths().templates.working_folder);
    for (EntryPoints::Part& part : entries.parts) {
      part_of_.emplace(part.path, std::move(part.robot));
      entries.robots.push_back(std::move(part.path));
    }
    std::sort(entries.robots.begin(), entries.robots.end(), [&](const auto& a, const auto& b) {
      return std::find(templates.begin(), templates.end(), a) <
             std::find(templates.begin(), templates.end(), b);
    });
    std::move(entries.robots.begin(), entries.robots.end(), std::back_inserter(paths));
    for (EntryPoints::Unreached& one : entries.unreached) {
      unreached_.insert(one.path);
      templates_.insert(from_working_folder(one.path));
      left_out.push_back({std::move(one.path), std::move(one.why)});
    }
  }

  struct Included {
    Span where;
    std::string path;
  };

  /// What checking one file gave. A file is checked once, named or included.
  struct Checked {
    const Runner* runner = nullptr;
    FileSummary summary;
    SourceId source = kNoSource;
    Diagnostics diagnostics;
    Suppressions suppressions;
    std::size_t errors = 0;   ///< of the file itself
    std::string first_error;  ///< its message; rather of one that keeps the file from loading
    std::string_view first_error_rule;
    Span first_error_where;
    std::vector<NotLookedAt> not_looked_at;
    std::vector<Included> includes;
    bool is_template = false;
    bool is_no_robot = false;  ///< a template without errors that expands to no link
  };

  /// The files of this shard and whatever they include, a generation of includes at a time. What a file
  /// says of those that it includes is left to `keep`: then all are checked, so it depends on no order.
  void check_all(const std::vector<std::string>& paths) {
    for (const std::string& path : paths) {
      named_.insert(normalize_path(path));
      if (read::is_template(path)) templates_.insert(from_working_folder(path));
    }
    for (const auto& included : options_.included)
      templates_.insert(from_working_folder(included.path));
    std::vector<std::pair<std::string, Checked*>> generation;
    const auto add = [&](const std::string& path) {
      const auto [entry, is_new] = checked_.try_emplace(normalize_path(path));
      if (!is_new) return;
      entry->second.runner = &runners_.of(path);
      generation.emplace_back(path, &entry->second);
    };
    for (const std::string& path : paths) {
      if (options_.shard.has(path)) add(path);
    }
    while (!generation.empty()) {
      for_each_index(generation.size(), options_.known.turns ? *options_.known.turns : turns_,
                     kFilesPerThread,
                     [&](std::size_t i) { check(generation[i].first, *generation[i].second); });
      for (const auto& [path, checked] : std::exchange(generation, {})) {
        for (const Included& included : checked->includes) add(included.path);
      }
    }
  }

  void keep(const std::string& path, std::size_t index) {
    Checked& checked = checked_.at(normalize_path(path));
    std::move(checked.not_looked_at.begin(), checked.not_looked_at.end(),
              std::back_inserter(result_.not_looked_at));
    if (!checked.is_template) {
      checked.diagnostics.take(errors_of_includes(path, checked));
      checked.diagnostics.take(errors_of_suppressions(path, checked));
    }
    if (checked.is_template) drop_reported(checked.diagnostics, from_working_folder(path));
    checked.diagnostics.sort();
    if (checked.is_no_robot && checked.diagnostics.list().empty()) {
      unreached_.insert(path);
      result_.not_looked_at.push_back(
          {path, "xacro: no robot by itself, and macros that nothing calls are not checked",
           index});
      return;
    }
    checked.summary.index = index;
    checked.summary.first_finding = result_.diagnostics.list().size();
    result_.diagnostics.take(std::exchange(checked.diagnostics, {}));
    checked.summary.end_finding = result_.diagnostics.list().size();
    result_.files.push_back(checked.summary);
  }

  /// What robots read with other arguments than their defaults was checked through them. What those of other
  /// shards read is not known.
  void keep_parts() {
    if (options_.shard.of > 1 || unreached_.empty()) return;
    std::map<std::string, std::string> robots;  // by what they read
    for (const FileSummary& file : result_.files) {
      for (const std::string& path : file.reads) robots.try_emplace(path, file.path);
    }
    std::erase_if(result_.not_looked_at, [&](const NotLookedAt& left) {
      if (!left.index || !unreached_.contains(left.path)) return false;
      const auto robot = robots.find(from_working_folder(left.path));
      if (robot == robots.end()) return false;
      FileSummary part;
      part.path = left.path;
      part.format = model::Format::kUrdf;
      part.part_of = robot->second;
      part.index = *left.index;
      part.first_finding = part.end_finding = result_.diagnostics.list().size();
      result_.files.push_back(std::move(part));
      return true;
    });
  }

  /// Where folders were to be checked and nothing in them was, nobody is to take it for success.
  void refuse_nothing() {
    if (!result_.files.empty() || result_.not_looked_at.empty() || !result_.unusable.empty() ||
        options_.shard.of > 1 || options_.discover.wanted)
      return;
    for (const std::string& path : options_.paths) {
      if (environment_.disk.kind(path) == PathKind::kFolder)
        result_.unusable.push_back(path +
                                   ": all that it holds is skipped, and nothing was checked");
    }
  }

  std::string from_working_folder(std::string_view path) const {
    return join_path(environment_.resolver.paths().templates.working_folder, path);
  }

  /// Paths in it as they are seen from there.
  std::string without_working_folder(std::string text) const {
    const std::string& folder = environment_.resolver.paths().templates.working_folder;
    if (folder.empty()) return text;
    for (std::size_t at = text.find(":=" + folder + '/'); at != text.npos;
         at = text.find(":=" + folder + '/', at + 1))
      text.erase(at + 2, folder.size() + 1);
    return text;
  }

  /// Only files of this run are fixed: nobody knows which robots use others. Of one shard, those of a file
  /// that robots include are not known either.
  void drop_foreign_fixes(Diagnostic& found, const std::string& own) const {
    const auto is_foreign = [&](const Edit& edit) {
      const std::string path = from_working_folder(sources_.path(edit.span.source));
      return path != own && (options_.shard.of > 1 || !templates_.contains(path));
    };
    std::erase_if(found.fixes, [&](const Fix& fix) {
      return std::any_of(fix.edits.begin(), fix.edits.end(), is_foreign);
    });
  }

  /// Robots share files of macros: what one showed there, the next need not repeat.
  void drop_reported(Diagnostics& found, const std::string& own) {
    const auto is_new = [this](const Diagnostic& each) {
      const std::string path =
          each.where.nowhere() ? each.path : from_working_folder(sources_.path(each.where.source));
      return reported_.insert({each.rule, path, each.where.begin, each.where.end, each.message})
          .second;
    };
    Diagnostics fresh;
    for (Diagnostic each : found.list()) {
      if (!is_new(each)) continue;
      drop_foreign_fixes(each, own);
      for (Diagnostic& other : each.others) {
        is_new(other);
        drop_foreign_fixes(other, own);
      }
      fresh.add(std::move(each));
    }
    found = std::move(fresh);
  }

  /// From any thread: each file has an entry of its own.
  void check(const std::string& path, Checked& checked) {
    if (const auto part = part_of_.find(path); part != part_of_.end()) {
      checked.summary.path = path;
      checked.summary.format = model::Format::kUrdf;
      checked.summary.part_of = part->second;
      return;
    }
    const read::File& file = workspace_.open(path);
    if (file.expanded) return check_template(path, file, checked);
    read::Loaded loaded = load(file);
    checked.summary = summarize(loaded);
    checked.source = file.source;
    look_beside(loaded, checked);
    list_meshes(loaded, checked);
    if (file.document) checked.suppressions = Suppressions(*file.document);
    checked.diagnostics = checked.suppressions.uncovered(
        checked.runner->run(environment_, sources_, loaded, meshes_));
    for (const Diagnostic& found : checked.diagnostics.list()) {
      if (found.severity != Severity::kError || reported_by_includer(found.rule)) continue;
      constexpr std::string_view kShapeMissing = "mesh-not-found";
      const bool graver = checked.first_error_rule == kShapeMissing && found.rule != kShapeMissing;
      if (checked.errors == 0 || graver) {
        checked.first_error = found.message;
        checked.first_error_rule = found.rule;
        checked.first_error_where = found.where;
      }
      checked.errors += found.count;
    }
  }

  read::Loaded load(const read::File& file) {
    const read::Reader reader{workspace_, environment_.resolver, environment_.sdf,
                              environment_.urdf};
    return read::load(reader, file);
  }

  /// For what belongs to the file and is not checked in it.
  void look_beside(const read::Loaded& loaded, Checked& checked) const {
    if (checked.runner->leaves_out_assembly(loaded.root, meshes_))
      checked.not_looked_at.push_back({checked.summary.path, "assembly: meshes are not opened"});
    for (const read::Fact& fact : loaded.facts) {
      if (fact.kind != read::FactKind::kUnfollowedInclude) continue;
      checked.not_looked_at.push_back({checked.summary.path, "include of " + fact.name});
    }
    for (const model::Include& include : loaded.root.includes) {
      if (!loaded.root.own(include.site) || include.path.empty()) continue;
      checked.includes.push_back({include.uri.span, include.path});
    }
  }

  /// Those of a template that is expanded with several sets of arguments are joined.
  void list_meshes(const read::Loaded& loaded, Checked& checked) {
    if (!mesh_list_) return;
    const auto find = [&](const std::string& uri) {
      return environment_.resolver.resolve(uri, loaded.file->path).path;
    };
    std::vector<mass::OpenedMesh>& meshes = checked.summary.meshes;
    for (mass::OpenedMesh& mesh : mesh_list_->of(loaded.root, find)) {
      const auto place = std::lower_bound(
          meshes.begin(), meshes.end(), mesh.path,
          [](const mass::OpenedMesh& known, const std::string& path) { return known.path < path; });
      if (place == meshes.end() || place->path != mesh.path) meshes.insert(place, std::move(mesh));
    }
  }

  /// What the expansions of one template gave.
  struct TemplateRun {
    explicit TemplateRun(const Sources& sources) : findings(sources), suppressions(sources) {}

    TemplateFindings findings;
    TemplateSuppressions suppressions;
    TemplateBranches branches;
    std::set<std::string> reads;  ///< files of all expansions, from the working folder
    SourceId source = kNoSource;  ///< of the template, as the first expansion read it
    bool is_whole = true;         ///< all expansions are models without errors
    bool is_robot = false;        ///< one is, or might be but for its errors
  };

  /// With each of its sets of arguments; reported as one file.
  void check_template(const std::string& path, const read::File& first, Checked& checked) {
    checked.is_template = true;
    checked.source = first.source;
    TemplateRun run(sources_);
    read::ArgumentPlan plan;
    if (const auto given = arguments_.find(path); given != arguments_.end())
      plan.sets = given->second;
    const bool takes_all = options_.argument_sets == ArgumentSets::kAll;
    if (takes_all) {
      plan = read::all_arguments(first.expanded->expansion(), sources_, environment_.disk,
                                 std::move(plan));
    }
    const auto stand_ins = stand_ins_.find(path);
    if (stand_ins != stand_ins_.end()) {
      plan.sets.insert(plan.sets.begin(), read::TemplateArguments());
      for (read::TemplateArguments& set : plan.sets)
        set.insert(set.begin(), stand_ins->second.begin(), stand_ins->second.end());
    }
    if (!plan.left_out.empty()) checked.not_looked_at.push_back({path, "xacro: " + plan.left_out});
    if (plan.sets.empty() || (takes_all && stand_ins == stand_ins_.end()))
      check_expansion(first, {}, checked, run);
    for (std::size_t i = 0; i < plan.sets.size(); ++i) {
      const read::TemplateArguments arguments = with_given(plan.sets[i]);
      const std::string shown = without_working_folder(read::shown_arguments(plan.sets[i]));
      check_expansion(workspace_.open(path, i + 1, arguments), shown, checked, run);
    }
    if (run.is_whole) check_coverage(path, takes_all, checked, run);
    checked.summary.reads.assign(run.reads.begin(), run.reads.end());
    checked.diagnostics = run.findings.take();
    checked.is_no_robot = !run.is_robot && options_.template_depth == TemplateDepth::kModel;
    for (const Diagnostic& found : checked.diagnostics.list()) {
      if (found.severity == Severity::kError) ++checked.errors;
    }
  }

  /// What no single expansion shows: branches that none takes, comments that hide nothing in any.
  void check_coverage(const std::string& path, bool takes_all, const Checked& checked,
                      TemplateRun& run) {
    read::File bare;
    bare.path = path;
    bare.source = run.source;
    read::Loaded about;
    about.file = &bare;
    about.root.format = checked.summary.format;
    about.root.source = run.source;
    if (takes_all) {
      const std::vector<xacro::Fact> dead = run.branches.dead(sources_);
      run.findings.add(checked.runner->run(environment_, sources_, about, dead));
    }
    // A branch that was not taken may show what a comment in it hides.
    if (!takes_all && run.branches.has_skipped()) return;
    const SuppressionFacts unused =
        run.suppressions.facts(environment_.registry, *checked.runner, options_.meshes);
    if (unused.empty()) return;
    run.findings.add(checked.runner->run(environment_, sources_, about, unused));
  }

  /// `arguments` are reported with what is found, where they are not those that are given to all.
  void check_expansion(const read::File& file, const std::string& arguments, Checked& checked,
                       TemplateRun& run) {
    // A file of macros that a hook names by itself is no robot without links.
    const bool is_known = file.expanded && file.expanded->is_known();
    const bool is_model = options_.template_depth == TemplateDepth::kModel && is_known &&
                          makes_robot(file) && !is_srdf_template(file.path);
    run.is_whole = run.is_whole && is_model;
    run.is_robot = run.is_robot || !is_known || makes_robot(file);
    read::File bare;
    bare.path = file.path;
    read::Loaded loaded;
    loaded.file = &bare;
    if (is_model) loaded = load(file);
    if (checked.summary.path.empty()) {
      checked.summary = summarize(loaded);
      look_beside(loaded, checked);
    }
    Diagnostics found;
    if (file.expanded) {
      const std::vector<xacro::Fact>& facts = file.expanded->expansion().facts;
      found = with_calls(checked.runner->run(environment_, sources_, loaded, facts), facts);
    }
    Diagnostics all_of_model;
    Diagnostics of_model;
    if (is_model) {
      all_of_model = checked.runner->run(environment_, sources_, loaded, meshes_);
      of_model = Suppressions(*file.document).uncovered(all_of_model);
      list_meshes(loaded, checked);
      found.take(in_source(of_model, file, sources_));
    } else if (!is_known && file.expanded) {
      found.take(check_whole_links(file, checked));
    }
    if (file.expanded) {
      const xacro::Expansion& expansion = file.expanded->expansion();
      run.branches.add(expansion);
      for (const xacro::FileUse& use : expansion.files)
        run.reads.insert(from_working_folder(use.path));
      if (run.source == kNoSource) run.source = expansion.files.front().source;
      found = run.suppressions.uncovered(std::move(found), expansion);
      run.suppressions.count_copies(all_of_model, of_model);
    }
    if (arguments.empty()) return run.findings.add(std::move(found));
    Diagnostics reported;
    for (Diagnostic each : found.list()) {
      each.related.push_back({{}, "found with " + arguments});
      reported.add(std::move(each));
    }
    run.findings.add(std::move(reported));
  }

  /// Of a robot that lacks files: what is wrong with links that lack nothing, themselves.
  Diagnostics check_whole_links(const read::File& file, const Checked& checked) {
    if (options_.template_depth != TemplateDepth::kModel || is_srdf_template(file.path)) return {};
    if (!lacks_files(file.expanded->expansion()) || !file.document || !makes_robot(file)) return {};
    const std::vector<Span> links = file.expanded->whole_links(*file.document);
    const auto is_in_link = [&links](Span where) {
      return std::any_of(links.begin(), links.end(), [&where](Span link) {
        return link.begin <= where.begin && where.end <= link.end;
      });
    };
    const Diagnostics all =
        checked.runner->run_on_links(environment_, sources_, load(file), meshes_);
    const Diagnostics shown = Suppressions(*file.document).uncovered(all);
    Diagnostics found;
    for (const Diagnostic& each : shown.list()) {
      if (is_in_link(each.where)) found.add(each);
    }
    return in_source(std::move(found), file, sources_);
  }

  static bool lacks_files(const xacro::Expansion& expansion) {
    return std::any_of(expansion.facts.begin(), expansion.facts.end(), [](const xacro::Fact& fact) {
      return fact.kind == xacro::FactKind::kPackageNotFound ||
             (fact.kind == xacro::FactKind::kFileNotFound && !fact.where.nowhere());
    });
  }

  /// Where the includes of a file lead, its includers are led too, and say so.
  static bool reported_by_includer(std::string_view rule) {
    return rule == "include-cycle" || rule == "include-too-large";
  }

  /// What is wrong inside an included file is reported when that file is checked; the includer gets one
  /// finding that points there.
  Diagnostics errors_of_includes(const std::string& path, Checked& checked) {
    read::File bare;  // these facts need nothing of what the file holds
    bare.path = path;
    bare.source = checked.source;
    read::Loaded about;
    about.file = &bare;
    about.root.format = checked.summary.format;
    for (const Included& included : checked.includes) {
      const std::string& fault_path = at_fault(included.path);
      if (fault_path.empty()) continue;
      const Checked& fault = checked_.at(normalize_path(fault_path));
      about.facts.push_back({read::FactKind::kIncludeHasErrors,
                             included.where,
                             fault_path,
                             {fault.first_error},
                             fault.errors,
                             fault.first_error_where});
    }
    if (about.facts.empty()) return {};
    return each_once(checked.suppressions.uncovered(
        checked.runner->run(environment_, sources_, about, Meshes{})));
  }

  /// A file at fault is reported at the first include that leads to it, with how many do.
  static Diagnostics each_once(const Diagnostics& found) {
    std::map<std::string_view, std::size_t> times;
    for (const Diagnostic& diagnostic : found.list()) ++times[diagnostic.message];
    Diagnostics once;
    for (const Diagnostic& diagnostic : found.list()) {
      const std::size_t count = std::exchange(times[diagnostic.message], 0);
      if (count == 0) continue;
      Diagnostic first = diagnostic;
      if (count > 1) first.message += " (included " + std::to_string(count) + " times)";
      once.add(std::move(first));
    }
    return once;
  }

  /// What is wrong with the comments that suppress findings; when all findings are known. It is never
  /// suppressed itself.
  Diagnostics errors_of_suppressions(const std::string& path, const Checked& checked) {
    const SuppressionFacts facts =
        checked.suppressions.facts(environment_.registry, *checked.runner, options_.meshes);
    if (facts.empty()) return {};
    read::Loaded about;
    about.file = &workspace_.open(path);
    about.root.format = checked.summary.format;
    about.root.source = checked.source;
    return checked.runner->run(environment_, sources_, about, facts);
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
      if (named_.contains(normalize_path(path))) continue;
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
  Runners runners_;
  Turns turns_;
  mass::MeshReads reads_;
  mass::MeshSurveys surveys_;
  mass::MeshFiles mesh_files_;
  Meshes meshes_;
  std::optional<mass::MeshList> mesh_list_;
  std::set<std::string> named_;      // normal paths, those of other shards too
  std::set<std::string> templates_;  // of those, and those left out, from the working folder
  std::set<std::string> unreached_;  // templates that no robot includes with its defaults
  std::map<std::string, Checked> checked_;
  std::map<std::string, std::string> at_fault_;  // what `at_fault` gave
  std::map<std::string, std::string>
      part_of_;  // robots, by the path of a template that they include
  std::map<std::string, std::vector<read::TemplateArguments>> arguments_;  // sets, by path
  std::map<std::string, read::TemplateArguments> stand_ins_;               // by path
  std::set<std::tuple<std::string_view, std::string, std::uint32_t, std::uint32_t, std::string>>
      reported_;
  ValidateResult result_;
};

}  // namespace

ValidateResult validate(const Environment& environment, const ValidateOptions& options,
                        Sources& sources) {
  return Run(environment, options, sources).run();
}

}  // namespace rigor::rules
