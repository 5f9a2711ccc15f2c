// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Workers that the tests of a program share, so that not each starts its own.

#pragma once

#include <rigor/process/workers.h>

namespace rigor::test {

inline const process::Workers& workers() {
  static const process::Workers kWorkers;
  return kWorkers;
}

}  // namespace rigor::test
