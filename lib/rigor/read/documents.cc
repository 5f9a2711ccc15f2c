// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/documents.h>

namespace rigor::read {

Documents::Documents(const Workspace& workspace) {
  for (const File* file : workspace.files()) {
    if (file->document) by_source_.emplace(file->source, &*file->document);
  }
}

}  // namespace rigor::read
