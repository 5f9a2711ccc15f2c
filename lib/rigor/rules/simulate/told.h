// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What the rules on simulations share: a fact as a finding.

#pragma once

#include <string>
#include <utility>

#include <rigor/rules/context.h>
#include <rigor/simulate/fact.h>

namespace rigor::rules {

/// Degrees in a radian: angles are told as people speak of them.
inline constexpr double kDegrees = 57.29577951308232;

/// Of the joint that the fact is about.
inline const char* position_unit(const simulate::Fact& fact) { return fact.slides ? "m" : "rad"; }

/// What is so in the model, whatever a test shows.
inline Finding stated(const simulate::Fact& fact, std::string message, std::string help = {}) {
  return {.where = fact.where,
          .message = std::move(message),
          .subject = fact.subject,
          .help = std::move(help)};
}

/// The finding, with the test that showed it.
inline Finding shown(const simulate::Fact& fact, std::string message) {
  if (!fact.test.empty()) message.append(", in the test ").append(fact.test);
  return stated(fact, std::move(message));
}

}  // namespace rigor::rules
