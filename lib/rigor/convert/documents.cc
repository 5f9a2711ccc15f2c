// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/documents.h>

namespace rigor::convert {

Documents::Documents(const read::Workspace& workspace) {
  for (const read::File* file : workspace.files()) {
    if (file->document) by_source_.emplace(file->source, &*file->document);
  }
}

}  // namespace rigor::convert
