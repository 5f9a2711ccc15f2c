// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A value as a file gives it: what it is, where it stands, and whether anybody wrote it.
//
// `written` keeps "the file says 1" apart from "nothing was said, so it is 1". The value is what the
// author wrote (an axis not yet normalized, a pose relative to what the author chose); what follows
// from it is computed by `Frames` and by `mass`.
//
//   if (!joint.axes[0].upper.written) ...   // a default: nothing to point at
//   point_at(joint.axes[0].upper.span);

#pragma once

#include <rigor/text/span.h>

namespace rigor::model {

template <class T>
struct Field {
  T value{};
  Span span;  ///< of the value's own bytes; nowhere when it is a default
  bool written = false;
};

}  // namespace rigor::model
