// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/lsp/session/session.h>

#include <exception>
#include <set>
#include <utility>

#include <rigor/lsp/answer/answers.h>
#include <rigor/lsp/answer/diagnostics.h>
#include <rigor/lsp/protocol/uri.h>
#include <rigor/lsp/session/capabilities.h>
#include <rigor/report/tool.h>
#include <rigor/text/path.h>

namespace rigor::lsp {
namespace {

bool drop(std::vector<std::string>& list, const std::string& value) {
  return std::erase(list, value) > 0;
}

}  // namespace

Session::Session(const Disk& disk, read::SearchPaths paths, Peer peer, std::string worker,
                 std::shared_ptr<const Knowledge> knowledge)
    : state_(disk, std::move(paths), std::move(worker), std::move(knowledge)),
      peer_(std::move(peer)) {}

void Session::receive(const Json& message) {
  if (exit_code_) return;
  state_.cached_disk.expire();
  if (message.is_discarded())
    return fail(nullptr, ErrorCode::kParseError, "the message is no JSON");
  const std::string method = text_at(message, "method");
  const bool is_request = message.is_object() && message.contains("id");
  if (method.empty()) {
    const bool is_response =
        is_request && (message.contains("result") || message.contains("error"));
    if (!is_response) fail(nullptr, ErrorCode::kInvalidRequest, "the message has no method");
    return;
  }
  if (is_request) return request(message);
  if (method == "exit") {
    exit_code_ = phase_ == Phase::kShutDown ? 0 : 1;
  } else if (phase_ == Phase::kInitialized) {
    notification(method, member(message, "params"));
  }
}

void Session::fail(const Json& id, ErrorCode code, const std::string& message) {
  peer_.send({{"jsonrpc", "2.0"},
              {"id", id},
              {"error", {{"code", static_cast<int>(code)}, {"message", message}}}});
}

void Session::request(const Json& message) {
  const Json& id = member(message, "id");
  const std::string method = text_at(message, "method");
  try {
    if (phase_ == Phase::kShutDown)
      throw RequestError(ErrorCode::kInvalidRequest, "the server was shut down");
    if ((phase_ == Phase::kNew) != (method == "initialize")) {
      throw phase_ == Phase::kNew
          ? RequestError(ErrorCode::kServerNotInitialized, "the server is not initialized")
          : RequestError(ErrorCode::kInvalidRequest, "the server is initialized already");
    }
    if (peer_.is_cancelled && peer_.is_cancelled(id))
      throw RequestError(ErrorCode::kRequestCancelled, "cancelled");
    Json result = answer(method, member(message, "params"));
    peer_.send({{"jsonrpc", "2.0"}, {"id", id}, {"result", std::move(result)}});
  } catch (const RequestError& error) {
    fail(id, error.code(), error.what());
  } catch (const std::exception& error) {
    fail(id, ErrorCode::kInternalError, error.what());
  }
}

Json Session::answer(const std::string& method, const Json& params) {
  if (method == "initialize") return initialize(params);
  if (method == "shutdown") {
    phase_ = Phase::kShutDown;
    return nullptr;
  }
  if (method == "textDocument/diagnostic") return pulled_diagnostics(params);
  const Answer function = find_answer(method);
  if (function == nullptr)
    throw RequestError(ErrorCode::kMethodNotFound, "unknown method " + method);
  return function(state_, params);
}

Json Session::initialize(const Json& params) {
  state_.client = client_of(params);
  phase_ = Phase::kInitialized;
  return {{"capabilities", server_capabilities(state_.client)},
          {"serverInfo", {{"name", "rigor"}, {"version", std::string(report::tool_version())}}}};
}

void Session::notification(const std::string& method, const Json& params) {
  if (method == "initialized") return watch_files();
  if (method == "textDocument/didOpen") return did_open(params);
  if (method == "textDocument/didChange") return did_change(params);
  if (method == "textDocument/didClose") return did_close(params);
  if (method == "textDocument/didSave") return did_save(params);
  if (method == "workspace/didChangeWatchedFiles") return files_changed();
  if (method == "workspace/didChangeWorkspaceFolders") {
    std::vector<std::string>& folders = state_.client.folders;
    for (const Json& folder : member(params, "event", "removed"))
      drop(folders, normalize_path(path_of_uri(text_at(folder, "uri"))));
    for (const Json& folder : member(params, "event", "added"))
      folders.push_back(normalize_path(path_of_uri(text_at(folder, "uri"))));
  }
}

/// Whoever else writes files that models are made of: a build, a version control.
void Session::watch_files() {
  if (!state_.client.registers_watchers) return;
  Json watchers =
      Json::array({{{"globPattern", "**/*.{sdf,world,urdf,xacro,srdf,config,yaml,baseline}"}},
                   {{"globPattern", "**/{rigor.toml,package.xml}"}}});
  peer_.send({{"jsonrpc", "2.0"},
              {"id", "watch"},
              {"method", "client/registerCapability"},
              {"params",
               {{"registrations",
                 {{{"id", "watch"},
                   {"method", "workspace/didChangeWatchedFiles"},
                   {"registerOptions", {{"watchers", std::move(watchers)}}}}}}}}});
}

void Session::did_open(const Json& params) {
  const Json& item = member(params, "textDocument");
  const std::string uri = text_at(item, "uri");
  if (uri.empty()) return;
  auto document = std::make_unique<OpenDocument>(uri, number_at(item, "version"),
                                                 text_at(item, "text"), state_.client.encoding);
  const std::string path = document->path();
  const bool is_new = state_.disk.kind(path) == PathKind::kMissing;
  state_.disk.open_in_editor(path, document->text());
  state_.documents[uri] = std::move(document);
  state_.checks.erase(uri);
  state_.mesh_checks.erase(uri);
  // Whoever looked for the file in vain is not known.
  if (is_new) files_changed();
  check_later(uri);
  open_meshes_later(*state_.documents[uri]);
  check_dependents(path);
}

void Session::did_save(const Json& params) {
  files_changed();
  const auto found = state_.documents.find(text_at(params, "textDocument", "uri"));
  if (found != state_.documents.end()) open_meshes_later(*found->second);
}

void Session::did_change(const Json& params) {
  const auto found = state_.documents.find(text_at(params, "textDocument", "uri"));
  if (found == state_.documents.end()) return;
  OpenDocument& document = *found->second;
  for (const Json& change : member(params, "contentChanges")) {
    std::optional<TextRange> range;
    if (change.is_object() && change.contains("range")) {
      const auto position = [&](std::string_view end) {
        return document.lines().position(offset_in(document, member(change, "range", end)));
      };
      range = TextRange{position("start"), position("end")};
    }
    state_.keep_check(document);
    const TextChange changed = document.change(range, text_at(change, "text"));
    const auto kept = mesh_findings_.find(document.uri());
    if (kept != mesh_findings_.end()) kept->second.follow(changed);
  }
  for (auto& [uri, kept] : mesh_findings_) kept.forget(document.uri());
  document.set_version(number_at(params, "textDocument", "version"));
  state_.disk.open_in_editor(document.path(), document.text());
  check_later(document.uri());
  check_dependents(document.path());
}

void Session::did_close(const Json& params) {
  const std::string uri = text_at(params, "textDocument", "uri");
  const auto found = state_.documents.find(uri);
  if (found == state_.documents.end()) return;
  const std::string path = found->second->path();
  state_.disk.close_in_editor(path);
  state_.documents.erase(found);
  state_.checks.erase(uri);
  state_.mesh_checks.erase(uri);
  drop(to_check_, uri);
  drop(to_prepare_, uri);
  drop(to_check_whole_, uri);
  drop(to_open_meshes_, uri);
  mesh_findings_.erase(uri);
  publish_of_root(uri, {});
  check_dependents(path);
}

void Session::files_changed() {
  state_.renew_project();
  for (const auto& [uri, document] : state_.documents) check_later(uri);
  ask_to_pull();
}

/// Documents that were checked with the file at a path.
void Session::check_dependents(const std::string& path) {
  const std::string normal = normalize_path(path);
  if (file_name(normal) == config::kConfigName) return files_changed();
  const std::string ending = extension(normal);
  if (ending == ".urdf" || ending == ".xacro") check_srdf_of(normal);
  for (const auto& [uri, check] : state_.checks) {
    const auto document = state_.documents.find(uri);
    if (document == state_.documents.end() || normalize_path(document->second->path()) == normal)
      continue;
    if (!check.checked.asked_files.contains(normal)) continue;
    state_.checks[uri].forget();
    document->second->forget();
    check_later(uri);
  }
}

/// SRDFs that are open, when a robot or a part of one is changed.
void Session::check_srdf_of(const std::string& path) {
  state_.forget_robots(extension(path) == ".urdf" ? path : std::string());
  for (const auto& [uri, document] : state_.documents) {
    if (extension(document->path()) == ".srdf") check_later(uri);
  }
}

/// What changed last is checked first.
void Session::check_later(const std::string& uri) {
  for (std::vector<std::string>* list : {&to_prepare_, &to_check_}) {
    drop(*list, uri);
    list->push_back(uri);
  }
}

void Session::work() {
  if (to_check_.empty()) return;
  const std::string uri = std::move(to_check_.back());
  to_check_.pop_back();
  const auto found = state_.documents.find(uri);
  if (found == state_.documents.end()) return;
  OpenDocument& document = *found->second;
  state_.checked(document);
  drop(to_check_whole_, uri);
  if (!state_.checks[uri].is_whole) to_check_whole_.push_back(uri);
  if (peer_.is_superseded && peer_.is_superseded(uri)) return;
  publish(document);
}

void Session::idle_work() {
  if (to_prepare_.empty()) return;
  const auto found = state_.documents.find(to_prepare_.back());
  to_prepare_.pop_back();
  if (found == state_.documents.end()) return;
  found->second->prepare(state_.environment());
  state_.prepare_parts(*found->second);
}

void Session::open_meshes_later(const OpenDocument& document) {
  if (!is_checked(document.path(), document.text())) return;
  drop(to_open_meshes_, document.uri());
  to_open_meshes_.push_back(document.uri());
}

std::unique_ptr<BackgroundCheck> Session::background_check(std::vector<std::string>& of,
                                                           rules::MeshPolicy meshes) {
  while (!of.empty()) {
    const std::string uri = std::move(of.back());
    of.pop_back();
    const auto found = state_.documents.find(uri);
    if (found == state_.documents.end()) continue;
    const OpenDocument& document = *found->second;
    return std::make_unique<BackgroundCheck>(
        state_.real_disk, state_.disk.open_texts(), state_.paths, state_.worker, state_.knowledge,
        BackgroundDocument{uri, document.path(), document.version()}, meshes);
  }
  return nullptr;
}

std::unique_ptr<BackgroundCheck> Session::take_whole_check() {
  return background_check(to_check_whole_, rules::MeshPolicy::kLeaveOut);
}

std::unique_ptr<BackgroundCheck> Session::take_mesh_check() {
  return background_check(to_open_meshes_, rules::MeshPolicy::kOpen);
}

void Session::finish(BackgroundCheck& check) {
  const std::string& uri = check.document().uri;
  const auto found = state_.documents.find(uri);
  if (found == state_.documents.end()) return;
  OpenDocument& document = *found->second;
  const bool is_outdated = check.stopped() || check.document().version != document.version();
  if (is_outdated && check.opens_meshes()) return open_meshes_later(document);
  if (is_outdated) return check_later(uri);
  if (check.opens_meshes()) {
    mesh_findings_[uri] = MeshFindings(state_, document, check);
    state_.mesh_checks[uri] = {document.version(), check.take_with_meshes(), check.findings()};
  }
  State::LastCheck& last = state_.checks[uri];
  if (!check.opens_meshes() && last.version == document.version() && !last.is_whole) {
    last.checked = check.take_whole();
    last.prepared = check.take_parts();
    last.is_whole = true;
  }
  check_later(uri);  // nothing is sent when nothing is new
  ask_to_pull();
}

void Session::ask_to_pull() {
  if (!state_.client.pulls_diagnostics || !state_.client.refreshes_diagnostics) return;
  peer_.send({{"jsonrpc", "2.0"}, {"id", "refresh"}, {"method", "workspace/diagnostic/refresh"}});
}

std::map<std::string, std::vector<Json>> Session::findings_of(OpenDocument& document) {
  auto by_uri = diagnostics_by_uri(state_, document, state_.checked(document));
  const auto meshes = mesh_findings_.find(document.uri());
  if (meshes != mesh_findings_.end()) meshes->second.add_to(by_uri, document);
  return by_uri;
}

void Session::publish(OpenDocument& document) {
  publish_of_root(document.uri(), findings_of(document));
}

void Session::publish_of_root(const std::string& root,
                              std::map<std::string, std::vector<Json>> by_uri) {
  std::set<std::string> changed{root};  // whose version is new
  const auto& before = published_[root];
  for (const auto& [uri, list] : before) {
    if (!by_uri.contains(uri)) changed.insert(uri);
  }
  for (const auto& [uri, list] : by_uri) {
    const auto known = before.find(uri);
    if (known == before.end() || known->second != list) changed.insert(uri);
  }
  if (by_uri.empty()) {
    published_.erase(root);
  } else {
    published_[root] = std::move(by_uri);
  }
  if (state_.client.pulls_diagnostics) return;
  for (const std::string& uri : changed) publish_uri(uri);
}

/// Several robots may show the same of a file that they share.
void Session::publish_uri(const std::string& uri) {
  Json all = Json::array();
  std::set<std::string> known;
  for (const auto& [root, by_uri] : published_) {
    const auto list = by_uri.find(uri);
    if (list == by_uri.end()) continue;
    for (const Json& diagnostic : list->second) {
      if (known.insert(diagnostic_key(diagnostic)).second) all.push_back(diagnostic);
    }
  }
  Json params{{"uri", uri}};
  params["diagnostics"] = std::move(all);
  const auto document = state_.documents.find(uri);
  if (document != state_.documents.end()) params["version"] = document->second->version();
  Json& last = sent_[uri];
  if (last == params) return;
  last = params;
  Json message{{"jsonrpc", "2.0"}, {"method", "textDocument/publishDiagnostics"}};
  message["params"] = std::move(params);
  peer_.send(message);
}

Json Session::pulled_diagnostics(const Json& params) {
  OpenDocument& document = state_.document(params);
  if (!state_.client.refreshes_diagnostics) state_.checked_whole(document);
  auto by_uri = findings_of(document);
  Json related = Json::object();
  for (const auto& [uri, list] : by_uri) {
    if (uri != document.uri()) related[uri] = {{"kind", "full"}, {"items", list}};
  }
  Json report{{"kind", "full"}, {"items", by_uri[document.uri()]}};
  if (!related.empty()) report["relatedDocuments"] = std::move(related);
  return report;
}

}  // namespace rigor::lsp
