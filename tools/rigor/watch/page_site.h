// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The server behind `PageServer`, in a module of its own that is opened when a page is served: cpp-httplib as Debian
// builds it brings OpenSSL and Brotli, and loading those takes every run of every command two milliseconds.
//
//   auto open = reinterpret_cast<decltype(&rigor_open_page_site)>(dlsym(module, kOpenPageSite));
//   std::unique_ptr<PageSite> site(open(0));

#pragma once

#include <cstdint>
#include <string>

#include "watch/page_server.h"

namespace rigor::tool {

/// As `PageServer` describes them.
class PageSite {
 public:
  virtual ~PageSite() = default;
  virtual int port() const = 0;
  virtual void run() = 0;
  virtual void end() = 0;
  virtual void publish(PageServer::Content content) = 0;
  /// `event` is the whole text of a server-sent event.
  virtual void tell(std::string event) = 0;
};

/// The file's name, beside the worker's program, and the function in it.
inline constexpr const char* kPageModule = "rigor-page-server.so";
inline constexpr const char* kOpenPageSite = "rigor_open_page_site";

}  // namespace rigor::tool

/// The caller owns it. Throws std::system_error when the port cannot be bound.
extern "C" rigor::tool::PageSite* rigor_open_page_site(std::uint16_t port);
