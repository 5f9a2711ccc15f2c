// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// SDF in a `<gazebo>` block that is written as URDF is, `<max_contacts value="3"/>`. libsdformat reads
// `value` of its own keys only: what it copies keeps the attribute, which SDF does not have, and without a
// text the element has its default value. Private to the room.
//
//   const IgnoredValues ignored = ignored_values(sensor, "link", {9});
//   ignored.lose(ledger, "r/link camera");
//   ignored.leave_out(document, changes);
//   block.xml += laid_out(document, sensor, changes);

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <rigor/convert/ledger.h>
#include <rigor/convert/xml_layout.h>
#include <rigor/schema/version.h>
#include <rigor/xml/document.h>

namespace rigor::convert {

struct IgnoredValues {
  std::vector<xml::Element> elements;      ///< the outermost that hold nothing else
  std::vector<xml::Attribute> attributes;  ///< of elements that stay
  std::vector<xml::Element> owners;        ///< of all that are ignored, in the order of the file

  bool has(xml::Element element) const;
  bool has(xml::Attribute attribute) const;

  /// Takes them in the account as lost, with a note on each.
  void lose(Ledger& ledger, const std::string& subject) const;
  /// So that the result is without them.
  void leave_out(const xml::Document& document, LayoutChanges& changes) const;
};

/// Of an element that SDF has in a `parent`: "link", "joint" or "model". None in plugins and in elements
/// that SDF does not have: these are copied, and their readers are not known.
IgnoredValues ignored_values(xml::Element element, std::string_view parent,
                             schema::Version version);

}  // namespace rigor::convert
