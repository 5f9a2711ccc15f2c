// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The findings of a document that take longer than a person should wait for a key: those of all of a large one, and
// those that take a look into mesh files, which are never opened while somebody types.
//
//   BackgroundCheck check(below, disk.open_texts(), paths, worker, knowledge, document, rules::MeshPolicy::kOpen);
//   std::thread thread([&] { check.run(); });
//   … a key: check.stop(); thread.join();
//   if (!check.stopped()) keep(check.findings());

#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <rigor/lsp/document/editor_disk.h>
#include <rigor/lsp/document/stoppable_disk.h>
#include <rigor/lsp/project/check.h>
#include <rigor/lsp/project/part_check.h>
#include <rigor/read/resolver.h>

namespace rigor::lsp {

/// One that is among the open texts.
struct BackgroundDocument {
  std::string uri;
  std::string path;
  std::int64_t version = 0;
};

class BackgroundCheck {
 public:
  /// `below` is the disk below the open texts, and outlives it.
  BackgroundCheck(const Disk& below, OpenTexts texts, read::SearchPaths paths, std::string worker,
                  std::shared_ptr<const Knowledge> knowledge, BackgroundDocument document,
                  rules::MeshPolicy meshes);
  BackgroundCheck(const BackgroundCheck&) = delete;
  BackgroundCheck& operator=(const BackgroundCheck&) = delete;

  /// On any thread, once.
  void run();

  /// From any thread: makes `run` come to an end soon, with findings that are of no use.
  void stop() { disk_.stop(); }
  bool stopped() const { return disk_.stopped(); }

  const BackgroundDocument& document() const { return document_; }
  bool opens_meshes() const { return meshes_ == rules::MeshPolicy::kOpen; }

  /// After `run`, once: the check without the meshes; and the parts of a document that is worth it.
  CheckedDocument take_whole() { return std::move(whole_); }
  std::optional<PartCheck> take_parts() { return std::move(parts_); }

  /// After `run`: what is found only with the meshes opened; spans are of `sources()`.
  const std::vector<Diagnostic>& findings() const { return findings_; }
  const Sources& sources() const { return *checked_.sources; }
  /// The check with them, once; `sources()` go along.
  CheckedDocument take_with_meshes() { return std::move(checked_); }

 private:
  StoppableDisk disk_;
  OpenTexts texts_;
  read::SearchPaths paths_;
  std::string worker_;
  std::shared_ptr<const Knowledge> knowledge_;
  BackgroundDocument document_;
  rules::MeshPolicy meshes_;
  CheckedDocument whole_;
  std::optional<PartCheck> parts_;
  CheckedDocument checked_;  // with the meshes
  std::vector<Diagnostic> findings_;
};

}  // namespace rigor::lsp
