// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/lsp/session/message_queue.h>

#include <algorithm>
#include <utility>

namespace rigor::lsp {

void MessageQueue::put(Json message) {
  {
    const std::lock_guard lock(mutex_);
    if (text_at(message, "method") == "$/cancelRequest") {
      const Json& id = member(message, "params", "id");
      const bool waits = std::any_of(messages_.begin(), messages_.end(),
                                     [&id](const Json& each) { return member(each, "id") == id; });
      if (waits) cancelled_.insert(json_text(id));
      return;
    }
    messages_.push_back(std::move(message));
  }
  came_.notify_one();
}

void MessageQueue::close() {
  {
    const std::lock_guard lock(mutex_);
    closed_ = true;
  }
  came_.notify_one();
}

std::optional<Json> MessageQueue::front() {
  if (messages_.empty()) return std::nullopt;
  Json message = std::move(messages_.front());
  messages_.pop_front();
  return message;
}

std::optional<Json> MessageQueue::wait() {
  std::unique_lock lock(mutex_);
  came_.wait(lock, [this] { return closed_ || !messages_.empty(); });
  return front();
}

std::optional<Json> MessageQueue::wait_for(std::chrono::milliseconds time) {
  std::unique_lock lock(mutex_);
  came_.wait_for(lock, time, [this] { return closed_ || !messages_.empty(); });
  return front();
}

bool MessageQueue::ended() {
  const std::lock_guard lock(mutex_);
  return closed_ && messages_.empty();
}

std::optional<Json> MessageQueue::take() {
  const std::lock_guard lock(mutex_);
  return front();
}

bool MessageQueue::is_cancelled(const Json& id) {
  const std::lock_guard lock(mutex_);
  return cancelled_.erase(json_text(id)) > 0;
}

bool MessageQueue::is_superseded(const std::string& uri) {
  const std::lock_guard lock(mutex_);
  return std::any_of(messages_.begin(), messages_.end(), [&uri](const Json& message) {
    const std::string method = text_at(message, "method");
    return (method == "textDocument/didChange" || method == "textDocument/didClose") &&
           text_at(message, "params", "textDocument", "uri") == uri;
  });
}

}  // namespace rigor::lsp
