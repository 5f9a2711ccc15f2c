// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What visuals look like, for conversions: as they are drawn here.
//
//   mjcf_options.looks = looks_of(loaded.root, sources, files_of(resolver, sources, reads));

#pragma once

#include <rigor/robot/look.h>
#include <rigor/text/sources.h>
#include <rigor/view/drawing/drawing.h>

namespace rigor::view {

/// The root and its sources outlive the result.
robot::FindLooks looks_of(const model::Root& root, const Sources& sources, Files files);

}  // namespace rigor::view
