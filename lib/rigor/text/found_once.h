// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What takes long to find and is asked for often: found once for each key, by the first request, while
// others who ask for the same wait and those who ask for something else do not.
//
//   FoundOnce<std::string, Survey> known;
//   const Survey& survey = known.find(path, [&] { return survey_mesh(path); });

#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>

#include <rigor/text/turns.h>

namespace rigor {

template <class Key, class Value>
class FoundOnce {
 public:
  /// With turns, those who ask are their workers: one who waits lets others work.
  explicit FoundOnce(Turns* turns = nullptr) : turns_(turns) {}

  /// The reference stays valid as long as this. Safe across threads; `make` may ask for other keys. When it
  /// throws, the next who asks makes it.
  template <class Make>
  const Value& find(const Key& key, const Make& make) {
    Entry& entry = entry_of(key);
    const std::unique_lock lock =
        turns_ ? turns_->lock(entry.mutex) : std::unique_lock(entry.mutex);
    if (!entry.value) entry.value.emplace(make());
    return *entry.value;
  }

 private:
  struct Entry {
    std::mutex mutex;
    std::optional<Value> value;
  };

  Entry& entry_of(const Key& key) {
    const std::lock_guard lock(mutex_);
    std::unique_ptr<Entry>& entry = entries_[key];
    if (!entry) entry = std::make_unique<Entry>();
    return *entry;
  }

  Turns* turns_;
  std::mutex mutex_;
  std::map<Key, std::unique_ptr<Entry>> entries_;
};

}  // namespace rigor
