// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "watch/page_server.h"

#include <dlfcn.h>

#include <system_error>
#include <utility>

#include <rigor/process/worker_path.h>

#include "command/command.h"
#include "watch/page_site.h"

namespace rigor::tool {
namespace {

std::unique_ptr<PageSite> open_site(std::uint16_t port) {
  const std::string module = process::path_beside_worker(kPageModule);
  // Never closed: its threads may outlast the server by a moment.
  void* handle = ::dlopen(module.c_str(), RTLD_NOW | RTLD_LOCAL);
  void* found = handle == nullptr ? nullptr : ::dlsym(handle, kOpenPageSite);
  if (found == nullptr) {
    const char* reason = ::dlerror();
    throw UsageError("view --serve needs " + module + ": " + (reason ? reason : "not found"));
  }
  try {
    const auto open = reinterpret_cast<decltype(&rigor_open_page_site)>(found);
    return std::unique_ptr<PageSite>(open(port));
  } catch (const std::system_error& error) {
    throw UsageError("--port " + std::to_string(port) + ": " + error.code().message());
  }
}

}  // namespace

PageServer::PageServer(std::uint16_t port) : site_(open_site(port)) {}

PageServer::~PageServer() = default;

std::string PageServer::address() const {
  return "http://127.0.0.1:" + std::to_string(site_->port()) + '/';
}

void PageServer::run() { site_->run(); }

void PageServer::stop() { site_->end(); }

void PageServer::publish(Content content) { site_->publish(std::move(content)); }

void PageServer::tell(std::string_view event, std::string_view data) {
  site_->tell("event: " + std::string(event) + "\ndata: " + std::string(data) + "\n\n");
}

}  // namespace rigor::tool
