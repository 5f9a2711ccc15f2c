// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a caller, the helper of its `ForkServer` and a child say to each other. For the files of this folder.
//
// There are three ways of talk. Over the helper's socket go wishes for a child: its limits, and the child's
// ends of the two others. Over a socket of its own go messages to the child and from it. Over a pipe of
// its own the helper tells how the child ended.

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <rigor/process/child.h>
#include <rigor/process/descriptor.h>

namespace rigor::process {

enum class MessageKind : std::uint64_t { kRequest, kQuestion, kAnswer, kNoAnswer, kResult };

struct Message {
  MessageKind kind = MessageKind::kRequest;
  std::uint64_t size = 0;  ///< bytes that follow
  std::uint64_t end = 0;   ///< of a result: a ChildResult::End
};

struct ChildEnd {
  int signal = 0;  ///< that killed it
  int error = 0;   ///< why there was no child
};

/// False when nobody listens any more.
bool send_message(int socket, MessageKind kind, std::string_view bytes, std::uint64_t end = 0);

/// False when the end comes before `size` bytes.
bool receive_all(int socket, void* into, std::size_t size);

/// The same. Room is made as bytes come: the size that was announced may be a lie.
bool receive_text(int socket, std::uint64_t size, std::string& text);

/// What the caller wants of the helper.
struct Wish {
  ChildLimits limits;
  Descriptor socket{-1};  ///< for the child
  Descriptor pipe{-1};    ///< for the helper: a ChildEnd
};

/// False when nobody listens any more.
bool send_wish(int socket, const Wish& wish);

/// Nothing when there will be no more.
std::optional<Wish> receive_wish(int socket);

}  // namespace rigor::process
