// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a worker and its caller say to each other over the worker's socket. For the files of this folder.
//
//   worker            caller
//   kHello, version →
//                   ← kRequest, RequestHead and the kind; kBytes, those of the request
//   kQuestion       →
//                   ← kAnswer or kNoAnswer
//   kResult         →
//                   ← kRequest ...
//
// Both are of one build, so messages are structs as they lie in memory, each followed by its bytes.

#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include <rigor/process/request.h>

namespace rigor::process {

enum class MessageKind : std::uint64_t {
  kHello,
  kRequest,
  kBytes,
  kQuestion,
  kAnswer,
  kNoAnswer,
  kResult
};

struct Message {
  MessageKind kind = MessageKind::kHello;
  std::uint64_t size = 0;  ///< bytes that follow
  // Of a result:
  std::uint32_t end = 0;      ///< a RequestResult::End
  std::uint32_t retires = 0;  ///< 1 when the worker is not to be asked again
};

/// Followed by the name of the kind.
struct RequestHead {
  std::uint64_t memory_bytes = 0;
  std::uint64_t cpu_seconds = 0;
};

/// Longer first messages, and names of kinds, are of no worker.
inline constexpr std::size_t kMaxName = 1024;

/// What the worker says first: the version that both must be of.
std::string_view worker_version();

/// In the worker, over `socket`. False when nobody listens any more.
bool send_message(int socket, const Message& message, std::string_view bytes);

/// In the worker: exactly `size` bytes; false when the end comes before.
bool receive_all(int socket, void* into, std::size_t size);

}  // namespace rigor::process
