// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/lsp/session/state.h>

#include <utility>

#include <rigor/lsp/protocol/uri.h>
#include <rigor/read/srdf/robot_name.h>
#include <rigor/text/path.h>

namespace rigor::lsp {

State::State(const Disk& below, read::SearchPaths search_paths, std::string worker_path,
             std::shared_ptr<const Knowledge> known)
    : real_disk(below),
      cached_disk(below),
      disk(cached_disk),
      paths(std::move(search_paths)),
      worker(std::move(worker_path)),
      knowledge(std::move(known)) {
  renew_project();
}

void State::renew_project() {
  cached_disk.forget();
  for (auto& [uri, document] : documents) document->forget();
  for (auto& [uri, check] : checks) check.forget();
  forget_robots();
  project = std::make_unique<Project>(disk, paths, worker, knowledge);
}

void State::forget_robots(const std::string& path) {
  if (!path.empty()) {
    robots_.erase(normalize_path(path));
    return;
  }
  robot_paths_.reset();
  robots_.clear();
}

std::vector<const robot::SemanticTarget*> State::robots_named(
    const std::string& name, const std::function<std::vector<std::string>()>& files) {
  if (!robot_paths_) {
    robot_paths_.emplace();
    for (const std::string& path : files()) {
      if (extension(path) != ".urdf" && extension(path) != ".xacro") continue;
      const ReadResult file = disk.read(path, read::kMaxModelBytes);
      if (file.bytes) robot_paths_->emplace(read::robot_name_in(*file.bytes), normalize_path(path));
    }
  }
  std::vector<const robot::SemanticTarget*> robots;
  const auto [begin, end] = robot_paths_->equal_range(name);
  for (auto each = begin; each != end; ++each) {
    auto known = robots_.find(each->second);
    if (known == robots_.end()) {
      const ReadResult read = disk.read(each->second, read::kMaxModelBytes);
      Analysis analysis(environment(), each->second, read.bytes.value_or(std::string()));
      known = robots_.emplace(each->second, robot::semantic_target(analysis.loaded().root)).first;
    }
    if (!known->second.links.empty()) robots.push_back(&known->second);
  }
  return robots;
}

OpenDocument& State::document(const Json& params) {
  const auto found = documents.find(text_at(params, "textDocument", "uri"));
  if (found == documents.end()) {
    throw RequestError(ErrorCode::kInvalidParams,
                       "the document is not open: " + text_at(params, "textDocument", "uri"));
  }
  return *found->second;
}

const CheckedDocument& State::checked(OpenDocument& document) {
  LastCheck& last = checks[document.uri()];
  if (last.version == document.version()) return last.checked;
  std::optional<CheckedDocument> part = checked_in_part(last, document);
  last.before.reset();
  if (!part) return checked_whole(document);
  last.checked = *std::move(part);
  last.is_whole = false;
  last.version = document.version();
  return last.checked;
}

/// Seen against a text of which all was checked; when that is too far from this one, against the text before.
std::optional<CheckedDocument> State::checked_in_part(LastCheck& last,
                                                      const OpenDocument& document) {
  if (last.parts) {
    if (auto part = last.parts->check(disk, *project, document.text())) return part;
  }
  if (!last.before) return std::nullopt;
  std::optional<PartCheck> parts = PartCheck::of(document.path(), last.before->text);
  if (!parts) return std::nullopt;
  parts->take(std::move(last.before->checked));
  last.parts = std::move(parts);
  return last.parts->check(disk, *project, document.text());
}

const CheckedDocument& State::checked_whole(OpenDocument& document) {
  LastCheck& last = checks[document.uri()];
  if (last.version == document.version() && last.is_whole) return last.checked;
  last.checked = {};
  if (is_checked(document.path(), document.text())) {
    last.checked = check(disk, *project, document.path(), rules::MeshPolicy::kLeaveOut);
  } else {
    last.checked.sources = std::make_unique<Sources>();
  }
  last.is_whole = true;
  last.version = document.version();
  return last.checked;
}

const State::MeshCheck* State::mesh_check(const OpenDocument& document) const {
  const auto found = mesh_checks.find(document.uri());
  const bool is_now = found != mesh_checks.end() && found->second.version == document.version();
  return is_now ? &found->second : nullptr;
}

void State::prepare_parts(const OpenDocument& document) {
  LastCheck& last = checks[document.uri()];
  if (last.prepared || !last.is_whole || last.version != document.version()) return;
  if (PartCheck::is_worth_it(document.path(), document.text(), last.checked, large_bytes))
    last.prepared = PartCheck::of(document.path(), document.text());
}

/// A text that is not well-formed has no parts: those of the last that was are kept.
void State::keep_check(const OpenDocument& document) {
  prepare_parts(document);
  LastCheck& last = checks[document.uri()];
  if (last.prepared && last.is_whole && last.version == document.version()) {
    last.prepared->take(std::move(last.checked));
    last.parts = std::move(last.prepared);
  } else if (!last.is_whole && last.version == document.version()) {
    last.before = {document.text(), std::move(last.checked)};
  }
  last.prepared.reset();
  last.version = -1;
}

std::uint32_t offset_in(const OpenDocument& document, const Json& position) {
  const auto coordinate = [&position](std::string_view name) {
    const std::int64_t number = number_at(position, name);
    return number < 0 ? 0U
                      : static_cast<std::uint32_t>(std::min<std::int64_t>(number, 0xffffffffLL));
  };
  return document.lines().offset({coordinate("line"), coordinate("character")});
}

// Member by member: a list in braces makes each a list of its own first, and there are thousands for each key.

Json position_json(TextPosition position) {
  Json json;
  json["line"] = position.line;
  json["character"] = position.character;
  return json;
}

Json range_json(const LineIndex& lines, std::uint32_t begin, std::uint32_t end) {
  Json json;
  json["start"] = position_json(lines.position(begin));
  json["end"] = position_json(lines.position(end));
  return json;
}

const LineIndex& PlacesJson::lines(SourceId source) {
  const auto found = lines_.find(source);
  if (found != lines_.end()) return found->second;
  return lines_.emplace(source, LineIndex(sources_.bytes(source), encoding_)).first->second;
}

const std::string& PlacesJson::uri(Span span) {
  const auto found = uris_.find(span.source);
  if (found != uris_.end()) return found->second;
  std::string uri = uri_of_path(normalize_path(sources_.path(span.source)));
  return uris_.emplace(span.source, std::move(uri)).first->second;
}

Json PlacesJson::location(Span span) {
  Json json;
  json["uri"] = uri(span);
  json["range"] = range(span);
  return json;
}

}  // namespace rigor::lsp
