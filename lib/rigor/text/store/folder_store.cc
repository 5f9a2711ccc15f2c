// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/text/store/folder_store.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <unistd.h>

#include <rigor/text/disk.h>
#include <rigor/text/write_all.h>

namespace rigor {
namespace {

namespace fs = std::filesystem;

// Other files in the folder are left alone.
constexpr std::string_view kEntryEnding = ".entry";

// What has more behind the ending an older rigor had not finished; one that still runs may be about to.
constexpr std::chrono::hours kAbandoned{1};

// What an entry begins with; the digest of key and bytes follows, then the bytes.
constexpr std::string_view kEntryMagic = "rigor2\n";

// A part of the store is listed by one of so many writes into it, which the key decides: at 256 files a listing
// takes half a millisecond, so a write some 15 µs more, whatever else goes on and without a common count.
constexpr unsigned kWritesPerListing = 32;

// Of its share: above the one a part is brought down to the other, so that many writes pass before more has to go,
// and those between two listings still fit.
constexpr std::size_t kFullEighths = 7;
constexpr std::size_t kKeptEighths = 6;

// However full a folder is, one write pays for no more than this. More is removed than is written between listings.
constexpr std::size_t kMaxListed = 384;
constexpr std::size_t kMaxRemoved = 64;

std::string entry_head(const Digest& key, std::string_view bytes) {
  Hasher hasher;
  hasher.add(digest_bytes(key));
  hasher.add(bytes);
  return std::string(kEntryMagic).append(digest_bytes(hasher.digest()));
}

/// A new file, never one that is there nor what a link leads to; -1 where there can be none.
int make_entry(const std::string& path) {
  constexpr int kTries = 3;  // without a folder; with what an earlier run left there; and in peace
  for (int i = 0; i < kTries; ++i) {
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
    if (file >= 0) return file;
    if (errno == EEXIST) {
      ::unlink(path.c_str());
    } else if (errno == ENOENT) {
      std::error_code error;
      fs::create_directories(fs::path(path).parent_path(), error);
    } else {
      break;
    }
  }
  return -1;
}

struct StoredEntry {
  fs::file_time_type time;
  fs::path path;
  std::uint64_t bytes = 0;
};

/// Entries in a folder; removes what was never finished.
std::vector<StoredEntry> entries_in(const std::string& folder) {
  std::vector<StoredEntry> entries;
  std::error_code end;
  for (fs::directory_iterator it(folder, end), last; !end && it != last; it.increment(end)) {
    const std::string name = it->path().filename().string();
    if (name.find(kEntryEnding) == std::string::npos) continue;
    std::error_code unknown;
    const fs::file_time_type time = it->last_write_time(unknown);
    const std::uint64_t bytes = unknown ? 0 : it->file_size(unknown);
    if (unknown) continue;
    if (name.ends_with(kEntryEnding)) {
      entries.push_back({time, it->path(), bytes});
    } else if (fs::file_time_type::clock::now() - time > kAbandoned) {
      fs::remove(it->path(), unknown);
    }
    if (entries.size() >= kMaxListed) break;
  }
  return entries;
}

/// The oldest go first. What another process removed meanwhile is gone as well.
void trim(std::vector<StoredEntry> entries, std::size_t max_count, std::uint64_t max_bytes) {
  std::size_t count = entries.size();
  std::uint64_t bytes = 0;
  for (const StoredEntry& entry : entries) bytes += entry.bytes;
  if (count <= max_count / 8 * kFullEighths && bytes <= max_bytes / 8 * kFullEighths) return;
  std::sort(entries.begin(), entries.end(), [](const StoredEntry& a, const StoredEntry& b) {
    return std::pair(a.time, a.path) < std::pair(b.time, b.path);
  });
  const std::size_t kept_count = max_count / 8 * kKeptEighths;
  const std::uint64_t kept_bytes = max_bytes / 8 * kKeptEighths;
  for (std::size_t i = 0; i < std::min(entries.size(), kMaxRemoved); ++i) {
    if (count <= kept_count && bytes <= kept_bytes) return;
    std::error_code ignored;
    fs::remove(entries[i].path, ignored);
    --count;
    bytes -= entries[i].bytes;
  }
}

}  // namespace

FolderStore::FolderStore(std::string folder, std::uint64_t max_bytes)
    : folder_(std::move(folder)), max_part_bytes_(max_bytes / kParts) {}

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
  if (entry.size() > std::min(kMaxEntryBytes, max_part_bytes_)) return;
  const std::string path = path_of(key);
  const int file = make_entry(path);
  if (file < 0) return;
  const bool written = write_all(file, entry) == 0;
  const bool closed = ::close(file) == 0;
  if (!written || !closed) {
    ::unlink(path.c_str());
    return;
  }
  // A large entry is worth a listing of its own.
  const bool large = entry.size() > max_part_bytes_ / (2 * kWritesPerListing);
  if (large || key[1] % kWritesPerListing == 0) make_room(key);
}

std::string FolderStore::part_of(const Digest& key) const {
  return folder_ + '/' + hex({static_cast<std::uint8_t>(key[0] % kParts)}).substr(0, 2);
}

std::string FolderStore::path_of(const Digest& key) const {
  return part_of(key) + '/' + hex(key).append(kEntryEnding);
}

void FolderStore::make_room(const Digest& key) const {
  trim(entries_in(part_of(key)), kMaxEntries / kParts, max_part_bytes_);
  // Before entries were kept in parts they were kept here.
  trim(entries_in(folder_), 0, 0);
}

}  // namespace rigor
