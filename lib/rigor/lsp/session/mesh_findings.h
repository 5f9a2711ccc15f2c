// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a document's meshes showed when they were last opened, kept while somebody types: a finding moves with its
// line, and goes when anything of its link is changed.

#pragma once

#include <map>
#include <string>
#include <vector>

#include <rigor/lsp/document/moving_place.h>
#include <rigor/lsp/project/background_check.h>
#include <rigor/lsp/session/state.h>

namespace rigor::lsp {

class MeshFindings {
 public:
  MeshFindings() = default;
  /// Of a check of the text that the document has now.
  MeshFindings(const State& state, OpenDocument& document, const BackgroundCheck& check);

  /// The document was changed.
  void follow(const TextChange& change);
  /// Another document was changed: what is shown in it goes.
  void forget(const std::string& uri) { elsewhere_.erase(uri); }

  /// Adds them as diagnostics, by the URI that each is shown at.
  void add_to(std::map<std::string, std::vector<Json>>& by_uri, const OpenDocument& document) const;

 private:
  struct Own {
    MovingPlace place;
    Json diagnostic;  // as it was found
    bool moved = false;
  };
  std::vector<Own> own_;  // in the document itself
  std::map<std::string, std::vector<Json>> elsewhere_;
};

}  // namespace rigor::lsp
