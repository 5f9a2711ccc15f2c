// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `<experimental:params>` of an `<include>`: what it adds to the included model, changes in it, or takes
// from it, as libsdformat 12 does (http://sdformat.org/tutorials?tut=param_passing_proposal).
//
//   <include>
//     <uri>model://arm</uri>
//     <experimental:params>
//       <visual element_id="hand" name="mark" action="add"><geometry>…</geometry></visual>
//       <link element_id="hand" action="modify"><inertial><mass>2</mass></inertial></link>
//       <collision element_id="hand::palm" action="remove"/>
//     </experimental:params>
//   </include>
//
// An `element_id` is a path of names below the model, of `add` that of the parent. Without an `action`
// each child has its own. What libsdformat skips with an error is skipped here, and the reason is told:
// `add` of a name that exists, a name of one letter at the start of an `element_id`, content that it
// cannot read, `modify` of an element that is not written.

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <rigor/read/parameter/parameter_fault.h>
#include <rigor/schema/schema.h>
#include <rigor/xml/document.h>

namespace rigor::read {

/// Further ones are left out, a child with an action of its own being one: each one reads the file anew, and
/// people write a handful.
inline constexpr std::size_t kMaxIncludeParameters = 64;

struct SkippedParameter {
  xml::Element element;  ///< the parameter, or the child of it that is skipped
  ParameterFault fault;
  std::string detail;
};

struct IncludeChanges {
  /// Of the included file with the parameters done; nothing where there are none, or none does anything.
  std::optional<std::string> bytes;
  /// Parameters, and parts of them, that are not done.
  std::vector<SkippedParameter> skipped;
};

/// `source` is the file that `include` is in; `sdf` the schema of SDFormat.
IncludeChanges with_include_parameters(const xml::Document& included, const xml::Document& source,
                                       xml::Element include, const schema::Schema& sdf);

}  // namespace rigor::read
