// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The findings of a document that take a look into mesh files, found in the background: meshes are never opened while
// somebody types.
//
//   MeshCheck check(below, disk.open_texts(), paths, worker, uri, path);
//   std::thread thread([&] { check.run(); });
//   … a key: check.stop(); thread.join();
//   if (!check.stopped()) keep(check.findings());

#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include <rigor/lsp/document/editor_disk.h>
#include <rigor/lsp/document/stoppable_disk.h>
#include <rigor/lsp/project/check.h>
#include <rigor/read/resolver.h>

namespace rigor::lsp {

class MeshCheck {
 public:
  /// Of a document that is among the open texts. `below` is the disk below them, and outlives it.
  MeshCheck(const Disk& below, OpenTexts texts, read::SearchPaths paths, std::string worker,
            std::string uri, std::string path);
  MeshCheck(const MeshCheck&) = delete;
  MeshCheck& operator=(const MeshCheck&) = delete;

  /// On any thread, once.
  void run();

  /// From any thread: makes `run` come to an end soon, with findings that are of no use.
  void stop() { disk_.stop(); }
  bool stopped() const { return disk_.stopped(); }

  const std::string& uri() const { return uri_; }
  const std::string& path() const { return path_; }

  /// After `run`: what is found only with the meshes opened; spans are of `sources()`.
  const std::vector<Diagnostic>& findings() const { return findings_; }
  const Sources& sources() const { return *checked_.sources; }

 private:
  StoppableDisk disk_;
  OpenTexts texts_;
  read::SearchPaths paths_;
  std::string worker_;
  std::string uri_;
  std::string path_;
  CheckedDocument checked_;
  std::vector<Diagnostic> findings_;
};

}  // namespace rigor::lsp
