// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/text/folder_store.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <system_error>
#include <utility>
#include <vector>

#include <unistd.h>

#include <rigor/text/disk.h>

namespace rigor {
namespace {

namespace fs = std::filesystem;

// Other files in the folder are let be.
constexpr std::string_view kEntryEnding = ".entry";

// Behind the ending while it is written; what a run that was killed left behind is older than this.
constexpr std::string_view kUnfinished = ".XXXXXX";
constexpr std::chrono::hours kAbandoned{1};

// What an entry begins with; the digest of key and bytes follows, then the bytes.
constexpr std::string_view kEntryMagic = "rigor2\n";

std::string entry_head(const Digest& key, std::string_view bytes) {
  Hasher hasher;
  hasher.add(digest_bytes(key));
  hasher.add(bytes);
  return std::string(kEntryMagic).append(digest_bytes(hasher.digest()));
}

bool write_entry(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

struct StoredEntry {
  fs::file_time_type time;
  fs::path path;
  std::uint64_t bytes = 0;
};

std::vector<StoredEntry> newest_first(const std::string& folder) {
  std::vector<StoredEntry> entries;
  std::error_code end;
  for (fs::directory_iterator it(folder, end), last; !end && it != last; it.increment(end)) {
    const std::string name = it->path().filename().string();
    std::error_code unknown;
    const fs::file_time_type time = it->last_write_time(unknown);
    const std::uint64_t bytes = unknown ? 0 : it->file_size(unknown);
    if (unknown || name.find(kEntryEnding) == std::string::npos) continue;
    if (name.ends_with(kEntryEnding)) {
      entries.push_back({time, it->path(), bytes});
    } else if (fs::file_time_type::clock::now() - time > kAbandoned) {
      fs::remove(it->path(), unknown);
    }
  }
  std::sort(entries.begin(), entries.end(), [](const StoredEntry& a, const StoredEntry& b) {
    return std::pair(b.time, b.path) < std::pair(a.time, a.path);
  });
  return entries;
}

}  // namespace

struct FolderStore::Room {
  std::mutex mutex;
  bool known = false;
  std::uint64_t bytes = 0;
  std::size_t count = 0;
};

FolderStore::FolderStore(std::string folder, std::uint64_t max_bytes)
    : folder_(std::move(folder)), max_bytes_(max_bytes), room_(std::make_shared<Room>()) {}

std::optional<std::string> FolderStore::get(const Digest& key) const {
  std::optional<std::string> entry = RealDisk().read(path_of(key), kMaxEntryBytes).bytes;
  const std::size_t head = kEntryMagic.size() + key.size();
  if (!entry || entry->size() < head) return std::nullopt;
  if (!entry->starts_with(entry_head(key, std::string_view(*entry).substr(head))))
    return std::nullopt;
  entry->erase(0, head);
  return entry;
}

void FolderStore::put(const Digest& key, std::string_view bytes) const {
  const std::string entry = entry_head(key, bytes).append(bytes);
  if (entry.size() > std::min(kMaxEntryBytes, max_bytes_)) return;
  std::error_code error;
  fs::create_directories(folder_, error);
  std::string unfinished = path_of(key).append(kUnfinished);
  const int file = ::mkstemp(unfinished.data());
  if (file < 0) return;
  const bool written = write_entry(file, entry);
  const bool closed = ::close(file) == 0;
  if (!written || !closed || std::rename(unfinished.c_str(), path_of(key).c_str()) != 0) {
    ::unlink(unfinished.c_str());
    return;
  }
  make_room(entry.size());
}

std::string FolderStore::path_of(const Digest& key) const {
  return folder_ + '/' + hex(key).append(kEntryEnding);
}

void FolderStore::make_room(std::uint64_t added) const {
  const std::lock_guard lock(room_->mutex);
  room_->bytes += added;
  ++room_->count;
  if (room_->known && room_->count <= kMaxEntries && room_->bytes <= max_bytes_) return;
  room_->known = true;
  room_->bytes = 0;
  room_->count = 0;
  for (const StoredEntry& entry : newest_first(folder_)) {
    std::error_code ignored;
    const bool fits = room_->count < kMaxEntries && room_->bytes + entry.bytes <= max_bytes_;
    if (!fits) {
      fs::remove(entry.path, ignored);
      continue;
    }
    room_->bytes += entry.bytes;
    ++room_->count;
  }
}

}  // namespace rigor
