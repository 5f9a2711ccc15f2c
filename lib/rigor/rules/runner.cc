// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/runner.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>

#include <rigor/model/subject.h>
#include <rigor/rules/consequences.h>
#include <rigor/rules/context.h>
#include <rigor/rules/mjcf/also_for_mjcf.h>
#include <rigor/rules/registry.h>
#include <rigor/rules/xacro/template_findings.h>

namespace rigor::rules {
namespace {

bool names(const std::vector<std::string>& list, const Rule& rule) {
  return std::any_of(list.begin(), list.end(), [&rule](const std::string& name) {
    return current_name(name) == rule.name || name == to_string(rule.category);
  });
}

/// Whether a rule that is about some consumers only is asked for.
bool targeted(const Rule& rule, const Selection& selection) {
  if (rule.targets.empty()) return true;
  if (selection.compat == Compat::kSdformat && rule.refused != Refusals{}) return true;
  const auto wanted = [&selection](Target target) {
    const Targets& asked = selection.targets;
    return std::find(asked.begin(), asked.end(), target) != asked.end();
  };
  const auto& selected = selection.select;
  const auto named = [&rule](const std::string& name) { return current_name(name) == rule.name; };
  return std::any_of(selected.begin(), selected.end(), named) ||
         std::any_of(rule.targets.begin(), rule.targets.end(), wanted);
}

bool applies(Formats formats, model::Format format) {
  switch (formats) {
    case Formats::kAny: return true;
    case Formats::kSdf: return format == model::Format::kSdf;
    case Formats::kUrdf: return format == model::Format::kUrdf;
    case Formats::kModelConfig: return format == model::Format::kModelConfig;
    case Formats::kMjcf: return format == model::Format::kMjcf;
  }
  return false;
}

/// What libsdformat does for a rule's findings in a file; nothing of a model.config, which it is not asked.
Refusal refusal_in(const Refusals& refused, model::Format format) {
  if (format == model::Format::kModelConfig) return Refusal::kNever;
  return format == model::Format::kUrdf ? refused.urdf : refused.sdf;
}

const schema::Schema* schema_of(const Environment& environment, model::Format format) {
  if (format == model::Format::kSdf) return &environment.sdf;
  if (format == model::Format::kUrdf) return &environment.urdf;
  if (format == model::Format::kMjcf) return &environment.mjcf();
  return nullptr;
}

}  // namespace

std::optional<std::string> unknown_name(const Selection& selection, const Registry& registry) {
  if (selection.select.empty() && selection.ignore.empty() && selection.severity.empty())
    return std::nullopt;
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
    if (!known.contains(name)) return name;
  }
  return std::nullopt;
}

Runner::Runner(const Registry& registry, const Selection& selection)
    : max_listed_(selection.max_listed) {
  for (const Rule& rule : registry.rules()) {
    const bool selected = selection.select.empty() || names(selection.select, rule);
    if (!selected || names(selection.ignore, rule) || !targeted(rule, selection)) continue;
    Severity severity = rule.severity;
    Compat compat = selection.compat;
    Grading grading = Grading::kByFinding;
    // What is said of the rule itself counts more than what is said of its category.
    for (const std::string_view of : {to_string(rule.category), rule.name}) {
      for (const auto& [name, level] : selection.severity) {
        if (current_name(name) != of) continue;
        severity = level;
        compat = Compat::kNone;
        grading = Grading::kHeld;
      }
    }
    add(rule, severity, compat, grading);
  }
}

bool Runner::runs(std::string_view rule) const {
  return std::binary_search(active_.begin(), active_.end(), rule);
}

void Runner::add(const Rule& rule, Severity severity, Compat compat, Grading grading) {
  active_.push_back(rule.name);  // sorted, as the registry is
  has_assembly_ = has_assembly_ || rule.category == Category::kAssembly;
  for (const Check& check : rule.checks) {
    std::visit(
        [&](const auto& one) {
          std::get<Slot<std::decay_t<decltype(one)>>>(slots_).push_back(
              {{rule.name,
                to_string(rule.category),
                rule.category == Category::kAssembly,
                {rule.why, rule.what_to_do},
                holds_for_mjcf(rule),
                severity,
                compat,
                grading,
                rule.formats,
                rule.refused},
               one});
        },
        check);
  }
}

bool Runner::leaves_out_assembly(const model::Root& root, const Meshes& meshes) const {
  if (meshes.assembles || !has_assembly_) return false;
  const auto is_mesh = [&root](const auto& each) {
    return root.own(each.site) && std::holds_alternative<model::Mesh>(each.geometry.shape);
  };
  return std::any_of(root.collisions.begin(), root.collisions.end(), is_mesh) ||
         std::any_of(root.visuals.begin(), root.visuals.end(), is_mesh);
}

/// One file's walk: what the checks share while it lasts.
class Runner::Walk {
 public:
  Walk(const Runner& runner, const Environment& environment, const Sources& sources,
       const read::Loaded& loaded, const Meshes& meshes)
      : runner_(runner),
        loaded_(loaded),
        files_(meshes.files),
        assembles_(!runner.leaves_out_assembly(loaded.root, meshes)),
        frames_(loaded.root),
        inputs_{loaded.file->path,
                sources,
                loaded.file->document ? &*loaded.file->document : nullptr,
                loaded.root,
                frames_,
                environment.resolver,
                schema_of(environment, loaded.root.format),
                environment.sdf,
                meshes.surveys,
                meshes.files,
                runner.max_listed_},
        context_(inputs_, diagnostics_) {}

  Diagnostics run() {
    check_all();
    return taken();
  }

  template <class Fact>
  Diagnostics run(const std::vector<Fact>& given) {
    for (const Fact& fact : given) facts(fact);
    return taken();
  }

  std::vector<Diagnostics> run_each(const simulate::Facts& given) {
    std::vector<Diagnostics> said;
    for (const simulate::Fact& fact : given) {
      facts(fact);
      said.push_back(taken());
    }
    return said;
  }

  /// Rules of other categories look at the whole robot.
  Diagnostics run_on_links() {
    of_links_alone_ = true;
    const model::Root& root = loaded_.root;
    entities(root.links);
    entities(root.collisions);
    entities(root.visuals);
    check_meshes(root.collisions, MeshRole::kCollision);
    check_meshes(root.visuals, MeshRole::kVisual);
    return taken();
  }

  Diagnostics run(const mass::MeshFacts& mesh) {
    check_file({mesh});
    return taken();
  }

 private:
  Diagnostics taken() {
    context_.report_counted();
    diagnostics_.sort();
    return without_consequences(std::exchange(diagnostics_, {}));
  }

  void check_all() {
    for (const read::Fact& fact : loaded_.facts) facts(fact);
    const auto& document = loaded_.file->document;
    if (!document) return;
    for (const xml::Fault& fault : document->faults()) facts(fault);
    for (const read::ConfigFact& fact : loaded_.config_facts) facts(fact);
    for (const read::MjcfFact& fact : loaded_.mjcf_facts) facts(fact);
    check_schema();
    // What a cut file lacks is not the author's doing: only what is there is spoken of.
    if (document->complete()) check_model();
  }

  /// Whether the rule has a say in this file, which its findings are then reported of.
  bool begin(const Active& active) {
    const model::Format format = loaded_.root.format;
    if (!applies(active.formats, format) || (active.of_assembly && !assembles_)) return false;
    if (format == model::Format::kMjcf && !active.of_mjcf) return false;
    constexpr std::string_view kOfLinks[] = {"inertia", "geometry", "mesh"};
    if (of_links_alone_ &&
        std::find(std::begin(kOfLinks), std::end(kOfLinks), active.category) == std::end(kOfLinks))
      return false;
    context_.begin_rule(active.rule, active.category, active.severity, active.prose);
    if (active.grading == Grading::kHeld) context_.hold_severity();
    if (active.compat == Compat::kSdformat) context_.judge_by(refusal_in(active.refused, format));
    return true;
  }

  template <class Fact>
  void facts(const Fact& fact) {
    using Kind = std::decay_t<decltype(fact.kind)>;
    for (const auto& slot : std::get<Slot<FactCheck<Fact, Kind>>>(runner_.slots_)) {
      const auto& kinds = slot.second.kinds;
      if (std::find(kinds.begin(), kinds.end(), fact.kind) == kinds.end()) continue;
      if (begin(slot.first)) slot.second.check(fact, context_);
    }
  }

  /// Each check in turn, so that its code is at hand for all that it looks at.
  template <class Entity>
  void check_each(const std::vector<const Entity*>& list) {
    if (list.empty()) return;
    for (const auto& [active, check] : std::get<Slot<CheckOf<Entity>>>(runner_.slots_)) {
      if (!begin(active)) continue;
      for (const Entity* entity : list) check(*entity, context_);
    }
  }

  /// The entities that the file itself holds; what it includes is reported when that is checked.
  template <class Entity>
  void entities(const std::vector<Entity>& list) {
    std::vector<const Entity*> own;
    own.reserve(list.size());
    for (const Entity& entity : list) {
      if (loaded_.root.own(entity.site)) own.push_back(&entity);
    }
    check_each(own);
  }

  void check_schema() {
    const auto& document = *inputs_.document;
    const auto top = document.root();
    if (!top || inputs_.schema == nullptr) return;
    auto node = inputs_.schema->root(top->name(), {loaded_.root.version});
    // 1.0 and 1.2 begin with <gazebo>: what begins with <sdf>, libsdformat takes for what came after.
    constexpr schema::Version kFirstWithSdf{3};
    if (!node && loaded_.root.version < kFirstWithSdf.minor) {
      node = inputs_.schema->root(top->name(), kFirstWithSdf);
    }
    if (!node) return;
    const auto included = [this](xml::Element include) {
      return loaded_.mjcf_includes.root_of(include);
    };
    read::check_conformance(
        document, *node, [this](const read::SchemaFact& fact) { facts(fact); },
        loaded_.mjcf_includes.empty() ? read::Included() : read::Included(included));
  }

  void check_model() {
    const model::Root& root = loaded_.root;
    check_each<model::Root>({&root});
    for (const model::FrameProblem& problem : frames_.problems()) {
      if (problem.where.source == root.source && !follows_from_include(problem)) facts(problem);
    }
    entities(root.worlds);
    entities(root.models);
    entities(root.links);
    entities(root.joints);
    entities(root.frames);
    entities(root.collisions);
    entities(root.visuals);
    entities(root.sensors);
    entities(root.lights);
    entities(root.plugins);
    entities(root.includes);
    entities(root.physics);
    entities(root.gazebo_blocks);
    entities(root.controlled_joints);
    check_meshes(root.collisions, MeshRole::kCollision);
    check_meshes(root.visuals, MeshRole::kVisual);
  }

  enum class MeshRole { kCollision, kVisual };

  template <class Entity>
  void check_meshes(const std::vector<Entity>& list, MeshRole role) {
    for (const Entity& entity : list) {
      const auto* mesh = std::get_if<model::Mesh>(&entity.geometry.shape);
      if (mesh == nullptr || !loaded_.root.own(entity.site)) continue;
      bool painted = false;
      if constexpr (std::is_same_v<Entity, model::Visual>) painted = entity.material.written;
      const MeshUse use{*mesh, entity.geometry, context_.subject(entity),
                        role == MeshRole::kCollision, painted};
      check_each<MeshUse>({&use});
      check_file_of(use);
    }
  }

  void check_file_of(const MeshUse& use) {
    if (files_ == nullptr || std::get<Slot<CheckOf<MeshFile>>>(runner_.slots_).empty()) return;
    if (use.mesh.uri.value.empty()) return;
    const read::Resolution& found = context_.resolve(use.mesh.uri.value);
    if (!found.path) return;
    const auto& [x, y, z] = use.mesh.scale.value;
    if (!looked_at_.insert({*found.path, use.collision, x, y, z}).second) return;
    const auto depth = use.collision ? mass::MeshDepth::kShape : mass::MeshDepth::kFile;
    check_file({files_->find(*found.path, depth), &use});
  }

  void check_file(const MeshFile& file) {
    context_.begin_mesh(file.facts.path);
    check_each<MeshFile>({&file});
    context_.end_mesh();
  }

  /// A name may be missing only because the file that has it could not be included.
  bool follows_from_include(const model::FrameProblem& problem) const {
    const auto& includes = loaded_.root.includes;
    return std::any_of(includes.begin(), includes.end(), [&problem](const model::Include& include) {
      return !include.followed && include.model == problem.model && include.world == problem.world;
    });
  }

  const Runner& runner_;
  const read::Loaded& loaded_;
  mass::MeshFiles* files_;
  const bool assembles_;
  bool of_links_alone_ = false;
  std::set<std::tuple<std::string, bool, double, double, double>> looked_at_;
  model::Frames frames_;
  Diagnostics diagnostics_;
  Context::Inputs inputs_;
  Context context_;
};

Diagnostics Runner::run(const Environment& environment, const Sources& sources,
                        const read::Loaded& loaded, const Meshes& meshes) const {
  return Walk(*this, environment, sources, loaded, meshes).run();
}

Diagnostics Runner::run_on_links(const Environment& environment, const Sources& sources,
                                 const read::Loaded& loaded, const Meshes& meshes) const {
  return Walk(*this, environment, sources, loaded, meshes).run_on_links();
}

Diagnostics Runner::run(const Environment& environment, const Sources& sources,
                        const read::Loaded& loaded, const convert::Notes& notes) const {
  return in_source(Walk(*this, environment, sources, loaded, {}).run(notes), *loaded.file, sources);
}

Diagnostics Runner::run(const Environment& environment, const Sources& sources,
                        const read::Loaded& loaded,
                        const std::vector<xacro::Fact>& expansion) const {
  return Walk(*this, environment, sources, loaded, {}).run(expansion);
}

Diagnostics Runner::run(const Environment& environment, const Sources& sources,
                        const read::Loaded& loaded, const SuppressionFacts& suppressions) const {
  return Walk(*this, environment, sources, loaded, {}).run(suppressions);
}

std::vector<Diagnostics> Runner::run_each(const Environment& environment, const Sources& sources,
                                          const read::Loaded& loaded,
                                          const simulate::Facts& shown) const {
  std::vector<Diagnostics> said = Walk(*this, environment, sources, loaded, {}).run_each(shown);
  for (Diagnostics& one : said) one = in_source(std::move(one), *loaded.file, sources);
  return said;
}

Diagnostics Runner::run(const Environment& environment, const Sources& sources,
                        const mass::MeshFacts& mesh) const {
  read::File file;  // no model: what rules on mesh files ask of one is its path
  file.path = mesh.path;
  read::Loaded loaded;
  loaded.file = &file;
  return Walk(*this, environment, sources, loaded, {}).run(mesh);
}

}  // namespace rigor::rules
