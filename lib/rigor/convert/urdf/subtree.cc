// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/urdf/subtree.h>

#include <cstdint>
#include <string_view>

#include <rigor/read/documents.h>

namespace rigor::convert {
namespace {

/// Calls `f` with the element and all that stand in it, in the order of the file.
template <class F>
void each_below(const xml::Document& document, xml::Element element, const F& f) {
  const std::uint32_t end = element.span().end;
  for (std::uint32_t i = element.index(); i < document.element_count(); ++i) {
    const xml::Element one = document.element(i);
    if (one.span().begin >= end) break;
    f(one);
  }
}

}  // namespace

bool is_all_implied(const Source& source, const model::Site& opened, xml::Element element) {
  bool all = true;
  each_below(source.documents.of(opened.span.source), element, [&](xml::Element one) {
    all = all && (!one.children().empty() || is_implied(source, opened, one));
    for (const xml::Attribute attribute : one.attributes()) {
      all = all && is_implied(source, one, attribute);
    }
  });
  return all;
}

void LostChildren::add(xml::Element child) {
  if (is_all_implied(draft_.source, parent_, child)) return;
  if (!names_.empty()) names_ += ", ";
  names_ += child.name();
  count_ += draft_.ledger.take_all(child, Outcome::kLost);
}

void LostChildren::tell(NoteKind kind, const std::string& subject) {
  if (count_ == 0) return;
  draft_.ledger.note({.kind = kind,
                      .outcome = Outcome::kLost,
                      .where = parent_.name,
                      .subject = subject,
                      .written = names_,
                      .instead = {},
                      .count = count_});
}

}  // namespace rigor::convert
