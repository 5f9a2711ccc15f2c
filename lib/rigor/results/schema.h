// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The tables of a database of results. docs/results-database.md is their manual, and a test holds the two together.

#pragma once

#include <cstdint>
#include <string_view>

namespace rigor::results {

/// In the file's header, so that a program knows what it has before it reads: "rigo".
inline constexpr std::int32_t kApplicationId = 0x7269676F;

/// `PRAGMA user_version`; grows when a query for the last one would give something else.
inline constexpr std::int32_t kSchemaVersion = 1;

/// Created empty, before anything is written.
std::string_view tables();

/// Created at the end: rows are written in half the time without them.
std::string_view indexes();

}  // namespace rigor::results
