// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/results/writer.h>

namespace rigor::results {

bool names_database(const std::string& path) {
  return path.ends_with(".sqlite") || path.ends_with(".db");
}

}  // namespace rigor::results
