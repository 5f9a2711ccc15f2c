// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A record as bytes: a word that says what it is, the fields in their order, and the digest of both.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include <rigor/simulate/archive.h>
#include <rigor/simulate/run.h>
#include <rigor/text/digest.h>

namespace rigor::simulate {
namespace {

constexpr std::string_view kRecordWord = "rigrec02";

struct RecordFields {
  template <class Archive, class T>
  static void visit(Archive& archive, T& whole) {
    using Kind = std::remove_const_t<T>;
    if constexpr (std::is_same_v<Kind, Peak>) {
      auto& [value, of, at] = whole;
      archive(value, of, at);
    } else if constexpr (std::is_same_v<Kind, SupportPoint>) {
      auto& [model, point] = whole;
      archive(model, point);
    } else if constexpr (std::is_same_v<Kind, ContactState>) {
      auto& [shape_a, shape_b, point, normal, depth, force] = whole;
      archive(shape_a, shape_b, point, normal, depth, force);
    } else if constexpr (std::is_same_v<Kind, State>) {
      auto& [time, bodies, axes, contacts, anchor_error, anchor_joint, motor_work] = whole;
      archive(time, bodies, axes, contacts, anchor_error, anchor_joint, motor_work);
    } else if constexpr (std::is_same_v<Kind, PhaseMeasures>) {
      auto& [steps, speed, residual, acceleration, energy, tilt, anchor_error, limit_violation,
             penetration, sunk, self_contact, self_contact_with, tipped, contact_changes,
             ground_force, vertical_square, yaw_path, jitter_square, axis_min, axis_max, axis_begin,
             axis_end, axis_path, axis_effort, begin, end] = whole;
      archive(steps, speed, residual, acceleration, energy, tilt, anchor_error, limit_violation,
              penetration, sunk, self_contact, self_contact_with, tipped, contact_changes,
              ground_force, vertical_square, yaw_path, jitter_square, axis_min, axis_max,
              axis_begin, axis_end, axis_path, axis_effort, begin, end);
    } else if constexpr (std::is_same_v<Kind, Measures>) {
      auto& [phases, spawn_penetration, spawn_overlap, spawn_overlap_with, settle_time, support] =
          whole;
      archive(phases, spawn_penetration, spawn_overlap, spawn_overlap_with, settle_time, support);
    } else {
      static_assert(std::is_same_v<Kind, Record>);
      auto& [end, message, end_time, steps, solver_messages, culprit, times, link_poses,
             axis_values, measures, final, state_hash] = whole;
      archive(end, message, end_time, steps, solver_messages, culprit, times, link_poses,
              axis_values, measures, final, state_hash);
    }
  }
};

}  // namespace

std::string encode(const Record& record) {
  ArchiveWriter<RecordFields> writer{std::string(kRecordWord)};
  writer(record);
  const Digest digest = digest_of(writer.bytes);
  return std::move(writer.bytes) + std::string(digest_bytes(digest));
}

std::optional<Record> decode(std::string_view bytes) {
  constexpr std::size_t kDigest = sizeof(Digest);
  if (bytes.size() < kRecordWord.size() + kDigest) return std::nullopt;
  const std::string_view text = bytes.substr(0, bytes.size() - kDigest);
  if (text.substr(0, kRecordWord.size()) != kRecordWord) return std::nullopt;
  const Digest digest = digest_of(text);
  if (digest_bytes(digest) != bytes.substr(text.size())) return std::nullopt;
  ArchiveReader<RecordFields> reader(text.substr(kRecordWord.size()));
  Record record;
  reader(record);
  if (!reader.done() || record.end > Record::End::kOutOfTime) return std::nullopt;
  return record;
}

}  // namespace rigor::simulate
