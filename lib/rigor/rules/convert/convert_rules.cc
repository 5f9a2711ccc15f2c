// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A note of the account of a conversion as a finding.

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <rigor/model/model.h>
#include <rigor/rules/convert/rows.h>

namespace rigor::rules {
namespace conversion {

constexpr std::span<const Row> (*kTables[])() = {file_rows,  graph_rows, joint_rows,
                                                 link_rows,  shape_rows, carried_rows,
                                                 proof_rows, mjcf_rows,  from_mjcf_rows};

/// Kinds whose count is not of elements and attributes: of models, links, or nothing.
constexpr convert::NoteKind kWithoutElements[] = {
    convert::NoteKind::kSeveralModels, convert::NoteKind::kNoModel,
    convert::NoteKind::kUnresolved,    convert::NoteKind::kSeveralRoots,
    convert::NoteKind::kRootAdded,     convert::NoteKind::kNoRoot,
    convert::NoteKind::kNotTheSame,    convert::NoteKind::kRefused,
    convert::NoteKind::kIdle};

/// Whether more was lost than the one element or attribute that it points at.
bool lost_several(const convert::Note& note) {
  return note.outcome == convert::Outcome::kLost && note.count > 1 &&
         std::ranges::find(kWithoutElements, note.kind) == std::end(kWithoutElements);
}

/// Of what MJCF says and the target has no word for: the element, and its attribute, wherever they stand.
std::string mjcf_cause(const convert::Note& note) {
  const std::string& written = note.written;
  switch (note.kind) {
    // A shape or a body by its kind and name.
    case convert::NoteKind::kFromMjcfWorld:
    case convert::NoteKind::kFromMjcfLeftOut: return written.substr(0, written.find(' '));
    default: break;
  }
  const bool path = note.kind >= convert::NoteKind::kFromMjcfBodies &&
                    note.kind <= convert::NoteKind::kFromMjcfOther;
  if (!path || note.outcome != convert::Outcome::kLost || !note.instead.empty()) return {};
  const bool attribute = written.find("/@") != std::string::npos;
  return attribute ? written : written.substr(written.rfind('/') + 1);
}

/// What several notes have in common: the package or folder that forty meshes are in, the rule that libsdformat
/// rejects twelve inertias by, that SDF has no transmissions. Empty where the message says it.
std::string cause_of(const convert::Note& note) {
  switch (note.kind) {
    case convert::NoteKind::kUriNotFound:
    case convert::NoteKind::kUriElsewhere: {
      const std::size_t scheme = note.written.find("://");
      // A folder that is missing, or meant from elsewhere.
      if (scheme == std::string::npos || note.written.starts_with("file")) {
        return note.written.substr(0, note.written.rfind('/') + 1);
      }
      return note.written.substr(0, note.written.find('/', scheme + 3));
    }
    case convert::NoteKind::kRefusedSdf: return note.instead;
    case convert::NoteKind::kInertiaNearest: return "nearest";
    // SDF has no such thing, whatever their names.
    case convert::NoteKind::kTransmission:
    case convert::NoteKind::kRos2Control: return note.instead.empty() ? "lost" : "";
    default: return mjcf_cause(note);
  }
}

/// Where the first sentence of the rule's page is about other shapes; else empty.
std::string help_for(const convert::Note& note, const model::Root& source) {
  const bool lost =
      note.kind == convert::NoteKind::kShapeLost || note.kind == convert::NoteKind::kCollisionLost;
  if (!lost || note.written != "mesh" || !note.instead.empty()) return {};
  // The meshes of MJCF may be in the model itself, or in formats of its own.
  return source.format == model::Format::kMjcf
             ? "write the result with -o: the mesh becomes a file beside it, where it can be read"
             : "name the mesh file in the source";
}

void check(const convert::Note& note, Context& context) {
  const bool lost = note.outcome == convert::Outcome::kLost;
  std::string message =
      fmt::format(fmt::runtime(row_of<convert::Note>(note, kTables).message.text(note)),
                  fmt::arg("written", note.written), fmt::arg("instead", note.instead),
                  fmt::arg("count", note.count),
                  fmt::arg("target", note.target.empty() ? "the target" : note.target),
                  fmt::arg("whereabouts", lost ? "is lost" : "is for Gazebo only"));
  if (lost_several(note)) message += fmt::format(" ({} elements and attributes)", note.count);
  context.report({.where = note.where,
                  .message = std::move(message),
                  .subject = note.subject,
                  .help = help_for(note, context.root()),
                  .cause = cause_of(note)});
}

}  // namespace conversion

std::vector<Rule> convert_rules() {
  return rules_of<convert::Note>(conversion::kTables, conversion::check);
}

}  // namespace rigor::rules
