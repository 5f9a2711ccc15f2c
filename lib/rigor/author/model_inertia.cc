// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/model_inertia.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string_view>
#include <utility>

#include <rigor/model/subject.h>
#include <rigor/rules/mesh_finder.h>
#include <rigor/rules/runner.h>
#include <rigor/write/write_inertial.h>

namespace rigor::author {
namespace {

using mass::From;
using mass::NoSolid;
using mass::PartBody;
using model::Id;

std::string_view reason(NoSolid why) {
  switch (why) {
    case NoSolid::kNone: return "";
    case NoSolid::kNoShape: return "it has no shape";
    case NoSolid::kSize: return "a size is not above zero";
    case NoSolid::kUnbounded: return "its shape has no volume";
    case NoSolid::kNoMesh: return "its mesh is not found";
    case NoSolid::kMesh: return "its mesh, or the part of it that is named, cannot be read";
    case NoSolid::kOutline: return "its outline encloses nothing, or crosses itself";
    case NoSolid::kFrame: return "its pose cannot be resolved";
  }
  return "";
}

std::string reason_of(const PartBody& part, From from) {
  const bool flat = part.why == NoSolid::kMesh && part.mesh == mass::MeshState::kFlat;
  return std::string(from == From::kCollisions ? "collision" : "visual") + " '" + part.name +
         "': " + std::string(flat ? "its mesh is flat and encloses nothing" : reason(part.why));
}

/// Why a body has no answer; empty when it has one.
std::string reason_of(const mass::LinkBody& body) {
  if (body.parts.empty()) {
    return body.from == From::kCollisions ? "it has no collision" : "it has no visual";
  }
  for (const PartBody& part : body.parts) {
    if (part.why != NoSolid::kNone) return reason_of(part, body.from);
  }
  return {};
}

/// The rules of the category that a new tensor could satisfy, over one file.
Diagnostics inertia_findings(const Environment& environment, const Sources& sources,
                             const read::Loaded& loaded, mass::MeshSurveys& surveys) {
  constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();
  const rules::Selection selection{
      .select = {"inertia"},
      // These refer to the mass, which stays as its author wrote it, to what a simulator computes, or to
      // moments that are those of a template by their digits alone, as the shapes' may be.
      .ignore = {"automatic-inertia-density-default", "density-too-high", "density-too-low",
                 "inertia-density-impossible", "inertia-placeholder", "light-link-between-heavy",
                 "mass-ratio-across-joint"},
      .max_listed = kAll};
  return rules::Runner(environment.registry, selection)
      .run(environment, sources, loaded, {.surveys = &surveys});
}

class Table {
 public:
  Table(const Environment& environment, const Sources& sources, const read::Loaded& loaded,
        mass::MeshSurveys& surveys, const InertiaOptions& options)
      : root_(loaded.root),
        document_(*loaded.file->document),
        frames_(loaded.root),
        find_mesh_(rules::mesh_finder(environment.resolver, sources, surveys)),
        options_(options),
        findings_(inertia_findings(environment, sources, loaded, surveys)) {
    table_.path = loaded.file->path;
    for (const Diagnostic& finding : findings_.list())
      by_subject_.emplace(finding.subject, &finding);
  }

  ModelInertia make() {
    for (std::uint32_t i = 0; i < root_.links.size(); ++i) {
      if (root_.own(root_.links[i].site)) {
        table_.links.push_back(row({i}));
        write(table_.links.back());
      } else {
        ++table_.included;
      }
    }
    return std::move(table_);
  }

 private:
  LinkInertia row(Id<model::Link> id) const {
    LinkInertia row;
    row.link = id;
    row.name = scoped_name(root_, id);
    row.written = mass::resolve(root_, frames_, id, find_mesh_);
    row.findings = findings_of(id);
    row.body = body_of(id);
    row.overlaps = overlaps_in(root_, frames_, id, row.body.from);
    row.reason = reason_of(row.body);
    if (row.body.parts.empty() && !options_.from && root_[id].visuals.empty()) {
      row.reason = "it has neither collision nor visual";
    }
    if (row.reason.empty()) compute(row);
    choose(row);
    return row;
  }

  /// Links of one name, which `duplicate-name` is about, are distinguished by where the findings stand.
  std::vector<Diagnostic> findings_of(Id<model::Link> id) const {
    const auto [first, last] = by_subject_.equal_range(model::subject(root_, root_[id]));
    const Span link = document_.element(root_[id].site.element).span();
    const auto stands_in = [&link](const Diagnostic& finding) {
      return finding.where.source == link.source && finding.where.begin >= link.begin &&
             finding.where.end <= link.end;
    };
    std::vector<Diagnostic> found;
    for (auto one = first; one != last; ++one) {
      if (stands_in(*one->second)) found.push_back(*one->second);
    }
    return found;
  }

  mass::LinkBody body_of(Id<model::Link> id) const {
    const From first = options_.from.value_or(From::kCollisions);
    mass::LinkBody body = link_body(root_, frames_, id, first, find_mesh_);
    if (options_.from || body.complete()) return body;
    mass::LinkBody visuals = link_body(root_, frames_, id, From::kVisuals, find_mesh_);
    return visuals.complete() ? visuals : body;
  }

  void compute(LinkInertia& row) const {
    row.computed = propose(root_[row.link].inertial, row.body, {given_mass(row), options_.density});
    if (!row.computed)
      row.reason = "its shapes are too small for its mass, or too large for a robot";
  }

  std::optional<double> given_mass(const LinkInertia& row) const {
    for (const std::string& name : {row.name, root_[row.link].name.value}) {
      const auto given = options_.masses.find(name);
      if (given != options_.masses.end()) return given->second;
    }
    return std::nullopt;
  }

  void choose(LinkInertia& row) const {
    if (!row.computed) return;
    const model::Link& link = root_[row.link];
    if (model::is_static(root_, link.model) && row.findings.empty()) {
      row.reason = "its model is static: nothing uses its mass";
    } else if (mass::is_automatic(link)) {
      row.chosen = options_.bake;
      if (!row.chosen) row.reason = "it is computed when the model is loaded";
    } else if (given_mass(row)) {
      row.chosen = true;
    } else {
      row.chosen = wanted(row);
      if (!row.chosen) row.reason = options_.only == Only::kFaulty ? "" : "not asked for";
    }
  }

  bool wanted(const LinkInertia& row) const {
    const model::Inertial& inertial = root_[row.link].inertial;
    const bool whole = inertial.mass.written && inertial.tensor_written &&
                       row.written.taken == mass::Taken::kWritten;
    switch (options_.only) {
      case Only::kAll: return true;
      case Only::kMissing: return !whole;
      case Only::kImplausible: return whole && !row.findings.empty();
      case Only::kFaulty: return !row.findings.empty();
    }
    return false;
  }

  void write(const LinkInertia& row) {
    // Bodies of MJCF may be in included files, and their inertials have another form.
    if (!row.chosen || root_.format == model::Format::kMjcf) return;
    const write::BlockFormat format =
        root_.format == model::Format::kUrdf ? write::BlockFormat::kUrdf : write::BlockFormat::kSdf;
    const xml::Element element = document_.element(root_[row.link].site.element);
    for (Edit& edit : write::write_inertial(document_, element, row.computed->body, format)) {
      table_.edits.push_back(std::move(edit));
    }
  }

  const model::Root& root_;
  const xml::Document& document_;
  model::Frames frames_;
  mass::FindMesh find_mesh_;
  const InertiaOptions& options_;
  Diagnostics findings_;
  std::multimap<std::string_view, const Diagnostic*> by_subject_;  // in their order
  ModelInertia table_;
};

}  // namespace

std::optional<double> LinkInertia::ratio() const {
  if (!computed || !(written.body.mass > 0)) return std::nullopt;
  const mass::MassProperties& solid = computed->body;
  const double shape = written.body.mass / solid.mass * trace(solid.about_com);
  const double share = trace(written.body.about_com) / shape;
  return std::isfinite(share) ? std::optional(share) : std::nullopt;
}

ModelInertia model_inertia(const Environment& environment, const Sources& sources,
                           const read::Loaded& loaded, mass::MeshSurveys& surveys,
                           const InertiaOptions& options) {
  return Table(environment, sources, loaded, surveys, options).make();
}

std::vector<std::string> unknown_links(const model::Root& root, const InertiaOptions& options) {
  std::vector<std::string> unknown;
  for (const auto& [name, mass] : options.masses) {
    bool known = false;
    for (std::uint32_t i = 0; i < root.links.size() && !known; ++i) {
      known =
          root.links[i].name.value == name || scoped_name(root, model::Id<model::Link>{i}) == name;
    }
    if (!known) unknown.push_back(name);
  }
  return unknown;
}

}  // namespace rigor::author
