// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// One text of a document, as everything above needs it: its elements as they are written, and the model that it
// makes. Each part is made when it is first asked for; the model costs what loading the file costs.
//
//   Analysis analysis(environment, "/robot/arm.urdf", text);
//   if (auto element = analysis.written().element_at(offset)) …
//   for (const model::Link& link : analysis.loaded().root.links) …

#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include <rigor/author/names/name_graph.h>
#include <rigor/model/frames.h>
#include <rigor/read/load.h>
#include <rigor/read/workspace.h>
#include <rigor/rules/environment.h>
#include <rigor/text/sources.h>
#include <rigor/xml/document.h>

namespace rigor::lsp {

class Analysis {
 public:
  /// The environment outlives it.
  Analysis(const Environment& environment, std::string path, std::string text);
  Analysis(const Analysis&) = delete;
  Analysis& operator=(const Analysis&) = delete;

  const Environment& environment() const { return environment_; }
  const std::string& path() const { return path_; }
  std::string_view text() const { return written_.bytes(); }

  /// The document as its author wrote it, a template unexpanded.
  const xml::Document& written() const { return written_; }

  bool is_template() const;
  /// The document that readers get: of a template what it expands to.
  const read::File& file();
  const read::Loaded& loaded();
  const model::Frames& frames();
  /// Names in the document, and in the files that it leads to.
  author::NameGraph& names();
  Sources& sources() { return sources_; }

  /// Where a span of a loaded model is written, when that is in this document; else nowhere. Offsets are those
  /// of `text()`.
  Span written_span(Span span);

 private:
  const Environment& environment_;
  std::string path_;
  Sources sources_;
  xml::Document written_;
  read::Workspace workspace_;
  const read::File* file_ = nullptr;
  std::optional<read::Loaded> loaded_;
  std::optional<model::Frames> frames_;
  std::optional<author::NameGraph> names_;
};

}  // namespace rigor::lsp
