// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Whether an MJCF text is the robot that it was made from: it is read again and moved through random joint
// positions beside the source (robot/compare.h).

#pragma once

#include <string>

#include <rigor/convert/note.h>
#include <rigor/convert/to_mjcf.h>
#include <rigor/text/span.h>

namespace rigor::author {

/// What is not the same though no note of the account tells it; `where` is the source's root.
convert::Notes prove_mjcf(const convert::MjcfConversion& result, const std::string& text,
                          Span where);

}  // namespace rigor::author
