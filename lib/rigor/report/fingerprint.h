// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What tells a service that a finding is the one it received before, although lines were added above.
//
//   const std::vector<std::string> ids = finding_ids(validation);  // as many as there are findings
//   line_hashes(bytes, {12}).at(12);  // "271789c17abda88f:1"

#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/report/validation.h>

namespace rigor::report {

/// For each finding 32 hexadecimal digits, no two the same, from its rule, its file, the entity it is
/// about and its message without the numbers. Equal ones are distinguished by their order in the file.
std::vector<std::string> finding_ids(const Validation& validation);

/// GitHub's hash of lines, by number from 1: a polynomial in 37, modulo 2^64, over the 100 UTF-16 units from
/// the line's begin on that are no blanks, any line ending being one LF; 0xFFFF represents the end of the
/// text, zeros for what is behind it. In hexadecimal, a colon, and how many lines so far had that hash. As
/// in `src/fingerprints.ts` of github/codeql-action, which warns of any other.
std::map<std::uint32_t, std::string> line_hashes(std::string_view bytes,
                                                 const std::set<std::uint32_t>& lines);

}  // namespace rigor::report
