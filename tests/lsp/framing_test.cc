// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/lsp/protocol/framing.h>

#include <gtest/gtest.h>

#include <rigor/lsp/protocol/json.h>
#include <rigor/lsp/protocol/uri.h>

namespace rigor::lsp {
namespace {

TEST(LspFraming, AMessageComesInAnyPieces) {
  const std::string stream =
      "Content-Length: 2\r\n\r\n{}Content-Type: application/vscode-jsonrpc; "
      "charset=utf-8\r\ncontent-length:  4\r\n\r\n[1,2";
  FrameReader reader;
  std::vector<std::string> bodies;
  for (const char byte : stream) {
    reader.add(std::string_view(&byte, 1));
    while (const auto body = reader.next()) bodies.push_back(*body);
  }
  EXPECT_EQ(bodies, (std::vector<std::string>{"{}", "[1,2"}));
  EXPECT_FALSE(reader.broken());
}

TEST(LspFraming, AHeaderWithoutLengthBreaksTheStream) {
  for (const std::string header :
       {"Content-Type: x\r\n\r\n", "Content-Length: -1\r\n\r\n",
        "Content-Length: 99999999999999\r\n\r\n", "Content-Length: \r\n\r\n"}) {
    FrameReader reader;
    reader.add(header + "{}");
    EXPECT_EQ(reader.next(), std::nullopt);
    EXPECT_TRUE(reader.broken()) << header;
  }
  FrameReader endless;
  endless.add(std::string(kMaxHeaderBytes + 1, 'x'));
  EXPECT_EQ(endless.next(), std::nullopt);
  EXPECT_TRUE(endless.broken());
}

TEST(LspFraming, ABodyIsCountedInBytes) {
  EXPECT_EQ(framed("\"é\""), "Content-Length: 4\r\n\r\n\"é\"");
}

TEST(LspJson, BytesThatAreNotUtf8AreReplaced) {
  EXPECT_EQ(json_text(Json("a\xff")), "\"a\xEF\xBF\xBD\"");
}

TEST(LspUri, PathsAreEscapedAndBack) {
  EXPECT_EQ(path_of_uri("file:///home/me/my%20robot%C3%A9.sdf"), "/home/me/my robot\xC3\xA9.sdf");
  EXPECT_EQ(path_of_uri("file://localhost/a"), "/a");
  EXPECT_EQ(path_of_uri("untitled:Untitled-1"), "untitled:Untitled-1");
  EXPECT_EQ(uri_of_path("/a b#c%.sdf"), "file:///a%20b%23c%25.sdf");
  for (int c = 1; c < 256; ++c) {
    const std::string path = std::string("/x") + static_cast<char>(c);
    EXPECT_EQ(path_of_uri(uri_of_path(path)), path);
  }
}

}  // namespace
}  // namespace rigor::lsp
