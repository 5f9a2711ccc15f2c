// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/asset/file_reference.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <memory>
#include <optional>
#include <utility>

#include <rigor/mesh/image/picture.h>
#include <rigor/text/other_case.h>
#include <rigor/text/path.h>

namespace rigor::mesh {
namespace {

using State = FileReference::State;

constexpr std::size_t kMaxWritten = 1024;

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// Of `model://a`, `model`; empty without one. A single letter is a drive of Windows.
std::string_view scheme_of(std::string_view written) {
  const std::size_t colon = written.find(':');
  if (colon == std::string_view::npos || colon < 2) return {};
  const std::string_view scheme = written.substr(0, colon);
  const bool letters = std::all_of(scheme.begin(), scheme.end(), [](char c) {
    return is_letter(c) || (c >= '0' && c <= '9') || c == '+' || c == '-' || c == '.';
  });
  return letters ? scheme : std::string_view();
}

bool is_of_one_machine(std::string_view written) {
  const bool drive = written.size() > 1 && is_letter(written[0]) && written[1] == ':';
  return drive || is_absolute(written) || written.starts_with('\\') || scheme_of(written) == "file";
}

class Finder {
 public:
  Finder(const Disk& disk, std::string_view folder) : disk_(disk), folder_(folder) {}

  void find(FileReference& reference, const std::string& written) const {
    reference.path = join_path(folder_, written);
    reference.state = State::kMissing;
    for (const std::string& name : {written, percent_decoded(written)}) {
      if (look(reference, name, State::kFound)) return;
    }
    std::string slashes = written;
    std::replace(slashes.begin(), slashes.end(), '\\', '/');
    if (slashes != written && look(reference, slashes, State::kBackslash)) return;
    if (look(reference, "../materials/textures/" + written, State::kTextures)) return;
    std::string other = OtherCase(disk_).find(reference.path);
    if (other.empty()) return;
    reference.path = std::move(other);
    reference.state = State::kWrongCase;
  }

 private:
  bool look(FileReference& reference, const std::string& name, State state) const {
    const std::string path = join_path(folder_, name);
    if (disk_.kind(path) != PathKind::kFile) return false;
    reference.path = path;
    reference.state = state;
    return true;
  }

  const Disk& disk_;
  std::string_view folder_;
};

}  // namespace

std::string percent_decoded(std::string_view written) {
  std::string text;
  for (std::size_t i = 0; i < written.size(); ++i) {
    unsigned char byte = 0;
    const char* const digits = written.data() + i + 1;
    const bool whole = written[i] == '%' && i + 2 < written.size() &&
                       std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2;
    text += whole ? static_cast<char>(byte) : written[i];
    if (whole) i += 2;
  }
  return text;
}

bool is_there(const FileReference& reference) {
  return reference.state == State::kFound || reference.state == State::kWrongCase ||
         reference.state == State::kBackslash || reference.state == State::kTextures;
}

FileReference resolve(const Disk& disk, const std::string& file, std::string_view written,
                      std::uint64_t line) {
  FileReference reference{.written = std::string(written.substr(0, kMaxWritten)), .line = line};
  if (written.empty()) return reference;
  if (is_of_one_machine(written)) {
    reference.state = State::kAbsolute;
  } else if (const std::string_view scheme = scheme_of(written); !scheme.empty()) {
    reference.state = scheme == "data" ? State::kEmbedded : State::kUrl;
  } else if (written.size() > kMaxWritten) {
    reference.state = State::kMissing;  // no file has such a name
  } else {
    Finder(disk, parent_path(file)).find(reference, reference.written);
  }
  if (!is_there(reference)) return reference;
  const std::unique_ptr<OpenFile> found = disk.open(reference.path);
  if (!found) return reference;
  reference.bytes = found->size();
  const PictureSize size = picture_size(*found);
  reference.width = size.width;
  reference.height = size.height;
  return reference;
}

}  // namespace rigor::mesh
