// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/text/witness.h>

#include <algorithm>
#include <memory>

namespace rigor {
namespace {

Digest answer_to(const Disk& disk, Witness::Question question, const std::string& path,
                 const ContentDigest& digest) {
  switch (question) {
    case Witness::Question::kContent:
      if (const std::optional<Digest> content = digest(disk, path)) return *content;
      return digest_of(disk.read(path, 0).problem);
    case Witness::Question::kList: {
      std::string names;
      for (const std::string& name : disk.list(path)) names += name + '\0';
      return digest_of(names);
    }
    case Witness::Question::kKind: break;
  }
  return {static_cast<std::uint8_t>(disk.kind(path))};
}

}  // namespace

std::optional<Digest> read_digest(const Disk& disk, const std::string& path) {
  const std::unique_ptr<OpenFile> file = disk.open(path);
  return file ? std::optional(digest_of(*file)) : std::nullopt;
}

bool still_so(const Disk& disk, const std::vector<Witness>& witnesses,
              const ContentDigest& digest) {
  return std::all_of(witnesses.begin(), witnesses.end(), [&](const Witness& witness) {
    return answer_to(disk, witness.question, witness.path, digest) == witness.answer;
  });
}

std::unique_ptr<OpenFile> WitnessDisk::open(const std::string& path) const {
  keep(Witness::Question::kContent, path);
  return disk_.open(path);
}

ReadResult WitnessDisk::read(const std::string& path, std::uint64_t max_bytes) const {
  keep(Witness::Question::kContent, path);
  return disk_.read(path, max_bytes);
}

PathKind WitnessDisk::kind(const std::string& path) const {
  keep(Witness::Question::kKind, path);
  return disk_.kind(path);
}

std::vector<std::string> WitnessDisk::list(const std::string& folder) const {
  keep(Witness::Question::kList, folder);
  return disk_.list(folder);
}

std::vector<Witness> WitnessDisk::witnesses() const {
  std::vector<Witness> witnesses;
  for (const auto& [asked, answer] : answers_)
    witnesses.push_back({asked.first, asked.second, answer});
  return witnesses;
}

/// Before the computation hears it: what changes in between is seen when it is asked again.
void WitnessDisk::keep(Witness::Question question, const std::string& path) const {
  if (path == known_ || answers_.contains({question, path})) return;
  answers_[{question, path}] = answer_to(disk_, question, path, digest_);
}

}  // namespace rigor
