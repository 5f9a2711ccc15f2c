// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The program of a worker: it serves one request after another until its caller is gone.
//
//   int main() {
//     return process::serve({{mesh::kImportScene, mesh::serve_import},
//                            {simulate::kRunScene, simulate::serve_run}});
//   }
//
// Each service runs under the limits of its request, which are set before the request's bytes are read. It
// may crash, run away or leak: that ends this process, and is the result of that request alone. What it
// prints goes nowhere.

#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/process/request.h>

namespace rigor::process {

struct Reply {
  /// Whether this process may serve again: not when a library was left in a state that it does not come
  /// back from.
  enum class Then : std::uint8_t { kServeAgain, kRetire };

  Reply(std::string its_bytes, Then what_then = Then::kServeAgain)
      : bytes(std::move(its_bytes)), then(what_then) {}

  std::string bytes;
  Then then;
};

/// What it throws is the request's failure; std::bad_alloc, that it had too little memory. A worker whose
/// service threw retires.
using Handler = std::function<Reply(const std::string& bytes, const Ask& ask)>;

struct Service {
  std::string_view kind;
  Handler handle;
};

/// A worker that has more than this in memory when a request is done retires, so that it does not hoard what
/// one large file took.
inline constexpr std::uint64_t kMaxKept = std::uint64_t{256} << 20U;

/// The exit code: 0 when the caller is gone, 1 when there is none that speaks as a caller does.
int serve(const std::vector<Service>& services);

}  // namespace rigor::process
