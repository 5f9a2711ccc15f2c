// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// All bytes to an open file, a pipe or a socket, which take some at a time.
//
//   if (const int error = write_all(descriptor, bytes)) refuse(std::generic_category().message(error));

#pragma once

#include <string_view>

namespace rigor {

/// Zero, or the error's number (errno). A signal is no error: it goes on.
int write_all(int descriptor, std::string_view bytes);

}  // namespace rigor
