// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The inertials of a whole model: what is written beside what the shapes say, and the edits that put
// the second in place of the first.
//
//   ModelInertia table = model_inertia(environment, sources, loaded, surveys, options);
//   for (const LinkInertia& link : table.links) show(link.written.body, link.computed);
//   std::optional<std::string> text = apply_edits(bytes, table.edits);
//
// Which links are faulty is what the rules of the category `inertia` say: one judgment for the table,
// `validate` and what is written. A link's mass is the one given for it; else, when a density is given,
// density times volume; else the written one, when it is above zero; else water's.

#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <rigor/mass/link_body.h>
#include <rigor/mass/proposal.h>
#include <rigor/mass/resolve.h>
#include <rigor/model/frames.h>
#include <rigor/model/model.h>
#include <rigor/read/load.h>
#include <rigor/rules/environment.h>
#include <rigor/text/diagnostic.h>
#include <rigor/text/edit.h>
#include <rigor/text/sources.h>

namespace rigor::mass {
class MeshSurveys;
}  // namespace rigor::mass

namespace rigor::author {

/// Which links' inertials are computed anew.
enum class Only : std::uint8_t {
  kFaulty,       ///< those in which a rule finds a fault
  kMissing,      ///< those without an inertial, or with a part of one
  kImplausible,  ///< those that have one, in which a rule finds a fault
  kAll,          ///< all whose shapes have an answer
};

struct InertiaOptions {
  Only only = Only::kFaulty;
  std::optional<double> density;         ///< kg/m³, of every part
  std::map<std::string, double> masses;  ///< kg, by a link's name or scoped name
  /// Nothing: the collisions, and the visuals of a link where those have no answer.
  std::optional<mass::From> from;
  /// Whether an automatic inertial becomes numbers, for consumers older than SDF 1.11.
  bool bake = false;
};

struct LinkInertia {
  model::Id<model::Link> link;
  std::string name;        ///< scoped
  mass::Resolved written;  ///< what a consumer takes today
  mass::LinkBody body;     ///< the shapes that were examined
  mass::PartOverlaps overlaps;
  std::optional<mass::Proposal> computed;  ///< nothing when the shapes have no answer
  std::vector<Diagnostic> findings;        ///< what the rules find in it as it stands
  bool chosen = false;                     ///< whether `edits` write it
  /// Why it is not chosen, or has no answer: "collision 'hull': the mesh is not found".
  std::string reason;

  /// How many times larger the written moments (their sum) are than the computed ones at the written
  /// mass; nothing without both.
  std::optional<double> ratio() const;
};

struct ModelInertia {
  std::string path;
  std::vector<LinkInertia> links;  ///< that the file itself holds, in its order
  std::size_t included = 0;        ///< links of included files, which are not shown
  std::vector<Edit> edits;         ///< of the file
};

/// `loaded` must be whole; its file's own links are examined.
ModelInertia model_inertia(const Environment& environment, const Sources& sources,
                           const read::Loaded& loaded, mass::MeshSurveys& surveys,
                           const InertiaOptions& options);

/// Names in `options.masses` that are no link's.
std::vector<std::string> unknown_links(const model::Root& root, const InertiaOptions& options);

}  // namespace rigor::author
