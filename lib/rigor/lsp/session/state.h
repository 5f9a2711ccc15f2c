// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a session knows: the client, the documents that are open, and the findings that were published.
//
// Requests are functions of it and of their parameters (answer/answers.h).

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/lsp/document/cached_disk.h>
#include <rigor/lsp/document/editor_disk.h>
#include <rigor/lsp/document/open_documents.h>
#include <rigor/lsp/project/check.h>
#include <rigor/lsp/project/part_check.h>
#include <rigor/lsp/project/project.h>
#include <rigor/lsp/protocol/json.h>
#include <rigor/robot/semantic/srdf_check.h>

namespace rigor::lsp {

/// Codes of JSON-RPC 2.0 and of the protocol.
enum class ErrorCode : int {
  kParseError = -32700,
  kInvalidRequest = -32600,
  kMethodNotFound = -32601,
  kInvalidParams = -32602,
  kInternalError = -32603,
  kServerNotInitialized = -32002,
  kRequestCancelled = -32800,
  kContentModified = -32801,
  kRequestFailed = -32803,
};

/// What ends a request without a result.
class RequestError : public std::runtime_error {
 public:
  RequestError(ErrorCode code, const std::string& message)
      : std::runtime_error(message), code_(code) {}
  ErrorCode code() const { return code_; }

 private:
  ErrorCode code_;
};

struct Client {
  PositionEncoding encoding = PositionEncoding::kUtf16;
  bool snippets = false;               ///< whether completions may have places to fill in
  bool document_changes = false;       ///< whether edits may name the versions of documents
  bool change_annotations = false;     ///< whether edits may say why, and be confirmed one by one
  bool creates_files = false;          ///< whether edits may make a file
  bool refreshes_diagnostics = false;  ///< whether it pulls them again when it is asked to
  bool pulls_diagnostics = false;      ///< then none are published
  bool registers_watchers = false;  ///< whether it takes the files that are to be watched from here
  bool shows_pictures = false;      ///< in hovers, as data: URIs
  std::vector<std::string> commands;  ///< of its own that lenses may call: "rigor.view"
  std::string rule_pages;             ///< base of the addresses of rules' pages; empty for no links
  std::vector<std::string> folders;   ///< of the workspace; normalized paths
};

struct State {
  State(const Disk& below, read::SearchPaths search_paths, std::string worker_path,
        std::shared_ptr<const Knowledge> known);
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  /// Forgets what was read from the disk.
  void renew_project();

  const Environment& environment() const { return project->environment(); }

  /// The open document that a request's `textDocument` names; a RequestError when none has that URI.
  OpenDocument& document(const Json& params);

  /// Of the document's text as it is now: checked anew unless the last check was of it. A change of a large document
  /// is checked in its part first (project/part_check.h); `is_whole` of the last check says so.
  const CheckedDocument& checked(OpenDocument& document);
  /// The same of all of the document.
  const CheckedDocument& checked_whole(OpenDocument& document);
  /// What is checked in parts: documents of at least so many bytes.
  std::size_t large_bytes = PartCheck::kLargeBytes;
  /// Before a document is changed: its last check becomes what the change is seen against.
  void keep_check(const OpenDocument& document);
  /// Does what `keep_check` would have to do.
  void prepare_parts(const OpenDocument& document);

  /// Robots that have the name, as the disk and the editor have them. `files` gives those of the workspace, and is
  /// asked once until files change.
  std::vector<const robot::SemanticTarget*> robots_named(
      const std::string& name, const std::function<std::vector<std::string>()>& files);
  /// Forgets what is known of the robot in a file; of all, and where they are, when the path is empty.
  void forget_robots(const std::string& path = {});

  const Disk& real_disk;  ///< for other threads
  CachedDisk cached_disk;
  EditorDisk disk;  ///< above the cached one
  read::SearchPaths paths;
  std::string worker;
  std::shared_ptr<const Knowledge> knowledge;
  std::unique_ptr<Project> project;
  Client client;
  std::map<std::string, std::unique_ptr<OpenDocument>, std::less<>> documents;  ///< by URI

  /// The last check of each document that is open, by URI, and the version that was checked.
  struct LastCheck {
    std::int64_t version = -1;
    CheckedDocument checked;
    bool is_whole = false;  ///< else with what is known of other parts than the changed one
    std::optional<PartCheck> prepared;  ///< of the text that was checked, if all of it was
    std::optional<PartCheck> parts;     ///< of an earlier text that was well-formed
    /// Before the last change, when only a part was checked.
    struct Before {
      std::string text;
      CheckedDocument checked;
    };
    std::optional<Before> before;

    /// Nothing that was found holds any more.
    void forget() {
      version = -1;
      prepared.reset();
      parts.reset();
      before.reset();
    }
  };
  std::map<std::string, LastCheck, std::less<>> checks;

  /// A check with the meshes opened, and what only that finds.
  struct MeshCheck {
    std::int64_t version = -1;
    CheckedDocument checked;
    std::vector<Diagnostic> findings;
  };
  std::map<std::string, MeshCheck, std::less<>> mesh_checks;  ///< the last of each, by URI
  /// That of the document's text as it is now; null when there is none.
  const MeshCheck* mesh_check(const OpenDocument& document) const;

 private:
  std::optional<CheckedDocument> checked_in_part(LastCheck& last, const OpenDocument& document);

  std::optional<std::multimap<std::string, std::string>> robot_paths_;  // by robot's name
  std::map<std::string, robot::SemanticTarget> robots_;                 // by path
};

/// `position` of a request as a byte offset in the document.
std::uint32_t offset_in(const OpenDocument& document, const Json& position);
Json position_json(TextPosition position);
Json range_json(const LineIndex& lines, std::uint32_t begin, std::uint32_t end);
inline Json range_json(const LineIndex& lines, Span span) {
  return range_json(lines, span.begin, span.end);
}

/// Spans of a run as places of the protocol.
class PlacesJson {
 public:
  PlacesJson(const Sources& sources, PositionEncoding encoding)
      : sources_(sources), encoding_(encoding) {}

  Json range(Span span) { return range_json(lines(span.source), span); }
  /// With the URI of the file.
  Json location(Span span);
  const std::string& uri(Span span);

 private:
  const LineIndex& lines(SourceId source);

  const Sources& sources_;
  PositionEncoding encoding_;
  std::map<SourceId, LineIndex> lines_;
  std::map<SourceId, std::string> uris_;
};

}  // namespace rigor::lsp
