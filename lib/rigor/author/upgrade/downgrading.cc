// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/upgrade/downgrading.h>

#include <cstddef>

#include <rigor/model/subject.h>

namespace rigor::author {

void Downgrading::lose(Span where, std::string message) {
  const bool allowed = losses == VersionLosses::kAllowed;
  if (!allowed) message += ": --allow-loss leaves it out";
  notes.add({UpgradeNoteKind::kLost, allowed ? Severity::kWarning : Severity::kError, where,
             std::move(message)});
}

std::string Downgrading::name_in(model::Id<model::Model> model, model::Id<model::Link> link) const {
  const std::string whole = scoped_name(root, link);
  const std::size_t prefix = scoped_name(root, model).size() + 2;
  return whole.size() > prefix ? whole.substr(prefix) : whole;
}

}  // namespace rigor::author
