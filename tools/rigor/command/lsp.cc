// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor lsp`: the language server, on stdio or on a port of this machine.

#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

#include <arpa/inet.h>
#include <malloc.h>
#include <netinet/in.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <rigor/lsp/protocol/framing.h>
#include <rigor/lsp/session/message_queue.h>
#include <rigor/lsp/session/session.h>
#include <rigor/process/descriptor.h>
#include <rigor/text/disk.h>
#include <rigor/text/write_all.h>

#include "command/command.h"
#include "option/search.h"
#include "output/output.h"

namespace rigor::tool {
namespace {

void read_messages(int descriptor, lsp::MessageQueue& queue) {
  lsp::FrameReader frames;
  std::string buffer(std::size_t{1} << 16U, '\0');
  while (!frames.broken()) {
    const ssize_t count = ::read(descriptor, buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) break;
    frames.add(std::string_view(buffer).substr(0, static_cast<std::size_t>(count)));
    while (const std::optional<std::string> body = frames.next()) {
      lsp::Json message = lsp::parsed_json(*body);
      const bool is_last = lsp::text_at(message, "method") == "exit";
      queue.put(std::move(message));
      if (is_last) return queue.close();
    }
  }
  queue.close();
}

/// A check takes some twenty times the size of a text, and gives it back: with the allocator's own thresholds each key
/// would fetch that from the kernel anew, which costs more than the check. The first one fetches it in pages of 2 MB:
/// thousands of small ones take longer than all else of it.
void keep_memory_between_checks() {
#ifdef __GLIBC__
  constexpr int kKeptBytes = 96 << 20;
  mallopt(M_MMAP_THRESHOLD, kKeptBytes);
  mallopt(M_TRIM_THRESHOLD, kKeptBytes);
  constexpr std::size_t kHeapBytes = std::size_t{90} << 20U;
  void* const heap = std::malloc(kHeapBytes);
  if (heap == nullptr) return;
  constexpr std::uintptr_t kHugePage = std::uintptr_t{2} << 20U;
  const std::uintptr_t begin =
      (reinterpret_cast<std::uintptr_t>(heap) + kHugePage - 1) & ~(kHugePage - 1);
  ::madvise(reinterpret_cast<void*>(begin), kHeapBytes - kHugePage, MADV_HUGEPAGE);
  std::free(heap);
#endif
}

/// Between two keys of somebody who types fast there is less; who stops to look waits longer.
constexpr std::chrono::milliseconds kKeyPause{60};
/// Nobody types when no message has come for so long.
constexpr std::chrono::milliseconds kTypingPause{400};

/// Wakes the loop when a check in the background has come to its end. A client that sends it wakes the loop, too.
constexpr std::string_view kChecked = "$/rigor/checked";

constexpr int kBackgroundNice = 10;

/// One check in the background at a time, on a thread of its own.
class CheckThread {
 public:
  explicit CheckThread(lsp::MessageQueue& queue) : queue_(queue) {}
  CheckThread(const CheckThread&) = delete;
  CheckThread& operator=(const CheckThread&) = delete;
  ~CheckThread() {
    stop();
    if (thread_.joinable()) thread_.join();
  }

  bool idle() const { return !check_; }

  void start(std::unique_ptr<lsp::BackgroundCheck> check) {
    check_ = std::move(check);
    if (!check_) return;
    done_ = false;
    failed_ = false;
    thread_ = std::thread([this] {
      // Of one thread on Linux: whoever types comes first.
      ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), kBackgroundNice);
      try {
        check_->run();
      } catch (const std::exception&) {
        failed_ = true;  // out of memory: what was found before stands
      }
      done_ = true;
      queue_.put({{"method", kChecked}});
    });
  }

  void stop() {
    if (check_) check_->stop();
  }

  /// What has come to its end; else null.
  std::unique_ptr<lsp::BackgroundCheck> taken() {
    if (!check_ || !done_) return nullptr;
    thread_.join();
    std::unique_ptr<lsp::BackgroundCheck> check = std::move(check_);
    return failed_ ? nullptr : std::move(check);
  }

 private:
  lsp::MessageQueue& queue_;
  std::unique_ptr<lsp::BackgroundCheck> check_;
  std::atomic<bool> done_ = false;
  bool failed_ = false;
  std::thread thread_;
};

/// Whether a message makes what a check in the background finds out of date.
bool ends_check(const lsp::Json& message) {
  const std::string method = lsp::text_at(message, "method");
  return method.starts_with("textDocument/did") || method.starts_with("workspace/did");
}

/// One connection, to its end: the exit code.
int serve(int in, int out, read::SearchPaths paths) {
  const RealDisk disk;
  lsp::MessageQueue queue;
  lsp::Session session(
      disk, std::move(paths),
      {.send =
           [out](const lsp::Json& message) {
             write_all(out, lsp::framed(lsp::json_text(message)));
           },
       .is_cancelled = [&queue](const lsp::Json& id) { return queue.is_cancelled(id); },
       .is_superseded = [&queue](const std::string& uri) { return queue.is_superseded(uri); }});
  std::thread reader([in, &queue] { read_messages(in, queue); });
  CheckThread background(queue);
  while (!session.exit_code()) {
    const bool checks_whole = background.idle() && session.wants_whole_check();
    const bool opens_meshes = background.idle() && session.wants_mesh_check();
    const bool has_more = session.has_idle_work() || opens_meshes;
    std::optional<lsp::Json> message = session.has_work() ? queue.take()
                                       : checks_whole     ? queue.wait_for(kKeyPause)
                                       : has_more         ? queue.wait_for(kTypingPause)
                                                          : queue.wait();
    if (message) {
      if (ends_check(*message)) background.stop();
      if (const auto done = background.taken()) session.finish(*done);
      if (lsp::text_at(*message, "method") != kChecked) session.receive(*message);
    } else if (session.has_work()) {
      session.work();
    } else if (queue.ended()) {
      break;  // the stream has ended
    } else if (checks_whole) {
      background.start(session.take_whole_check());
    } else if (session.has_idle_work()) {
      session.idle_work();
    } else if (opens_meshes) {
      background.start(session.take_mesh_check());
    }
  }
  reader.join();
  return session.exit_code().value_or(kFindings);
}

/// A connection to a port of this machine; nobody else can reach it.
int accepted(std::uint16_t port) {
  const auto refuse = [port] {
    throw UsageError("--socket " + std::to_string(port) + ": " +
                     std::generic_category().message(errno));
  };
  const process::Descriptor listening(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
  const int listener = listening.number();
  if (listener < 0) refuse();
  const int on = 1;
  ::setsockopt(listener, SOL_SOCKET, SO_REUSEADDR, &on, sizeof(on));
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (::bind(listener, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) != 0 ||
      ::listen(listener, 1) != 0) {
    refuse();
  }
  int connection = -1;
  do {
    connection = ::accept4(listener, nullptr, nullptr, SOCK_CLOEXEC);
  } while (connection < 0 && errno == EINTR);
  if (connection < 0) refuse();
  return connection;
}

class Lsp final : public Command {
 public:
  CLI::App* declare(CLI::App& program) override {
    CLI::App* app = add_command(program, "lsp", "Serve editors: findings, fixes, names as you type",
                                {"rigor lsp", "rigor lsp --socket 9257"});
    app->add_flag("--stdio", stdio_, "Speak the protocol on stdin and stdout: the default");
    app->add_option("--socket", port_, "Speak it on this port of this machine")
        ->type_name("PORT")
        ->check(CLI::Range(1, 65535));
    return app;
  }

  int run() override {
    keep_memory_between_checks();
    if (port_ == 0) return serve(STDIN_FILENO, STDOUT_FILENO, search_.paths());
    const int connection = accepted(static_cast<std::uint16_t>(port_));
    const int code = serve(connection, connection, search_.paths());
    ::close(connection);
    return code;
  }

 private:
  bool stdio_ = false;  // as many editors say it
  int port_ = 0;
  SearchOptions search_;
};

}  // namespace

std::unique_ptr<Command> lsp_command() { return std::make_unique<Lsp>(); }

}  // namespace rigor::tool
