// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Texts and URIs as SARIF takes them, whatever a checked file wrote into them.

#pragma once

#include <string>
#include <string_view>

#include <rigor/text/diagnostic.h>

namespace rigor::report {

/// A path as a URI: RFC 3986's unreserved characters and the slashes stay.
std::string percent_encoded(std::string_view path);

/// What is said of a finding: the message as the first sentence, which is all that a list shows, then the
/// related places, as links to their number from 1 (GitHub shows no others), and what to do.
std::string sarif_message(const Diagnostic& diagnostic);

}  // namespace rigor::report
