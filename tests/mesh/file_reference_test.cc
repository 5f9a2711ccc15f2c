// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/asset/file_reference.h>

#include <string>
#include <utility>

#include <gtest/gtest.h>

namespace rigor::mesh {
namespace {

using State = FileReference::State;

/// The 24 bytes that a PNG of this size begins with.
std::string png_bytes(unsigned char width, unsigned char height) {
  std::string bytes("\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\0\0\0\0\0\0\0\0", 24);
  bytes[19] = static_cast<char>(width);
  bytes[23] = static_cast<char>(height);
  return bytes;
}

FileReference resolved(const std::string& written) {
  const MemoryDisk disk({{"bot/meshes/a.dae", ""},
                         {"bot/meshes/skin.png", png_bytes(4, 2)},
                         {"bot/meshes/dark wood.png", ""},
                         {"bot/meshes/sub/x.png", ""},
                         {"bot/materials/textures/bark.png", ""},
                         {"bot/textures/Oak.png", "0123456789"}});
  return resolve(disk, "bot/meshes/a.dae", written, 7);
}

struct Naming {
  const char* written;
  State state;
  const char* path;
};

class MeshFileReference : public testing::TestWithParam<Naming> {};

TEST_P(MeshFileReference, IsFoundOrNot) {
  const FileReference found = resolved(GetParam().written);
  EXPECT_EQ(found.state, GetParam().state);
  EXPECT_EQ(found.path, GetParam().path);
  EXPECT_EQ(found.written, GetParam().written);
  EXPECT_EQ(found.line, 7U);
}

INSTANTIATE_TEST_SUITE_P(
    All, MeshFileReference,
    testing::Values(Naming{"skin.png", State::kFound, "bot/meshes/skin.png"},
                    Naming{"./skin.png", State::kFound, "bot/meshes/skin.png"},
                    Naming{"../textures/Oak.png", State::kFound, "bot/textures/Oak.png"},
                    Naming{"dark wood.png", State::kFound, "bot/meshes/dark wood.png"},
                    Naming{"dark%20wood.png", State::kFound, "bot/meshes/dark wood.png"},
                    Naming{"dark%2", State::kMissing, "bot/meshes/dark%2"},
                    Naming{"sub", State::kMissing, "bot/meshes/sub"},
                    Naming{"bark.jpg", State::kMissing, "bot/meshes/bark.jpg"},
                    Naming{"bark.png", State::kTextures, "bot/materials/textures/bark.png"},
                    Naming{"sub\\x.png", State::kBackslash, "bot/meshes/sub/x.png"},
                    Naming{"../textures/oak.PNG", State::kWrongCase, "bot/textures/Oak.png"},
                    Naming{"/bot/meshes/skin.png", State::kAbsolute, ""},
                    Naming{"C:\\art\\skin.png", State::kAbsolute, ""},
                    Naming{"file:///art/skin.png", State::kAbsolute, ""},
                    Naming{"model://bot/skin.png", State::kUrl, ""},
                    Naming{"https://a.org/skin.png", State::kUrl, ""},
                    Naming{"data:image/png;base64,AAAA", State::kEmbedded, ""},
                    Naming{"", State::kUndefined, ""}));

TEST(MeshFileReference, SizesOfWhatIsThere) {
  EXPECT_EQ(resolved("../textures/Oak.png").bytes, 10U);
  EXPECT_EQ(resolved("../textures/Oak.png").width, 0U) << "it is no picture";
  EXPECT_EQ(resolved("skin.png").bytes, 24U);
  EXPECT_EQ(resolved("skin.png").width, 4U);
  EXPECT_EQ(resolved("skin.png").height, 2U);
}

TEST(MeshFileReference, LongNamesAreCut) {
  const std::string name(5000, 'a');
  EXPECT_EQ(resolved(name).state, State::kMissing);
  EXPECT_LT(resolved(name).written.size(), name.size());
}

FileReference jpeg_reference(std::string bytes) {
  return resolve(MemoryDisk({{"a.jpg", std::move(bytes)}}), "a.dae", "a.jpg", 1);
}

TEST(MeshFileReference, SizeOfAJpegStandsInItsFrame) {
  // A segment of 4 bytes whose content looks like a frame, a fill byte, a table, then the frame.
  const std::string begin("\xFF\xD8\xFF\xE0\x00\x04\xFF\xC0\xFF\xFF\xC4\x00\x03z", 14);
  const std::string frame("\xFF\xC2\x00\x0B\x08\x01\x02\x03\x04\x01\x00", 11);
  EXPECT_EQ(jpeg_reference(begin + frame).width, 0x304U);
  EXPECT_EQ(jpeg_reference(begin + frame).height, 0x102U);
  for (std::size_t size = 0; size < begin.size() + 9; ++size) {
    EXPECT_EQ(jpeg_reference((begin + frame).substr(0, size)).width, 0U) << size;
  }
}

}  // namespace
}  // namespace rigor::mesh
