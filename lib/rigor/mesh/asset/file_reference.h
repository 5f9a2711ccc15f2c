// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Another file that a mesh file names: a texture, a library of materials, a buffer. Whether it is
// there is asked of the disk; files behind an absolute path are never asked for, since the answer
// would be about this machine.
//
//   FileReference texture = resolve(disk, "meshes/arm.dae", "../textures/Wood.png", line);
//   if (texture.state == FileReference::State::kWrongCase) propose(texture.path);

#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <rigor/text/disk.h>

namespace rigor::mesh {

struct FileReference {
  enum class State : std::uint8_t {
    kFound,
    kMissing,
    kWrongCase,  ///< `path` is there, which differs in the case of letters of its last part
    kBackslash,  ///< `path` is there, which has `/` where `\` is written
    kTextures,   ///< `path` is there, in ../materials/textures, where of all consumers Gazebo looks
    kAbsolute,   ///< a path, drive or file: URL of one machine
    kUrl,        ///< of another scheme, such as model: or https:
    kEmbedded,   ///< a data: URL, which holds the file
    kUndefined,  ///< no file at all: an id that nothing has, or an element without a name
  };

  std::string written = {};  ///< as the file says it, the first 1,024 bytes
  std::string path = {};     ///< seen from where the file is seen from; empty when not looked for
  State state = State::kUndefined;
  std::string from = {};   ///< the file that names it, when that is not the mesh: an .mtl
  std::uint64_t line = 0;  ///< 1-based in a text format; else 0
  std::uint64_t bytes = 0;
  std::uint32_t width = 0;  ///< in pixels, of a PNG or JPEG; else 0
  std::uint32_t height = 0;
};

/// With each %xx as the byte that it represents (RFC 3986, 2.1).
std::string percent_decoded(std::string_view written);

/// Whether there is a file at `path`.
bool is_there(const FileReference& reference);

/// `file` is the one that names it. `%20` and the like are looked for as they are, then decoded.
FileReference resolve(const Disk& disk, const std::string& file, std::string_view written,
                      std::uint64_t line);

}  // namespace rigor::mesh
