// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Serves one page to browsers on this machine, and tells them when it changed. HTTP/1.1, GET only, on
// 127.0.0.1; a request that names another host is refused, so that no page of somebody else's reaches it by a
// name that leads here (DNS rebinding).
//
//   PageServer server(0);
//   say(server.address());
//   server.publish({page, data});
//   std::thread([&] { server.run(); }).detach();
//   server.publish({new_page, new_data});
//   server.tell("changed", json);

#pragma once

#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/process/descriptor.h>

namespace rigor::tool {

class PageServer {
 public:
  /// What it answers.
  struct Content {
    std::string page;  ///< of GET /: HTML
    std::string data;  ///< of GET /data: JSON
  };

  /// Port 0: one that is free. A UsageError when it is not to be had. Connections are taken from now on.
  explicit PageServer(std::uint16_t port);
  ~PageServer();
  PageServer(const PageServer&) = delete;
  PageServer& operator=(const PageServer&) = delete;

  /// "http://127.0.0.1:40123/"
  std::string address() const;

  /// Answers; comes back only when the system refuses to wait. In a thread of its own.
  void run();

  /// From now on. From any thread, as well as `tell`.
  void publish(Content content);

  /// To everyone who listens at /events (server-sent events). `data` is one line.
  void tell(std::string_view event, std::string_view data);

 private:
  struct Connection;

  void accept_one();
  void take_told();
  static bool receive(Connection& connection);
  static bool send(Connection& connection);
  void answer(Connection& connection);
  std::string response_to(std::string_view request);
  bool is_own_host(std::string_view host) const;

  process::Descriptor listener_{-1};
  process::Descriptor wake_{-1};
  std::uint16_t port_ = 0;
  std::list<Connection> connections_;  // of the thread that runs
  std::mutex mutex_;                   // of all that follows
  Content content_;
  std::vector<std::string> told_;
  // A page that was asked for before the last change, and listens since, hears of it then.
  std::string last_told_;
  std::uint64_t published_ = 0;
  std::uint64_t asked_for_ = 0;
};

}  // namespace rigor::tool
