// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Messages between the thread that reads a stream and the one that answers them.
//
//   MessageQueue queue;
//   std::thread reader([&] { while (…) queue.put(parsed_json(body)); queue.close(); });
//   while (std::optional<Json> message = queue.wait()) session.receive(*message);

#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <set>
#include <string>

#include <rigor/lsp/protocol/json.h>

namespace rigor::lsp {

class MessageQueue {
 public:
  /// `$/cancelRequest` is not handed on: it marks the request.
  void put(Json message);
  /// No more will come.
  void close();

  /// The next message, waited for; nothing when the queue is closed and empty.
  std::optional<Json> wait();
  /// The same, but nothing when none comes in that time either.
  std::optional<Json> wait_for(std::chrono::milliseconds time);
  /// The next message if there is one.
  std::optional<Json> take();
  /// Whether it is closed and empty.
  bool ended();

  bool is_cancelled(const Json& id);
  /// Whether a message that changes or closes the document waits.
  bool is_superseded(const std::string& uri);

 private:
  std::optional<Json> front();

  std::mutex mutex_;
  std::condition_variable came_;
  std::deque<Json> messages_;
  std::set<std::string> cancelled_;  // ids as JSON
  bool closed_ = false;
};

}  // namespace rigor::lsp
