// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Letters whatever the locale: ASCII only.

#pragma once

namespace rigor::schema {

inline char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

}  // namespace rigor::schema
