// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/xml/engine.h>

#include <tinyxml2.h>

namespace rigor::xml {

std::string tinyxml2_version() {
  return std::to_string(TIXML2_MAJOR_VERSION) + '.' + std::to_string(TIXML2_MINOR_VERSION) + '.' +
         std::to_string(TIXML2_PATCH_VERSION);
}

}  // namespace rigor::xml
