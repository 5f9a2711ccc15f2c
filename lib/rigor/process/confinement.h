// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a worker does to itself: it drops its parent's signal handlers, and lowers its own limits, first as it
// starts and then for each request. For the files of this folder.
//
//   reset_signals();
//   const std::uint64_t baseline = address_space_in_use();
//   confine({.cpu_seconds = 20, .memory_bytes = kImportBytes});

#pragma once

#include <cstdint>
#include <string_view>

#include <rigor/process/request.h>

namespace rigor::process {

/// Where the system does not tell how much address space is in use (no /proc), it is taken to be this
/// much: a worker that had read a scene with assimp had 36 MiB.
inline constexpr std::uint64_t kAssumedAddressSpace = std::uint64_t{64} << 20U;

/// Bytes, from the text of /proc/self/statm (man 5 proc: the first number, in pages); `kAssumedAddressSpace`
/// when the text has no number.
std::uint64_t address_space_in(std::string_view statm);
std::uint64_t address_space_in_use();

/// Bytes that are in memory; 0 where the system does not tell.
std::uint64_t resident_in_use();

/// All to their defaults, none blocked: a crash must be a crash.
void reset_signals();

/// Sets the limits from now on, on top of the time and memory that are used by now; the next request has its
/// own. Past the CPU time SIGPROF ends the process. The wall clock is the caller's.
void confine(const RequestLimits& limits);

}  // namespace rigor::process
