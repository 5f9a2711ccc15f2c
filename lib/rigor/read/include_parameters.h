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
// each child has its own. What does not exist is left out, as there.

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <rigor/xml/document.h>

namespace rigor::read {

/// Further ones are left out: each one reads the file anew, and people write a handful.
inline constexpr std::size_t kMaxIncludeParameters = 64;

struct IncludeChanges {
  /// Of the included file with the parameters done; nothing where there are none, or none does anything.
  std::optional<std::string> bytes;
  /// Parameters, and parts of them, that lead nowhere.
  std::vector<xml::Element> ignored;
};

/// `source` is the file that `include` is in.
IncludeChanges with_include_parameters(const xml::Document& included, const xml::Document& source,
                                       xml::Element include);

}  // namespace rigor::read
