// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/lsp/document/analysis.h>

#include <utility>

#include <rigor/read/template/template_expander.h>
#include <rigor/text/path.h>

namespace rigor::lsp {
namespace {

xml::Document parsed_into(Sources& sources, const std::string& path, std::string text) {
  const SourceId source = sources.add(path, std::move(text));
  return xml::parse_own(sources.bytes(source), source);
}

}  // namespace

Analysis::Analysis(const Environment& environment, std::string path, std::string text)
    : environment_(environment),
      path_(std::move(path)),
      written_(parsed_into(sources_, path_, std::move(text))),
      workspace_(environment.resolver, sources_) {}

bool Analysis::is_template() const { return read::is_template(path_); }

const read::File& Analysis::file() {
  if (file_ == nullptr) file_ = &workspace_.put(path_, std::string(text()));
  return *file_;
}

const read::Loaded& Analysis::loaded() {
  if (!loaded_) {
    const read::Reader reader{workspace_, environment_.resolver, environment_.sdf,
                              environment_.urdf};
    loaded_.emplace(read::load(reader, file()));
  }
  return *loaded_;
}

const model::Frames& Analysis::frames() {
  if (!frames_) frames_.emplace(loaded().root);
  return *frames_;
}

author::NameGraph& Analysis::names() {
  file();  // the editor's text before the disk's
  if (!names_) names_.emplace(workspace_, environment_.resolver);
  return *names_;
}

Span Analysis::written_span(Span span) {
  if (span.nowhere()) return {};
  const read::File& file = this->file();
  if (span.source != file.source && !file.expanded) return {};
  if (file.expanded) {
    span = file.expanded->origin(*file.document, span, sources_).where;
    if (span.nowhere() || normalize_path(sources_.path(span.source)) != normalize_path(path_))
      return {};
  }
  return {written_.source(), span.begin, span.end};
}

}  // namespace rigor::lsp
