// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Findings as JSON, the same in the result of every command.

#pragma once

#include <rigor/report/json/values.h>
#include <rigor/report/places.h>
#include <rigor/text/diagnostic.h>
#include <rigor/text/sources.h>

namespace rigor::report {

Json diagnostic_json(const Diagnostic& diagnostic, Places& places);
Json diagnostics_of(const Diagnostics& diagnostics, const Sources& sources);

}  // namespace rigor::report
