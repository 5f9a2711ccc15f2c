// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a computation asked of a disk, and what it was told: as long as the disk would say the same
// again, so would the computation.
//
//   const WitnessDisk asked(disk, path);           // used in place of it
//   const Facts facts = look_at(asked, path);
//   ...
//   if (still_so(disk, asked.witnesses())) reuse(facts);

#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <rigor/text/digest.h>
#include <rigor/text/disk.h>

namespace rigor {

/// A question about one path and its answer.
struct Witness {
  enum class Question : std::uint8_t {
    kKind,
    kContent,  ///< all bytes of a file, or why there are none
    kList
  };
  Question question = Question::kKind;
  std::string path = {};
  Digest answer = {};
};

/// The digest of a file's bytes, and nothing when it cannot be opened: for who knows some already.
using ContentDigest =
    std::function<std::optional<Digest>(const Disk& disk, const std::string& path)>;

/// By reading all of them.
std::optional<Digest> read_digest(const Disk& disk, const std::string& path);

/// Whether all of them have the same answers now.
bool still_so(const Disk& disk, const std::vector<Witness>& witnesses,
              const ContentDigest& digest = read_digest);

/// The disk behind it. For use by one thread; open files are as safe as the disk's own.
class WitnessDisk final : public Disk {
 public:
  /// What is asked about `known` is not kept.
  WitnessDisk(const Disk& disk, std::string known, ContentDigest digest = read_digest)
      : disk_(disk), known_(std::move(known)), digest_(std::move(digest)) {}

  std::unique_ptr<OpenFile> open(const std::string& path) const override;
  ReadResult read(const std::string& path, std::uint64_t max_bytes) const override;
  PathKind kind(const std::string& path) const override;
  std::vector<std::string> list(const std::string& folder) const override;
  // What a folder or a link is tells its kind or its list as well: not kept.
  std::string obstacle(const std::string& path) const override { return disk_.obstacle(path); }

  /// Each question once, by kinds of questions, then by paths.
  std::vector<Witness> witnesses() const;

 private:
  void keep(Witness::Question question, const std::string& path) const;

  const Disk& disk_;
  std::string known_;
  ContentDigest digest_;
  mutable std::map<std::pair<Witness::Question, std::string>, Digest> answers_;
};

}  // namespace rigor
