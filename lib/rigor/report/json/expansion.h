// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What an expansion of a template is made of, for programs.

#pragma once

#include <string>

#include <rigor/text/sources.h>
#include <rigor/xacro/expand.h>

namespace rigor::report {

/// All of it, as JSON: files, frames, and elements in document order with the places of their attributes.
std::string expansion_json(const xacro::Expansion& expansion, const Sources& sources);

}  // namespace rigor::report
