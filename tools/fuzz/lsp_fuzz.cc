// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `tools/dev fuzz SECONDS lsp`: any bytes as what an editor sends: a stream of framed messages where they begin with
// "Content-Length", else a message a line. The server must answer or pass over each, and what it sends must be JSON.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include <rigor/lsp/protocol/framing.h>
#include <rigor/lsp/session/session.h>
#include <rigor/text/disk.h>

namespace {

using rigor::lsp::Json;

constexpr std::string_view kXacro =
    "<robot name='r' xmlns:xacro='http://www.ros.org/wiki/xacro'>"
    "<xacro:macro name='arm' params='side *block'><link name='${side}_arm'/></xacro:macro></robot>";

rigor::MemoryDisk workspace() {
  rigor::MemoryDisk disk;
  disk.put("/ws/arm.xacro", std::string(kXacro));
  disk.put("/ws/rigor.toml", "baseline = \"rigor.baseline\"\n[severity]\naxis-zero = \"error\"\n");
  disk.put("/ws/rigor.baseline", "3 axis-zero r.urdf\n");
  disk.put("/ws/controllers.yaml", "controller:\n  joints: [j, k]\n");
  disk.put("/ws/box/model.config",
           "<model><name>box</name><sdf version='1.6'>model.sdf</sdf></model>");
  disk.put("/ws/box/model.sdf",
           "<sdf version='1.6'><model name='box'><link name='l'/></model></sdf>");
  disk.put("/ws/r.urdf",
           "<robot name='r'><link name='a'/><link name='b'/><joint name='j' type='revolute'>"
           "<parent link='a'/><child link='b'/></joint></robot>");
  return disk;
}

/// What is sent is framed, and read back as it was.
void expect_message(const Json& message) {
  rigor::lsp::FrameReader reader;
  reader.add(rigor::lsp::framed(rigor::lsp::json_text(message)));
  const auto body = reader.next();
  if (!body || rigor::lsp::parsed_json(*body).is_discarded()) __builtin_trap();
}

void serve(rigor::lsp::Session& session, std::string_view body) {
  session.receive(rigor::lsp::parsed_json(body));
  while (session.has_work()) session.work();
}

void serve_stream(rigor::lsp::Session& session, std::string_view bytes) {
  rigor::lsp::FrameReader reader;
  // As they come through a pipe: in pieces that end anywhere.
  constexpr std::size_t kPiece = 61;
  for (std::size_t at = 0; at < bytes.size() && !reader.broken(); at += kPiece) {
    reader.add(bytes.substr(at, kPiece));
    while (const auto body = reader.next()) serve(session, *body);
  }
}

void serve_lines(rigor::lsp::Session& session, std::string_view bytes) {
  while (!bytes.empty()) {
    const std::size_t end = bytes.find('\n');
    serve(session, bytes.substr(0, end));
    bytes.remove_prefix(end == std::string_view::npos ? bytes.size() : end + 1);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const rigor::MemoryDisk disk = workspace();
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  rigor::lsp::Session session(disk, {}, {.send = expect_message});
  if (bytes.starts_with("Content-Length")) {
    serve_stream(session, bytes);
    return 0;
  }
  session.receive({{"id", 0},
                   {"method", "initialize"},
                   {"params", {{"workspaceFolders", {{{"uri", "file:///ws"}, {"name", "ws"}}}}}}});
  serve_lines(session, bytes);
  if (const auto check = session.take_mesh_check()) {
    check->run();
    session.finish(*check);
    while (session.has_work()) session.work();
  }
  return 0;
}
