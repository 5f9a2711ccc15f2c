// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A record as bytes: a word that says what it is, the fields in their order, and the digest of both.
// One list of fields a struct serves both ways; its structured binding does not compile when a field of
// the struct is missing in it.

#include <cstddef>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <rigor/simulate/run.h>
#include <rigor/text/digest.h>

namespace rigor::simulate {
namespace {

constexpr std::string_view kRecordWord = "rigrec02";

/// Copied as they are: they have no gaps between their members.
template <class T>
constexpr bool kRecordPlain =
    std::has_unique_object_representations_v<T> || std::is_same_v<T, double> ||
    std::is_same_v<T, Vector3> || std::is_same_v<T, Quaternion> || std::is_same_v<T, Pose> ||
    std::is_same_v<T, BodyState> || std::is_same_v<T, AxisState>;

template <class T>
struct IsRecordVector : std::false_type {};
template <class T>
struct IsRecordVector<std::vector<T>> : std::true_type {};

template <class Archive, class T>
void record_fields(Archive& archive, T& whole) {
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
           ground_force, vertical_square, yaw_path, jitter_square, axis_least, axis_most,
           axis_begin, axis_end, axis_path, axis_effort, begin, end] = whole;
    archive(steps, speed, residual, acceleration, energy, tilt, anchor_error, limit_violation,
            penetration, sunk, self_contact, self_contact_with, tipped, contact_changes,
            ground_force, vertical_square, yaw_path, jitter_square, axis_least, axis_most,
            axis_begin, axis_end, axis_path, axis_effort, begin, end);
  } else if constexpr (std::is_same_v<Kind, Measures>) {
    auto& [phases, spawn_penetration, spawn_overlap, spawn_overlap_with, settle_time, support] =
        whole;
    archive(phases, spawn_penetration, spawn_overlap, spawn_overlap_with, settle_time, support);
  } else {
    static_assert(std::is_same_v<Kind, Record>);
    auto& [end, message, end_time, steps, solver_messages, culprit, times, link_poses, axis_values,
           measures, final, state_hash] = whole;
    archive(end, message, end_time, steps, solver_messages, culprit, times, link_poses, axis_values,
            measures, final, state_hash);
  }
}

class RecordWriter {
 public:
  template <class... T>
  void operator()(const T&... values) {
    (put(values), ...);
  }

  std::string bytes{kRecordWord};

 private:
  void copy(const void* from, std::size_t size) {
    bytes.append(static_cast<const char*>(from), size);
  }

  template <class T>
  void put(const T& value) {
    if constexpr (std::is_same_v<T, std::string>) {
      put(std::uint64_t{value.size()});
      bytes += value;
    } else if constexpr (IsRecordVector<T>::value) {
      put(std::uint64_t{value.size()});
      if constexpr (kRecordPlain<typename T::value_type>) {
        copy(value.data(), value.size() * sizeof(typename T::value_type));
      } else {
        for (const auto& element : value) put(element);
      }
    } else if constexpr (kRecordPlain<T>) {
      copy(&value, sizeof value);
    } else {
      record_fields(*this, value);
    }
  }
};

/// Once something does not fit, nothing more is read.
class RecordReader {
 public:
  explicit RecordReader(std::string_view bytes) : rest_(bytes) {}

  template <class... T>
  void operator()(T&... values) {
    (get(values), ...);
  }

  bool done() const { return sound_ && rest_.empty(); }

 private:
  void copy(void* to, std::size_t size) {
    if (size > rest_.size()) sound_ = false;
    if (!sound_ || size == 0) return;
    std::memcpy(to, rest_.data(), size);
    rest_.remove_prefix(size);
  }

  /// Of elements that take a byte each at least.
  std::size_t size() {
    std::uint64_t wanted = 0;
    get(wanted);
    if (wanted > rest_.size()) sound_ = false;
    return sound_ ? static_cast<std::size_t>(wanted) : 0;
  }

  template <class T>
  void get(T& value) {
    if constexpr (std::is_same_v<T, std::string>) {
      value.resize(size());
      copy(value.data(), value.size());
    } else if constexpr (IsRecordVector<T>::value) {
      using Element = typename T::value_type;
      const std::size_t count = size();
      if constexpr (kRecordPlain<Element>) {
        if (count > rest_.size() / sizeof(Element)) sound_ = false;
        if (!sound_) return;
        value.resize(count);
        copy(value.data(), count * sizeof(Element));
      } else {
        for (std::size_t i = 0; i < count && sound_; ++i) get(value.emplace_back());
      }
    } else if constexpr (kRecordPlain<T>) {
      copy(&value, sizeof value);
    } else {
      record_fields(*this, value);
    }
  }

  std::string_view rest_;
  bool sound_ = true;
};

}  // namespace

std::string encode(const Record& record) {
  RecordWriter writer;
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
  RecordReader reader(text.substr(kRecordWord.size()));
  Record record;
  reader(record);
  if (!reader.done() || record.end > Record::End::kOutOfTime) return std::nullopt;
  return record;
}

}  // namespace rigor::simulate
