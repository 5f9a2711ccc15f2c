// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Runs the chosen rules over one file: walks its entities once, and hands each to the checks that
// ask for its kind.
//
//   Runner runner(registry, selection);
//   Diagnostics found = runner.run(environment, sources, loaded, {&surveys, &files});

#pragma once

#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include <rigor/convert/note.h>
#include <rigor/mass/mesh/facts.h>
#include <rigor/read/load.h>
#include <rigor/rules/compat.h>
#include <rigor/rules/environment.h>
#include <rigor/rules/meshes.h>
#include <rigor/rules/registry.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/suppression_fact.h>
#include <rigor/rules/validate.h>
#include <rigor/simulate/fact.h>
#include <rigor/text/diagnostic.h>
#include <rigor/text/sources.h>
#include <rigor/xacro/fact.h>

namespace rigor::rules {

class Runner {
 public:
  /// The registry outlives the runner.
  Runner(const Registry& registry, const Selection& selection);

  /// What the rules find, in the order of their places.
  Diagnostics run(const Environment& environment, const Sources& sources,
                  const read::Loaded& loaded, const Meshes& meshes) const;

  /// What rules on links, their shapes and meshes find, of a robot of which parts are missing.
  Diagnostics run_on_links(const Environment& environment, const Sources& sources,
                           const read::Loaded& loaded, const Meshes& meshes) const;

  /// What the rules on mesh files find of one that no model names.
  Diagnostics run(const Environment& environment, const Sources& sources,
                  const mass::MeshFacts& mesh) const;

  /// What the rules on conversions say of what became of a model.
  Diagnostics run(const Environment& environment, const Sources& sources,
                  const read::Loaded& loaded, const convert::Notes& notes) const;

  /// What the rules on xacro say of what the expander found.
  Diagnostics run(const Environment& environment, const Sources& sources,
                  const read::Loaded& loaded, const std::vector<xacro::Fact>& expansion) const;

  /// What the rules on suppressions say of the comments in a file.
  Diagnostics run(const Environment& environment, const Sources& sources,
                  const read::Loaded& loaded, const SuppressionFacts& suppressions) const;

  /// Whether a rule is among those that run.
  bool runs(std::string_view rule) const;
  /// Whether rules of the category assembly would run, and do not: the file's shapes have meshes, which are left out.
  bool leaves_out_assembly(const model::Root& root, const Meshes& meshes) const;

  /// What the rules on simulations say of each thing that a run showed, in the order of `shown`.
  std::vector<Diagnostics> run_each(const Environment& environment, const Sources& sources,
                                    const read::Loaded& loaded, const simulate::Facts& shown) const;

 private:
  /// What a check needs of its rule, beside the check: a file walks over hundreds of them, and the rules
  /// themselves lie far apart.
  /// Whether findings may have a severity of their own, or the user has set that of the rule.
  enum class Grading : std::uint8_t { kByFinding, kHeld };

  struct Active {
    std::string_view rule;
    std::string_view category;
    bool of_assembly;
    PageProse prose;
    bool of_mjcf;  ///< whether it holds for MJCF
    Severity severity;
    Compat compat;
    Grading grading;
    Formats formats;
    Refusals refused;
  };
  template <class CheckType>
  using Slot = std::vector<std::pair<Active, CheckType>>;
  template <class Variant>
  struct SlotsOf;
  template <class... Checks>
  struct SlotsOf<std::variant<Checks...>> {
    using type = std::tuple<Slot<Checks>...>;
  };

  class Walk;

  void add(const Rule& rule, Severity severity, Compat compat, Grading grading);

  SlotsOf<Check>::type slots_;
  std::vector<std::string_view> active_;  // names
  bool has_assembly_ = false;
  std::size_t max_listed_;
};

}  // namespace rigor::rules
