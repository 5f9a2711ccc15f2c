// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What is compiled in place of the server without cpp-httplib (RIGOR_WITH_HTTPLIB=OFF).

#include "command/command.h"
#include "watch/page_server.h"

namespace rigor::tool {

class PageSite {};

PageServer::PageServer(std::uint16_t) { refuse_without("cpp-httplib", "view --serve"); }
PageServer::~PageServer() = default;

// There is no server to call them on.
std::string PageServer::address() const { return {}; }
void PageServer::run() {}
void PageServer::stop() {}
void PageServer::publish(Content) {}
void PageServer::tell(std::string_view, std::string_view) {}

}  // namespace rigor::tool
