// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/process/messages.h>

#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

namespace rigor::process {
namespace {

/// False when nobody listens any more.
bool send_all(int socket, const void* data, std::size_t size) {
  const char* bytes = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t sent = ::send(socket, bytes, size, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0) return false;
    bytes += sent;
    size -= static_cast<std::size_t>(sent);
  }
  return true;
}

using WishEnds = std::array<int, 2>;
using WishSpace = std::array<char, CMSG_SPACE(sizeof(WishEnds))>;

/// A message with room for the descriptors that go with it.
struct WishMessage {
  explicit WishMessage(ChildLimits& limits) : bytes{&limits, sizeof limits} {
    header.msg_iov = &bytes;
    header.msg_iovlen = 1;
    header.msg_control = space.data();
    header.msg_controllen = space.size();
  }

  iovec bytes;
  alignas(cmsghdr) WishSpace space = {};
  msghdr header = {};
};

}  // namespace

bool send_message(int socket, MessageKind kind, std::string_view bytes, std::uint64_t end) {
  const Message message{kind, bytes.size(), end};
  return send_all(socket, &message, sizeof message) && send_all(socket, bytes.data(), bytes.size());
}

bool receive_all(int socket, void* into, std::size_t size) {
  char* bytes = static_cast<char*>(into);
  while (size > 0) {
    const ssize_t got = ::read(socket, bytes, size);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    bytes += got;
    size -= static_cast<std::size_t>(got);
  }
  return true;
}

bool receive_text(int socket, std::uint64_t size, std::string& text) {
  constexpr std::uint64_t kFirst = std::uint64_t{1} << 20U;
  while (text.size() < size) {
    const std::size_t known = text.size();
    text.resize(std::min(size, std::max<std::uint64_t>(kFirst, 2 * known)));
    if (!receive_all(socket, text.data() + known, text.size() - known)) return false;
  }
  return true;
}

bool send_wish(int socket, const Wish& wish) {
  ChildLimits limits = wish.limits;
  const WishEnds ends = {wish.socket.number(), wish.pipe.number()};
  WishMessage message(limits);
  cmsghdr* with = CMSG_FIRSTHDR(&message.header);
  with->cmsg_level = SOL_SOCKET;
  with->cmsg_type = SCM_RIGHTS;
  with->cmsg_len = CMSG_LEN(sizeof ends);
  std::memcpy(CMSG_DATA(with), ends.data(), sizeof ends);
  ssize_t sent = -1;
  do {
    sent = ::sendmsg(socket, &message.header, MSG_NOSIGNAL);
  } while (sent < 0 && errno == EINTR);
  return sent >= 0;
}

std::optional<Wish> receive_wish(int socket) {
  Wish wish;
  WishMessage message(wish.limits);
  ssize_t got = -1;
  do {
    got = ::recvmsg(socket, &message.header, MSG_CMSG_CLOEXEC);
  } while (got < 0 && errno == EINTR);
  const cmsghdr* with = CMSG_FIRSTHDR(&message.header);
  WishEnds ends = {};
  if (got != sizeof wish.limits || with == nullptr || with->cmsg_len != CMSG_LEN(sizeof ends)) {
    return std::nullopt;
  }
  std::memcpy(ends.data(), CMSG_DATA(with), sizeof ends);
  wish.socket = Descriptor(ends[0]);
  wish.pipe = Descriptor(ends[1]);
  return wish;
}

}  // namespace rigor::process
