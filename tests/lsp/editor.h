// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// An editor in memory: it opens and changes documents, and asks for things.

#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <rigor/lsp/protocol/json.h>
#include <rigor/lsp/session/session.h>
#include <rigor/text/disk.h>

namespace rigor::lsp::test {

/// Of a `MemoryDisk`: bytes by path.
using Files = std::map<std::string, std::string>;

class Editor {
 public:
  explicit Editor(const Disk& disk, Json capabilities = default_capabilities(),
                  const std::string& folder = "/ws",
                  std::shared_ptr<const Knowledge> knowledge = std::make_shared<const Knowledge>())
      : session_(disk, {}, {.send = [this](const Json& message) { take(message); }}, {},
                 std::move(knowledge)) {
    initialized_ = request("initialize",
                           {{"capabilities", std::move(capabilities)},
                            {"workspaceFolders", {{{"uri", "file://" + folder}, {"name", "ws"}}}}});
    notify("initialized", Json::object());
  }

  static Json default_capabilities() {
    return {{"general", {{"positionEncodings", {"utf-8", "utf-16"}}}},
            {"textDocument", {{"completion", {{"completionItem", {{"snippetSupport", true}}}}}}}};
  }

  const Json& initialized() const { return initialized_; }

  /// The result; of an error null, and `error()` has it.
  Json request(const std::string& method, Json params) {
    const int id = ++last_id_;
    session_.receive(
        {{"jsonrpc", "2.0"}, {"id", id}, {"method", method}, {"params", std::move(params)}});
    Json response = responses_[id];
    error_ = response.value("error", Json());
    return response.value("result", Json());
  }
  const Json& error() const { return error_; }

  void notify(const std::string& method, Json params) {
    session_.receive({{"jsonrpc", "2.0"}, {"method", method}, {"params", std::move(params)}});
  }

  void work() {
    work_on_keys();
    while (const auto check = session_.take_whole_check()) {
      check->run();
      session_.finish(*check);
      work_on_keys();
    }
    while (session_.has_idle_work()) session_.idle_work();
  }
  /// What is done between two keys of somebody who types fast.
  void work_on_keys() {
    while (session_.has_work()) session_.work();
  }

  void open(const std::string& path, const std::string& text) {
    texts_[path] = text;
    notify(
        "textDocument/didOpen",
        {{"textDocument",
          {{"uri", uri(path)}, {"languageId", "xml"}, {"version", ++version_}, {"text", text}}}});
    work();
  }

  void change(const std::string& path, const std::string& text) {
    type(path, text);
    work();
  }

  /// Without time for the server to look at it.
  void type(const std::string& path, const std::string& text) {
    texts_[path] = text;
    notify("textDocument/didChange",
           {{"textDocument", {{"uri", uri(path)}, {"version", ++version_}}},
            {"contentChanges", {{{"text", text}}}}});
  }

  static std::string uri(const std::string& path) { return "file://" + path; }

  /// Where `mark` begins, moved by some bytes. The encoding is UTF-8.
  Json position(const std::string& path, const std::string& mark, std::size_t moved = 0) const {
    const std::string& text = texts_.at(path);
    const std::size_t offset = text.find(mark) + moved;
    EXPECT_NE(text.find(mark), std::string::npos) << mark;
    const auto line =
        std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(offset), '\n');
    const std::size_t begin = offset == 0 ? 0 : text.rfind('\n', offset - 1) + 1;
    return {{"line", line}, {"character", offset - begin}};
  }

  Json at(const std::string& path, const std::string& mark, std::size_t moved = 0) const {
    return {{"textDocument", {{"uri", uri(path)}}}, {"position", position(path, mark, moved)}};
  }
  Json document(const std::string& path) const { return {{"textDocument", {{"uri", uri(path)}}}}; }

  /// The last that were published of a file; null when none were.
  const Json& diagnostics(const std::string& path) { return diagnostics_[uri(path)]; }
  /// Their rules.
  std::vector<std::string> rules(const std::string& path) {
    std::vector<std::string> rules;
    for (const Json& each : diagnostics(path)) rules.push_back(text_at(each, "code"));
    return rules;
  }

  /// The text of a file with an edit of the workspace done.
  std::string edited(const std::string& path, const Json& edit) const {
    const auto edits =
        edit.find("changes") == edit.end() ? Json() : edit["changes"].value(uri(path), Json());
    return applied(texts_.at(path), edits);
  }

  static std::string applied(std::string text, Json edits) {
    std::sort(edits.begin(), edits.end(),
              [](const Json& a, const Json& b) { return key(a) > key(b); });
    for (const Json& each : edits) {
      const std::size_t begin = offset(text, each["range"]["start"]);
      text.replace(begin, offset(text, each["range"]["end"]) - begin,
                   each["newText"].get<std::string>());
    }
    return text;
  }

  Session& session() { return session_; }
  const std::vector<Json>& log() const { return log_; }

 private:
  static std::pair<int, int> key(const Json& edit) {
    return {edit["range"]["start"]["line"].get<int>(),
            edit["range"]["start"]["character"].get<int>()};
  }
  static std::size_t offset(const std::string& text, const Json& position) {
    std::size_t at = 0;
    for (int line = position["line"].get<int>(); line > 0; --line) at = text.find('\n', at) + 1;
    return at + position["character"].get<std::size_t>();
  }

  void take(const Json& message) {
    log_.push_back(message);
    if (message.contains("id") && message["id"].is_number())
      responses_[message["id"].get<int>()] = message;
    if (text_at(message, "method") == "textDocument/publishDiagnostics")
      diagnostics_[text_at(message, "params", "uri")] = member(message, "params", "diagnostics");
  }

  std::map<int, Json> responses_;
  std::map<std::string, Json> diagnostics_;
  std::map<std::string, std::string> texts_;
  std::vector<Json> log_;
  Session session_;
  Json initialized_;
  Json error_;
  int last_id_ = 0;
  int version_ = 0;
};

}  // namespace rigor::lsp::test
