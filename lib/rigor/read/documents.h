// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The documents that a model was read from: its own file and those that it includes. A model's structs
// hold what rigor understands; a conversion also carries what it does not, and that is only here.
//
//   Documents documents(workspace);
//   xml::Element element = documents.element(link.site);

#pragma once

#include <map>

#include <rigor/model/site.h>
#include <rigor/read/workspace.h>
#include <rigor/xml/document.h>

namespace rigor::read {

class Documents {
 public:
  /// Of all files that were opened so far. The workspace outlives this.
  explicit Documents(const Workspace& workspace);

  const xml::Document& of(SourceId source) const { return *by_source_.at(source); }
  bool hold(SourceId source) const { return by_source_.contains(source); }
  xml::Element element(const model::Site& site) const {
    return of(site.span.source).element(site.element);
  }

 private:
  std::map<SourceId, const xml::Document*> by_source_;
};

}  // namespace rigor::read
