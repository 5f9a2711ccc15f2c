// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What the rules on a mesh file's faults share: which fault is reported, and its words.

#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include <rigor/mass/mesh/facts.h>
#include <rigor/mesh/fault.h>
#include <rigor/rules/mesh/gltf.h>
#include <rigor/rules/rule.h>

namespace rigor::rules {

/// The first fault of that kind, if it is to be reported: of a file that cannot be read, what else is odd
/// about it comes from the same cause, and of a glTF file that cause may have a rule of its own.
inline const mesh::Fault* fault_of(const MeshFile& file, mesh::FaultKind kind) {
  if (!mesh::fatal(kind) && !file.facts.usable()) return nullptr;
  if (mesh::fatal(kind) && gltf_explains(file)) return nullptr;
  const auto& faults = file.facts.faults;
  const auto found = std::find_if(faults.begin(), faults.end(),
                                  [kind](const mesh::Fault& fault) { return fault.kind == kind; });
  return found == faults.end() ? nullptr : &*found;
}

/// In words that hold no text of the file: of one that is out of reach nothing else is told.
inline void report_mesh(const MeshFile& file, Context& context, std::string message,
                        std::string why = {}) {
  context.report({.where = file.where(),
                  .message = std::move(message),
                  .measured = true,
                  .subject = file.subject(),
                  .why = std::move(why)});
}

/// In words that may quote the file.
inline void report_mesh_text(const MeshFile& file, Context& context, std::string message) {
  context.report(
      {.where = file.where(), .message = std::move(message), .subject = file.subject()});
}

/// "1 facet", "3 facets".
inline std::string how_many(std::uint64_t count, std::string_view one) {
  return std::to_string(count) + ' ' + std::string(one) + (count == 1 ? "" : "s");
}

/// " (line 12)"; nothing when the format has no lines.
inline std::string in_line(std::uint64_t line) {
  return line == 0 ? "" : " (line " + std::to_string(line) + ')';
}

}  // namespace rigor::rules
