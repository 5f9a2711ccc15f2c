// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// How much a file brings when it is included, known before it is read: twenty files that each include
// the next one four times mean 4^20 links, and counting them takes twenty steps. Private to the room.

#pragma once

#include <cstddef>

#include <rigor/read/load.h>

namespace rigor::read {

/// The parts of a file (models, links, joints…, and includes) and of all that it includes; of more
/// than kMaxIncludedParts, at least one more. Counted once a run. In a circle of includes the way
/// back counts nothing.
std::size_t parts_with_includes(const Reader& reader, const File& file);

}  // namespace rigor::read
