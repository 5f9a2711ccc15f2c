// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Collada files for tests.

#pragma once

#include <string>

namespace rigor::test {

/// What a test varies in a file with one geometry: the unit square in x and y.
struct Collada {
  std::string asset;
  std::string nodes = "<node><instance_geometry url='#square'/></node>";
  std::string shapes =
      "<polylist count='1' material='steel'><input semantic='VERTEX' source='#v' offset='0'/>"
      "<vcount>4</vcount><p>0 1 2 3</p></polylist>";
  std::string corners = "0 0 0 1 0 0 1 1 0 0 1 0";
  std::string accessor = "count='4' stride='3'";
  std::string libraries;
  std::string sources;  ///< beside that of the corners
};

/// A <source> with items of a number for each of the letters.
inline std::string source(const std::string& id, const std::string& letters, int items,
                          const std::string& numbers) {
  const std::string width = std::to_string(letters.size());
  std::string text = "<source id='" + id + "'><float_array id='" + id + "-a' count='" +
                     std::to_string(items * static_cast<int>(letters.size())) + "'>" + numbers +
                     "</float_array><technique_common><accessor source='#" + id + "-a' count='" +
                     std::to_string(items) + "' stride='" + width + "'>";
  for (const char letter : letters) {
    text += std::string("<param name='") + letter + "' type='float'/>";
  }
  return text + "</accessor></technique_common></source>";
}

inline std::string text(const Collada& file) {
  return "<?xml version='1.0'?>\n"
         "<COLLADA xmlns='http://www.collada.org/2005/11/COLLADASchema' version='1.4.1'><asset>" +
         file.asset +
         "</asset>\n<library_geometries><geometry id='square' name='plate'><mesh><source id='p'>"
         "<float_array id='a' count='12'>" +
         file.corners + "</float_array><technique_common><accessor source='#a' " + file.accessor +
         "><param name='X' type='float'/><param name='Y' type='float'/>"
         "<param name='Z' type='float'/></accessor></technique_common></source>" +
         file.sources + "<vertices id='v'><input semantic='POSITION' source='#p'/></vertices>\n" +
         file.shapes + "</mesh></geometry></library_geometries>" + file.libraries +
         "<library_visual_scenes><visual_scene id='s'>" + file.nodes +
         "</visual_scene></library_visual_scenes>"
         "<scene><instance_visual_scene url='#s'/></scene></COLLADA>";
}

}  // namespace rigor::test
