// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What stands in an element, told as one loss. Private to the room.
//
//   LostChildren lost(draft, visual.material.site);
//   lost.add(*material.child("pbr"));
//   lost.tell(NoteKind::kMaterialLook, subject);

#pragma once

#include <cstddef>
#include <string>

#include <rigor/convert/urdf/draft.h>
#include <rigor/model/site.h>
#include <rigor/xml/document.h>

namespace rigor::convert {

/// Whether nothing in the element, itself included, says more than a default.
bool is_all_implied(const Source& source, const model::Site& opened, xml::Element element);

/// Children of one element that are lost together.
class LostChildren {
 public:
  LostChildren(UrdfDraft& draft, const model::Site& parent) : draft_(draft), parent_(parent) {}

  /// Unless it says no more than a default.
  void add(xml::Element child);
  /// One note on them all, at the parent's name, if there are any.
  void tell(NoteKind kind, const std::string& subject);

 private:
  UrdfDraft& draft_;
  const model::Site& parent_;
  std::string names_;
  std::size_t count_ = 0;
};

}  // namespace rigor::convert
