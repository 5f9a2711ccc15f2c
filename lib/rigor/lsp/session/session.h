// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A language server's side of one connection: messages in, messages out. No threads and no clock: who owns the
// stream says what has come in since (session/message_queue.h).
//
//   Session session(disk, read::search_paths_from(variable), {.send = [](const Json& message) { … }});
//   session.receive(message);
//   while (session.has_work()) session.work();
//   while (session.has_idle_work()) session.idle_work();
//   if (auto check = session.take_whole_check()) { check->run(); session.finish(*check); }
//   if (auto check = session.take_mesh_check()) { check->run(); session.finish(*check); }
//   return session.exit_code();
//
// What a document says is published by `work`, when no message waits. Of a large one that is what a change shows in its
// part; the rest, and what meshes show, is found by checks that the owner runs on a thread of its own, when nobody types.

#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <rigor/lsp/project/background_check.h>
#include <rigor/lsp/protocol/json.h>
#include <rigor/lsp/session/mesh_findings.h>
#include <rigor/lsp/session/state.h>
#include <rigor/read/resolver.h>
#include <rigor/text/disk.h>

namespace rigor::lsp {

/// The other side.
struct Peer {
  std::function<void(const Json& message)> send;
  /// Whether the client takes a request back that it has sent; none is when empty.
  std::function<bool(const Json& id)> is_cancelled = {};
  /// Whether a change of the document waits: what is found in it now is of no use. None does when empty.
  std::function<bool(const std::string& uri)> is_superseded = {};
};

class Session {
 public:
  /// The disk outlives it. `worker` is the path of rigor-worker, found by itself when empty.
  Session(const Disk& disk, read::SearchPaths paths, Peer peer, std::string worker = {},
          std::shared_ptr<const Knowledge> knowledge = std::make_shared<const Knowledge>());

  /// Any message; what is none is answered with an error.
  void receive(const Json& message);

  /// Whether documents wait to be checked.
  bool has_work() const { return !to_check_.empty(); }
  /// Checks one of them and publishes what is found.
  void work();

  /// Whether something can be done ahead of requests, when no key has come for a moment; and does it.
  bool has_idle_work() const { return !to_prepare_.empty(); }
  void idle_work();

  /// Whether large documents of which a part was checked wait for the rest.
  bool wants_whole_check() const { return !to_check_whole_.empty(); }
  /// That of one of them; null when none waits. To be stopped when a document is changed.
  std::unique_ptr<BackgroundCheck> take_whole_check();

  /// Whether meshes of documents that were opened or saved wait to be opened.
  bool wants_mesh_check() const { return !to_open_meshes_.empty(); }
  /// The same of those.
  std::unique_ptr<BackgroundCheck> take_mesh_check();

  /// Publishes what it found; what was stopped, or is of an earlier text, is to be done again.
  void finish(BackgroundCheck& check);

  /// Documents of at least so many bytes are large.
  void set_large(std::size_t bytes) { state_.large_bytes = bytes; }

  /// After `exit`: 0 when `shutdown` came before, else 1. Nothing before.
  std::optional<int> exit_code() const { return exit_code_; }

 private:
  void request(const Json& message);
  void notification(const std::string& method, const Json& params);
  Json answer(const std::string& method, const Json& params);
  Json initialize(const Json& params);
  Json pulled_diagnostics(const Json& params);
  void fail(const Json& id, ErrorCode code, const std::string& message);

  void watch_files();
  void did_open(const Json& params);
  void did_change(const Json& params);
  void did_close(const Json& params);
  void did_save(const Json& params);
  void files_changed();
  void check_dependents(const std::string& path);
  void check_srdf_of(const std::string& path);
  void check_later(const std::string& uri);
  /// Of a client that pulls: something other than a key has changed what there is.
  void ask_to_pull();
  void open_meshes_later(const OpenDocument& document);
  std::unique_ptr<BackgroundCheck> background_check(std::vector<std::string>& of,
                                                    rules::MeshPolicy meshes);
  std::map<std::string, std::vector<Json>> findings_of(OpenDocument& document);
  void publish(OpenDocument& document);
  void publish_of_root(const std::string& root, std::map<std::string, std::vector<Json>> by_uri);
  void publish_uri(const std::string& uri);

  State state_;
  Peer peer_;
  enum class Phase { kNew, kInitialized, kShutDown } phase_ = Phase::kNew;
  std::optional<int> exit_code_;
  // URIs, what comes last first.
  std::vector<std::string> to_check_;
  std::vector<std::string> to_prepare_;
  std::vector<std::string> to_check_whole_;
  std::vector<std::string> to_open_meshes_;
  std::map<std::string, MeshFindings> mesh_findings_;  // by URI
  /// What each checked document shows, by the URI that it is shown at.
  std::map<std::string, std::map<std::string, std::vector<Json>>> published_;
  std::map<std::string, Json> sent_;  // parameters of the last publication, by URI
};

}  // namespace rigor::lsp
