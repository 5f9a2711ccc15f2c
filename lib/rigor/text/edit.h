// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Changes to a user's file, as replacements of byte ranges in the original.
//
// A model file is never written from a tree: what no edit names keeps its bytes. A fix is applied
// whole or not at all.
//
//   Fix fix{"swap the limits", Applicability::kUnsafe, {{lower, "-1"}, {upper, "1"}}};
//   std::optional<std::string> fixed = apply_edits(bytes, fix.edits);

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/text/span.h>

namespace rigor {

/// Replaces the bytes of `span` by `text`. An empty span inserts, an empty text removes.
struct Edit {
  Span span;
  std::string text;

  bool operator==(const Edit&) const = default;
};

enum class Applicability {
  kSafe,    ///< keeps what the model means: `--fix` applies it
  kUnsafe,  ///< changes mass, inertia, pose, limits or topology: only with `--unsafe-fixes`
  kManual,  ///< shown, never applied: somebody has to decide
};

std::string_view to_string(Applicability applicability);

struct Fix {
  std::string title;  ///< what it does, in the imperative: "swap lower and upper"
  Applicability applicability = Applicability::kManual;
  std::vector<Edit> edits;
};

void append(std::vector<Edit>& edits, std::vector<Edit> more);

/// The text with the edits done, or nothing when two of them overlap or one reaches past the end.
/// Two insertions at one place overlap, unless they are the same; then one is done.
std::optional<std::string> apply_edits(std::string_view bytes, std::vector<Edit> edits);

}  // namespace rigor
