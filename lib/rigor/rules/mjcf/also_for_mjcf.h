// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Which rules on any format hold for MJCF, too. Most speak of what SDF and URDF say, or of readers that
// never see an MJCF file.

#pragma once

#include <string_view>

#include <rigor/rules/page_in_brief.h>
#include <rigor/rules/rule.h>

namespace rigor::rules {

bool holds_for_mjcf(const Rule& rule);

/// Of the rule's page what it says of MuJoCo, or of no consumer in particular; else nothing.
PageInBrief brief_for_mjcf(const PageProse& prose);

}  // namespace rigor::rules
