// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Judging as another checker does. Under `Compat::kSdformat` a finding is an error when libsdformat 12
// (`ign sdf -k`) refuses the file for it, and at most a warning when it takes it.
//
//   Selection selection{.compat = Compat::kSdformat};
//   Rule rule() { return {…, .refused = {.sdf = Refusal::kAlways, .urdf = Refusal::kSays}, …}; }
//   context.report({…, .refused = !sdformat_takes(mass, tensor)});
//
// What it refuses is known from running it: testdata/compat has its verdict on every rule's bad examples.

#pragma once

#include <cstdint>

namespace rigor::rules {

enum class Compat : std::uint8_t { kNone, kSdformat };

/// Whether libsdformat refuses a file for what a rule finds in it.
enum class Refusal : std::uint8_t {
  kNever,
  kAlways,
  kSays,  ///< of some findings: `Finding::refused`
};

struct Refusals {
  Refusal sdf = Refusal::kNever;
  Refusal urdf = Refusal::kNever;

  bool operator==(const Refusals&) const = default;
};

}  // namespace rigor::rules
