// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The result of a check for programs. Its shape is fixed; keys are only ever added.

#pragma once

#include <string>

#include <rigor/rules/validate.h>
#include <rigor/text/sources.h>

namespace rigor::report {

/// Two spaces of indentation, keys in a fixed order, a line break at the end. Bytes of a message
/// that are not UTF-8 become U+FFFD, because JSON cannot hold them.
std::string json(const rules::ValidateResult& result, const Sources& sources);

}  // namespace rigor::report
