// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a fault says of the others of its kind that were counted and not kept.

#pragma once

#include <cstdint>
#include <string>

#include <rigor/xml/fault.h>

namespace rigor::rules {

/// " (and 12 more in this file)"; empty when every one of them is reported.
inline std::string and_more(const xml::Fault& fault) {
  const std::uint32_t kept = xml::max_kept(fault.kind);
  if (fault.count <= kept) return {};
  return " (and " + std::to_string(fault.count - kept) + " more in this file)";
}

}  // namespace rigor::rules
