// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/process/messages.h>

#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>

namespace rigor::process {
namespace {

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

}  // namespace

std::string_view worker_version() { return "rigor-worker " RIGOR_VERSION; }

bool send_message(int socket, const Message& message, std::string_view bytes) {
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

}  // namespace rigor::process
