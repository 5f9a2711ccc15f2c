// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/simulate/engine/ode/ode_version.h>

#include <ode/version.h>

namespace rigor::simulate {

std::string ode_version() { return dODE_VERSION; }

}  // namespace rigor::simulate
