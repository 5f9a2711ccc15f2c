// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include "watch/page_site.h"

#include <fcntl.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <semaphore>
#include <set>
#include <system_error>
#include <utility>

#include <httplib.h>

#include "watch/socket_stream.h"

namespace rigor::tool {
namespace {

/// Beside the listeners; a browser opens six.
constexpr std::size_t kPageThreads = 8;

/// A listener that is gone is known by what cannot be sent to it.
constexpr std::chrono::seconds kHeartbeat{5};
constexpr std::string_view kBeat = ": here\n\n";

/// Takes no more connections than it has threads: the rest wait in the system's own queue.
class PageThreads final : public httplib::TaskQueue {
 public:
  /// Nothing in cpp-httplib 0.11, whether there was room for it in 0.18.
  using Enqueued = decltype(std::declval<httplib::TaskQueue&>().enqueue(nullptr));

  Enqueued enqueue(std::function<void()> connection) override {
    free_.acquire();
    return pool_.enqueue([this, connection = std::move(connection)] {
      connection();
      free_.release();
    });
  }
  void shutdown() override { pool_.shutdown(); }

 private:
  static constexpr std::size_t kThreads = PageServer::kMaxListeners + kPageThreads;
  std::counting_semaphore<kThreads> free_{kThreads};
  httplib::ThreadPool pool_{kThreads};
};

void refuse(httplib::Response& response, int status, const char* reason) {
  response.status = status;
  response.set_content(std::to_string(status) + ' ' + reason + '\n', "text/plain; charset=utf-8");
}

class HttpSite final : public PageSite, private httplib::Server {
 public:
  explicit HttpSite(std::uint16_t port) {
    using httplib::Request;
    using httplib::Response;
    new_task_queue = [] { return new PageThreads; };  // the server deletes it
    // The library's own would share the port with whoever else asks for that.
    set_socket_options([](socket_t socket) {
      const int yes = 1;
      ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
    set_default_headers({{"Cache-Control", "no-store"},
                         {"X-Content-Type-Options", "nosniff"},
                         {"X-Frame-Options", "DENY"},
                         {"Cross-Origin-Resource-Policy", "same-origin"}});
    set_pre_routing_handler([this](const Request& request, Response& response) {
      return admit(request, response) ? HandlerResponse::Unhandled : HandlerResponse::Handled;
    });
    set_error_handler([](const Request&, Response& response) {
      if (response.body.empty()) refuse(response, response.status, "Not Found");
    });
    Get("/", [this](const Request&, Response& response) {
      response.set_content(asked().page, "text/html; charset=utf-8");
    });
    Get("/data", [this](const Request&, Response& response) {
      response.set_content(asked().data, "application/json");
    });
    Get("/events", [this](const Request&, Response& response) { listen_to(response); });
    errno = 0;
    port_ = port == 0 ? bind_to_any_port("127.0.0.1") : bind_to_port("127.0.0.1", port) ? port : -1;
    if (port_ < 0) {
      const int error = errno != 0 ? errno : EADDRINUSE;
      throw std::system_error(error, std::generic_category());
    }
  }

  int port() const override { return port_; }

  void run() override { listen_after_bind(); }

  void end() override {
    const std::lock_guard lock(mutex_);
    listeners_.clear();
    changed_.notify_all();
    httplib::Server::stop();
  }

  void publish(PageServer::Content content) override {
    const std::lock_guard lock(mutex_);
    content_ = std::move(content);
    ++published_;
  }

  void tell(std::string event) override {
    const std::lock_guard lock(mutex_);
    events_.push_back(std::move(event));
    if (events_.size() > PageServer::kMaxEvents) events_.pop_front();
    ++told_;
    changed_.notify_all();
  }

 private:
  using Prepare = std::function<void(httplib::Request&)>;

  static void prepare(httplib::Request& request) {
    // Nothing is gained by compressing what stays on this machine, and brotli takes seconds for it.
    request.headers.erase("Accept-Encoding");
    request.ranges.clear();
  }

  /// The library's own, as cpp-httplib 0.11 declares it.
  bool answer(bool (Server::*process)(httplib::Stream&, bool, bool&, const Prepare&),
              httplib::Stream& stream) {
    bool closed = false;
    return (this->*process)(stream, true, closed, prepare);
  }

  /// As 0.18 does, with addresses that nothing here asks for.
  bool answer(bool (Server::*process)(httplib::Stream&, const std::string&, int, const std::string&,
                                      int, bool, bool&, const Prepare&),
              httplib::Stream& stream) {
    bool closed = false;
    return (this->*process)(stream, "", 0, "", 0, true, closed, prepare);
  }

  /// One request a connection.
  bool process_and_close_socket(socket_t socket) override {
    ::fcntl(socket, F_SETFD, FD_CLOEXEC);
    SocketStream stream(socket);
    const bool answered = answer(&HttpSite::process_request, stream);
    ::shutdown(socket, SHUT_WR);
    // What was not read would end the connection at once, and with it what is on its way.
    std::array<char, 4096> rest;
    while (::recv(socket, rest.data(), rest.size(), MSG_DONTWAIT) > 0) {
    }
    ::close(socket);
    return answered;
  }

  bool admit(const httplib::Request& request, httplib::Response& response) const {
    const std::string host = request.get_header_value("Host");
    const std::string port = ':' + std::to_string(port_);
    if (request.get_header_value_count("Host") != 1) {
      refuse(response, 400, "Bad Request");
    } else if (host != "127.0.0.1" + port && host != "localhost" + port) {
      refuse(response, 403, "Forbidden");
    } else if (request.method != "GET") {
      refuse(response, 405, "Method Not Allowed");
    } else {
      return true;
    }
    return false;
  }

  PageServer::Content asked() {
    const std::lock_guard lock(mutex_);
    asked_for_ = published_;
    return content_;
  }

  void listen_to(httplib::Response& response) {
    const std::lock_guard lock(mutex_);
    const std::uint64_t listener = next_listener_++;
    listeners_.insert(listener);
    if (listeners_.size() > PageServer::kMaxListeners) {
      listeners_.erase(listeners_.begin());
      changed_.notify_all();
    }
    // Who asked for the page before the last change hears of it now.
    const bool late = asked_for_ < published_ && told_ > 0;
    response.set_content_provider(
        "text/event-stream",
        [this, listener, heard = told_ - (late ? 1 : 0), text = std::string(kBeat)](
            std::size_t, httplib::DataSink& sink) mutable {
          if (!sink.write(text.data(), text.size())) return false;
          return wait_for_events(listener, heard, text);
        },
        [this, listener](bool) {
          const std::lock_guard released(mutex_);
          listeners_.erase(listener);
        });
  }

  /// Into `text` what was reported since; false when the listener is let go.
  bool wait_for_events(std::uint64_t listener, std::uint64_t& heard, std::string& text) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, kHeartbeat,
                      [&] { return heard < told_ || !listeners_.contains(listener); });
    if (!listeners_.contains(listener)) return false;
    text = heard < told_ ? "" : kBeat;
    const std::uint64_t first = told_ - events_.size();
    for (heard = std::max(heard, first); heard < told_; ++heard) text += events_[heard - first];
    return true;
  }

  int port_ = -1;
  std::mutex mutex_;  // of all that follows
  std::condition_variable changed_;
  PageServer::Content content_;
  std::uint64_t published_ = 0;
  std::uint64_t asked_for_ = 0;
  std::deque<std::string> events_;  // the last that were reported
  std::uint64_t told_ = 0;
  std::set<std::uint64_t> listeners_;  // the oldest first
  std::uint64_t next_listener_ = 0;
};

}  // namespace
}  // namespace rigor::tool

rigor::tool::PageSite* rigor_open_page_site(std::uint16_t port) {
  return new rigor::tool::HttpSite(port);
}
