// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Which findings follow from another one: a tensor that no rigid body can have also has the wrong size, and
// only the tensor is reported.
//
//   Diagnostics left = without_consequences(std::move(found));

#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include <rigor/text/diagnostic.h>

namespace rigor::rules {

/// When a finding follows from another one in the same file.
enum class Link : std::uint8_t {
  kSubject,  ///< that is about the same entity, or a part of it
  kCause,    ///< that names the same cause: all that refer to a name that does not exist
};

/// Rules, their names with blanks between, whose findings hide those of others. A finding is never hidden
/// by one that is less severe.
struct Consequences {
  std::string_view roots;
  std::string_view rules;
  Link link = Link::kSubject;
};

/// The whole table; each rule in it exists.
std::span<const Consequences> consequences();

/// Of one file, in the same order. What is hidden itself hides others too.
Diagnostics without_consequences(Diagnostics found);

}  // namespace rigor::rules
