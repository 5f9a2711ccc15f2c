// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// An SDF file brought to an older version by edits, for a consumer that knows no newer one.
//
//   Upgrade result = downgrade(environment, loaded, schema::Version{6}, VersionLosses::kRefused);
//
// What the older version says otherwise is said otherwise: poses relative to frames become poses in the link or model,
// ends of joints that are frames become links, axes are in the joint's or the model's frame. What it has no word for
// stays where its consumers ignore it (frames, which meant something else up to 1.6, go) and is a note of the kind
// kLost. The result is read by its version and held against the file, number by number (proof.cc).

#pragma once

#include <cstdint>

#include <rigor/author/upgrade/upgrade.h>

namespace rigor::author {

enum class VersionLosses : std::uint8_t { kRefused, kAllowed };

/// The oldest version that can be asked for.
inline constexpr int kOldestDowngrade = 4;

/// Refused whatever is allowed: inertials that are computed from shapes and are not before 1.11, included models that are
/// merged (1.10) or placed by a frame (1.8), nested models (1.5), and what differs when it is read again.
Upgrade downgrade(const Environment& environment, const read::Loaded& loaded, schema::Version to,
                  VersionLosses losses);

}  // namespace rigor::author
