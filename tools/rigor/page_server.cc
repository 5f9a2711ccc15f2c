// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "page_server.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstddef>
#include <iterator>
#include <system_error>
#include <utility>

#include "command.h"

namespace rigor::tool {
namespace {

/// Requests of browsers have some hundred bytes.
constexpr std::size_t kMostRequestBytes = 16384;
/// A browser opens six.
constexpr std::size_t kMostConnections = 100;

constexpr std::string_view kEventStream =
    "HTTP/1.1 200 OK\r\nContent-Type: text/event-stream\r\nCache-Control: no-store\r\n"
    "X-Content-Type-Options: nosniff\r\nConnection: close\r\n\r\n: here\n\n";

std::string response(std::string_view status, std::string_view type, std::string_view body) {
  std::string out = "HTTP/1.1 ";
  out += status;
  out += "\r\nContent-Type: ";
  out += type;
  out += "\r\nContent-Length: " + std::to_string(body.size());
  out +=
      "\r\nCache-Control: no-store\r\nX-Content-Type-Options: nosniff\r\nX-Frame-Options: DENY\r\n"
      "Cross-Origin-Resource-Policy: same-origin\r\nConnection: close\r\n\r\n";
  out += body;
  return out;
}

std::string refusal(std::string_view status) {
  return response(status, "text/plain; charset=utf-8", std::string(status) + '\n');
}

std::string lower(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

std::string_view without_spaces(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

/// The text up to a mark, which is taken off with it.
std::string_view take_to(std::string_view& text, std::string_view mark) {
  const std::size_t end = std::min(text.find(mark), text.size());
  const std::string_view taken = text.substr(0, end);
  text.remove_prefix(std::min(end + mark.size(), text.size()));
  return taken;
}

[[noreturn]] void refuse_port(std::uint16_t port, int error) {
  throw UsageError("--port " + std::to_string(port) + ": " +
                   std::generic_category().message(error));
}

}  // namespace

struct PageServer::Connection {
  process::Descriptor socket{-1};
  std::string received;
  std::string to_send;
  std::size_t sent = 0;
  bool answered = false;
  bool listens = false;  ///< for events: stays open
};

PageServer::PageServer(std::uint16_t port) {
  listener_ = process::Descriptor(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  wake_ = process::Descriptor(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK));
  if (listener_.number() < 0 || wake_.number() < 0) refuse_port(port, errno);
  // The port that was just served is free again, though its last connections may linger.
  const int yes = 1;
  ::setsockopt(listener_.number(), SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(port);
  socklen_t size = sizeof address;
  auto* generic = reinterpret_cast<sockaddr*>(&address);
  if (::bind(listener_.number(), generic, size) != 0 ||
      ::listen(listener_.number(), SOMAXCONN) != 0 ||
      ::getsockname(listener_.number(), generic, &size) != 0) {
    refuse_port(port, errno);
  }
  port_ = ntohs(address.sin_port);
}

PageServer::~PageServer() = default;

std::string PageServer::address() const {
  return "http://127.0.0.1:" + std::to_string(port_) + '/';
}

void PageServer::publish(Content content) {
  const std::lock_guard lock(mutex_);
  content_ = std::move(content);
  ++published_;
}

void PageServer::tell(std::string_view event, std::string_view data) {
  {
    const std::lock_guard lock(mutex_);
    last_told_ = "event: " + std::string(event) + "\ndata: " + std::string(data) + "\n\n";
    told_.push_back(last_told_);
  }
  const std::uint64_t one = 1;
  // It cannot be full: that would take as many events as there are numbers.
  [[maybe_unused]] const ssize_t written = ::write(wake_.number(), &one, sizeof one);
}

void PageServer::run() {
  std::vector<pollfd> polled;
  while (true) {
    polled = {{listener_.number(), POLLIN, 0}, {wake_.number(), POLLIN, 0}};
    for (const Connection& each : connections_) {
      const bool sends = each.sent < each.to_send.size();
      polled.push_back(
          {each.socket.number(), static_cast<short>(sends ? POLLIN | POLLOUT : POLLIN), 0});
    }
    if (::poll(polled.data(), polled.size(), -1) < 0) {
      if (errno == EINTR) continue;
      return;
    }
    std::size_t at = 2;
    for (auto each = connections_.begin(); each != connections_.end(); ++at) {
      const short events = polled[at].revents;
      bool open = (events & (POLLERR | POLLNVAL)) == 0;
      if (open && (events & (POLLIN | POLLHUP)) != 0) open = receive(*each);
      if (open) answer(*each);
      if (open) open = send(*each);
      each = open ? std::next(each) : connections_.erase(each);
    }
    if (polled[1].revents != 0) take_told();
    if (polled[0].revents != 0) accept_one();
  }
}

void PageServer::accept_one() {
  process::Descriptor socket(
      ::accept4(listener_.number(), nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK));
  if (socket.number() < 0 || connections_.size() >= kMostConnections) return;
  connections_.push_back({.socket = std::move(socket)});
}

void PageServer::take_told() {
  std::uint64_t ignored = 0;
  [[maybe_unused]] const ssize_t count = ::read(wake_.number(), &ignored, sizeof ignored);
  std::vector<std::string> told;
  {
    const std::lock_guard lock(mutex_);
    told.swap(told_);
  }
  for (Connection& each : connections_) {
    for (const std::string& event : told) {
      if (each.listens) each.to_send += event;
    }
  }
}

/// Whether the other side is still there.
bool PageServer::receive(Connection& connection) {
  std::array<char, 4096> bytes;
  while (true) {
    const ssize_t count = ::recv(connection.socket.number(), bytes.data(), bytes.size(), 0);
    if (count < 0) return errno == EAGAIN || errno == EINTR;
    if (count == 0) return false;
    // What comes behind a request that was answered is read for nothing.
    if (connection.answered) continue;
    connection.received.append(bytes.data(), static_cast<std::size_t>(count));
    if (connection.received.size() > kMostRequestBytes) return false;
  }
}

/// Whether the connection is to stay.
bool PageServer::send(Connection& connection) {
  while (connection.sent < connection.to_send.size()) {
    const std::string_view rest = std::string_view(connection.to_send).substr(connection.sent);
    const ssize_t count =
        ::send(connection.socket.number(), rest.data(), rest.size(), MSG_NOSIGNAL);
    if (count < 0) return errno == EAGAIN || errno == EINTR;
    connection.sent += static_cast<std::size_t>(count);
  }
  if (!connection.answered) return true;
  if (!connection.listens) return false;
  connection.to_send.clear();
  connection.sent = 0;
  return true;
}

void PageServer::answer(Connection& connection) {
  if (connection.answered) return;
  const std::size_t end = connection.received.find("\r\n\r\n");
  if (end == std::string::npos) return;
  connection.answered = true;
  connection.to_send = response_to(std::string_view(connection.received).substr(0, end));
  connection.listens = connection.to_send == kEventStream;
  if (!connection.listens) return;
  const std::lock_guard lock(mutex_);
  if (asked_for_ < published_) connection.to_send += last_told_;
}

std::string PageServer::response_to(std::string_view request) {
  std::string_view line = take_to(request, "\r\n");
  const std::string_view method = take_to(line, " ");
  std::string_view target = take_to(line, " ");
  const std::string_view path = take_to(target, "?");
  if (!line.starts_with("HTTP/1.")) return refusal("400 Bad Request");
  std::size_t hosts = 0;
  bool own = true;
  while (!request.empty()) {
    std::string_view header = take_to(request, "\r\n");
    if (lower(take_to(header, ":")) != "host") continue;
    ++hosts;
    own = own && is_own_host(without_spaces(header));
  }
  if (hosts != 1) return refusal("400 Bad Request");
  if (!own) return refusal("403 Forbidden");
  if (method != "GET") return refusal("405 Method Not Allowed");
  if (path == "/events") return std::string(kEventStream);
  const bool page = path == "/";
  if (!page && path != "/data") return refusal("404 Not Found");
  const std::lock_guard lock(mutex_);
  asked_for_ = published_;
  return page ? response("200 OK", "text/html; charset=utf-8", content_.page)
              : response("200 OK", "application/json", content_.data);
}

bool PageServer::is_own_host(std::string_view host) const {
  const std::string port = ':' + std::to_string(port_);
  const std::string name = lower(host);
  return name == "127.0.0.1" + port || name == "localhost" + port;
}

}  // namespace rigor::tool
