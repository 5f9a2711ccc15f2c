// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/environment.h>
#include <rigor/rules/validate.h>

int main(int argc, char** argv) {
  const rigor::RealDisk disk;
  rigor::Sources sources;
  return static_cast<int>(rigor::rules::validate(rigor::Environment(disk, {}, RIGOR_WORKER),
                                                 {.paths = {argv + 1, argv + argc}}, sources)
                              .diagnostics.count(rigor::Severity::kError));
}
