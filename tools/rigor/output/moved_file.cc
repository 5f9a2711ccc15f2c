// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "output/moved_file.h"

#include <rigor/author/verbs/moved_paths.h>
#include <rigor/process/absolute_path.h>

#include "output/atomic_file.h"

namespace rigor::tool {
void write_moved(const std::string& out, const std::string& path, const std::string& text) {
  replace_file(out,
               author::moved_text(text, process::absolute_path(path), process::absolute_path(out)));
}

}  // namespace rigor::tool
