// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Serves one page to browsers on this machine, and tells them when it changed. HTTP/1.1 by cpp-httplib, GET
// only, on 127.0.0.1; a request that names another host is refused, so that no page of somebody else's reaches
// it by a name that leads here (DNS rebinding).
//
//   PageServer server(0);
//   say(server.address());
//   server.publish({page, data});
//   std::thread([&] { server.run(); }).detach();
//   server.publish({new_page, new_data});
//   server.tell("changed", json);

#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace rigor::tool {

class PageSite;

class PageServer {
 public:
  /// What it answers.
  struct Content {
    std::string page;  ///< of GET /: HTML
    std::string data;  ///< of GET /data: JSON
  };

  /// A page listens once; when more do, the one that listens longest is let go, and may come again.
  static constexpr std::size_t kMaxListeners = 16;
  /// Of events, the last so many wait for a listener that is slow; older ones it misses.
  static constexpr std::size_t kMaxEvents = 16;

  /// Port 0: one that is free. A UsageError when it is not to be had. Connections are taken from now on.
  explicit PageServer(std::uint16_t port);
  ~PageServer();
  PageServer(const PageServer&) = delete;
  PageServer& operator=(const PageServer&) = delete;

  /// "http://127.0.0.1:40123/"
  std::string address() const;

  /// Answers until `stop`. In a thread of its own.
  void run();

  /// From any thread, as well as the next two. Ends every connection.
  void stop();

  /// From now on.
  void publish(Content content);

  /// To everyone who listens at /events (server-sent events). `data` is one line.
  void tell(std::string_view event, std::string_view data);

 private:
  std::unique_ptr<PageSite> site_;
};

}  // namespace rigor::tool
