// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A connection's bytes for cpp-httplib. Its own stream (0.11.4) sends nothing to a client that has ended its side
// of the connection behind the request, as `nc -N` and HTTP/1.0 clients do: that client still reads.
//
//   SocketStream stream(socket);
//   server.process_request(stream, …);

#pragma once

#include <array>
#include <cstddef>
#include <string>

#include <httplib.h>

namespace rigor::tool {

/// Does not own the socket. A read or write that waits longer than some seconds fails; so does what follows the
/// first 16 KiB of a request.
class SocketStream final : public httplib::Stream {
 public:
  explicit SocketStream(socket_t socket) : socket_(socket) {}

  bool is_readable() const override;
  bool is_writable() const override;
  ssize_t read(char* into, std::size_t size) override;
  ssize_t write(const char* bytes, std::size_t size) override;
  void get_remote_ip_and_port(std::string& ip, int& port) const override;
  void get_local_ip_and_port(std::string& ip, int& port) const override;
  socket_t socket() const override { return socket_; }

 private:
  socket_t socket_;
  std::array<char, 4096> buffer_;
  std::size_t begin_ = 0;  // of what the buffer holds
  std::size_t end_ = 0;
  std::size_t received_ = 0;
};

}  // namespace rigor::tool
