// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "output/moved_file.h"

#include <filesystem>

#include <rigor/author/verbs/moved_paths.h>

#include "output/atomic_file.h"

namespace rigor::tool {
void write_moved(const std::string& out, const std::string& path, const std::string& text) {
  const auto absolute = [](const std::string& name) {
    return std::filesystem::absolute(name).generic_string();
  };
  replace_file(out, author::moved_text(text, absolute(path), absolute(out)));
}

}  // namespace rigor::tool
