// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What is compiled in place of the tracer without Embree (RIGOR_WITH_EMBREE=OFF).

#include <rigor/view/trace.h>

namespace rigor::view {

Traced trace(const Drawing&, const Camera&, const TraceOptions&) {
  return {.picture = {}, .problem = "rigor was built without Embree"};
}

std::string tracer() { return {}; }

}  // namespace rigor::view
