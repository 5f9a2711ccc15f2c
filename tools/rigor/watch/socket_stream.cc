// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "watch/socket_stream.h"

#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>

namespace rigor::tool {
namespace {

/// Requests of browsers have some hundred bytes.
constexpr std::size_t kMaxRequestBytes = 16384;
/// On this machine an answer is a matter of milliseconds; who stays silent longer holds a thread.
constexpr int kPatienceMs = 5000;

bool waits_for(socket_t socket, short events) {
  pollfd polled{socket, events, 0};
  while (true) {
    const int count = ::poll(&polled, 1, kPatienceMs);
    if (count < 0 && errno == EINTR) continue;
    return count > 0 && (polled.revents & (POLLERR | POLLNVAL)) == 0;
  }
}

}  // namespace

bool SocketStream::is_readable() const { return waits_for(socket_, POLLIN); }

bool SocketStream::is_writable() const { return waits_for(socket_, POLLOUT); }

ssize_t SocketStream::read(char* into, std::size_t size) {
  while (begin_ == end_) {
    if (received_ >= kMaxRequestBytes || !is_readable()) return -1;
    const ssize_t count = ::recv(socket_, buffer_.data(), buffer_.size(), 0);
    if (count < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (count <= 0) return count;
    begin_ = 0;
    end_ = static_cast<std::size_t>(count);
    received_ += end_;
  }
  const std::size_t taken = std::min(size, end_ - begin_);
  std::copy_n(buffer_.data() + begin_, taken, into);
  begin_ += taken;
  return static_cast<ssize_t>(taken);
}

ssize_t SocketStream::write(const char* bytes, std::size_t size) {
  while (true) {
    if (!is_writable()) return -1;
    const ssize_t count = ::send(socket_, bytes, size, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (count >= 0 || (errno != EINTR && errno != EAGAIN)) return count;
  }
}

// Nobody asks: the server listens to this machine only.
void SocketStream::get_remote_ip_and_port(std::string& ip, int& port) const {
  ip = "127.0.0.1";
  port = 0;
}

void SocketStream::get_local_ip_and_port(std::string& ip, int& port) const {
  get_remote_ip_and_port(ip, port);
}

}  // namespace rigor::tool
