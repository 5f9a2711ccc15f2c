// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Which engine steps the simulations, for `rigor --version`.
//
//   say("ODE " + simulate::ode_version());

#pragma once

#include <string>

namespace rigor::simulate {

/// "0.16.2"; empty in a build without ODE, which simulates nothing.
std::string ode_version();

}  // namespace rigor::simulate
