// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Small mesh files whose every fact can be seen in their text, and the corpus, whose facts plain
// searches of its bytes must agree with.

#include <rigor/mesh/asset/asset.h>

#include <array>
#include <filesystem>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include <rigor/text/path.h>

#include "mesh/reading.h"
#include "support/corpus.h"
#include "support/meshes.h"

namespace rigor::mesh {
namespace {

using State = FileReference::State;
using Up = ColladaFacts::Up;

/// The 24 bytes that a PNG of this size begins with.
std::string png(unsigned char width, unsigned char height) {
  std::string bytes("\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\0\0\0\0\0\0\0\0", 24);
  bytes[19] = static_cast<char>(width);
  bytes[23] = static_cast<char>(height);
  return bytes;
}

// ---- Collada

Asset collada(const std::string& body) {
  const MemoryDisk disk(
      {{"a.dae", "<COLLADA version='1.4.1'>\n" + body + "</COLLADA>"}, {"skin.png", png(8, 8)}});
  return asset_of(disk, "a.dae", Format::kCollada);
}

ColladaFacts facts(const std::string& body) { return collada(body).collada.value(); }

TEST(MeshAsset, ColladaSaysWhatIsWritten) {
  const ColladaFacts all = facts(
      "<asset><contributor><authoring_tool> Wood 1.2 </authoring_tool></contributor>\n"
      "<unit name='inch' meter='0.0254'/>\n<up_axis>Y_UP</up_axis></asset>");
  EXPECT_EQ(all.version, "1.4.1");
  EXPECT_EQ(all.authoring_tool, "Wood 1.2");
  EXPECT_EQ(all.unit_name, "inch");
  EXPECT_EQ(all.meter, 0.0254);
  EXPECT_EQ(all.unit_line, 3U);
  EXPECT_EQ(all.up_axis, Up::kY);
  EXPECT_EQ(all.up_axis_line, 4U);
}

TEST(MeshAsset, ColladaWithoutUnitAndAxis) {
  const ColladaFacts none = facts("<asset/>");
  EXPECT_FALSE(none.meter);
  EXPECT_EQ(none.unit_line, 0U);
  EXPECT_EQ(none.up_axis, Up::kNotWritten);
  const ColladaFacts odd = facts("<asset><unit meter='0,01'/><up_axis>UP</up_axis></asset>");
  EXPECT_FALSE(odd.meter);
  EXPECT_EQ(odd.unit_line, 2U);
  EXPECT_EQ(odd.up_axis, Up::kOther);
}

TEST(MeshAsset, ColladaCountsWhatConsumersPassOver) {
  const ColladaFacts all = facts(
      "<library_cameras><camera/></library_cameras><library_lights><light/>\n<light/>"
      "</library_lights><library_animations><animation><animation/></animation>"
      "</library_animations><library_controllers><controller/></library_controllers>"
      "<geometry id='g'><mesh><lines/><linestrips/></mesh><extra><technique>"
      "<double_sided>1</double_sided></technique></extra></geometry>"
      "<extra><technique><double_sided>0</double_sided></technique></extra>");
  EXPECT_EQ(all.cameras, (Sighting{1, 2}));
  EXPECT_EQ(all.lights, (Sighting{2, 2}));
  EXPECT_EQ(all.animations, (Sighting{2, 3}));
  EXPECT_EQ(all.controllers, (Sighting{1, 3}));
  EXPECT_EQ(all.lines, (Sighting{2, 3}));
  EXPECT_EQ(all.double_sided, (Sighting{1, 3}));
}

TEST(MeshAsset, ColladaInstances) {
  const ColladaFacts all = facts(
      "<geometry id='g'/>\n<geometry id='h'/><node id='n'><instance_geometry url='#g'/>"
      "<instance_geometry url='#g'/><instance_geometry url='#g'/>\n"
      "<instance_geometry url='#h'/><instance_geometry url='#none'/></node>"
      "<node><instance_node url='#n'/></node>");
  EXPECT_EQ(all.repeated_geometries, (Sighting{1, 2}));
  EXPECT_EQ(all.missing_geometries, (Sighting{1, 4}));
  EXPECT_EQ(all.instance_nodes, (Sighting{1, 4}));
}

/// The facts of a node with this transform, and inside it the same twice over.
ColladaFacts node_facts(const std::string& transform) {
  return facts("<geometry id='g'/><node>" + transform +
               "<node><instance_geometry url='#g'/></node></node>");
}

TEST(MeshAsset, ColladaNodesThatDoMoreThanMove) {
  const auto counts = [](const ColladaFacts& of) {
    return std::array<std::uint64_t, 4>{of.mirrored_nodes.count, of.sheared_nodes.count,
                                        of.unevenly_scaled_nodes.count, of.unclear_nodes.count};
  };
  using Counts = std::array<std::uint64_t, 4>;
  EXPECT_EQ(counts(node_facts("<rotate>1 1 1 77</rotate><scale>2 2 2</scale>")), Counts{});
  EXPECT_EQ(counts(node_facts("<scale>1 -1 1</scale>")), (Counts{1, 0, 0, 0}));
  EXPECT_EQ(counts(node_facts("<scale>-1 -1 1</scale>")), Counts{});
  EXPECT_EQ(counts(node_facts("<scale>1 1 1.01</scale>")), (Counts{0, 0, 1, 0}));
  EXPECT_EQ(counts(node_facts("<scale>1 1 1.000001</scale>")), Counts{}) << "as it was printed";
  EXPECT_EQ(counts(node_facts("<matrix>1 0.6 0 0 0 0.8 0 0 0 0 1 0 0 0 0 1</matrix>")),
            (Counts{0, 1, 0, 0}));
  EXPECT_EQ(counts(node_facts("<skew>45 1 0 0 0 1 0</skew>")), (Counts{0, 0, 0, 1}));
  EXPECT_EQ(counts(facts("<node><scale>1 -2 1</scale><instance_camera url='#c'/></node>")),
            Counts{})
      << "nobody sees it";
}

TEST(MeshAsset, ColladaTextures) {
  const Asset asset = collada(
      "<library_images><image id='a'><init_from>skin.png</init_from></image>\n"
      "<image id='b'><init_from>\n gone.png </init_from></image>\n"
      "<image id='c'><!-- <init_from>skin.png</init_from> --></image>\n"
      "<image id='d'><init_from><ref>skin.png</ref></init_from></image></library_images>\n"
      "<surface type='2D'><init_from>a</init_from></surface>\n"
      "<surface type='2D'><init_from>nothing</init_from></surface>\n"
      "<sampler2D><instance_image url='#a'/></sampler2D>\n"
      "<sampler2D><instance_image url='#z'/></sampler2D>\n");
  ASSERT_EQ(asset.textures.size(), 6U);
  const std::array<State, 6> states{State::kFound, State::kMissing,   State::kUndefined,
                                    State::kFound, State::kUndefined, State::kUndefined};
  const std::array<std::uint64_t, 6> lines{2, 3, 5, 6, 8, 10};
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(asset.textures[i].state, states[i]) << i;
    EXPECT_EQ(asset.textures[i].line, lines[i]) << i;
  }
  EXPECT_EQ(asset.textures[0].width, 8U);
  EXPECT_EQ(asset.textures[1].written, "gone.png");
  EXPECT_EQ(asset.textures[4].written, "nothing");
}

TEST(MeshAsset, ColladaSymbolsThatAreBoundToNothing) {
  const auto undefined = [](const std::string& groups, const std::string& bound) {
    return collada(
               "<library_materials><material id='red'/></library_materials>\n<geometry id='g'>"
               "<mesh>\n" +
               groups +
               "</mesh></geometry><geometry id='unseen'><mesh><triangles material='x'/></mesh>"
               "</geometry><node><instance_geometry url='#g'><bind_material><technique_common>" +
               bound + "</technique_common></bind_material></instance_geometry></node>")
        .undefined_materials;
  };
  const std::string two =
      "<triangles material='a'/>\n<polylist material='b'/>\n<lines material='c'/>";
  const std::string a = "<instance_material symbol='a' target='#red'/>";
  EXPECT_EQ(undefined(two, a), (std::vector<Mention>{{"b", 5}}));
  EXPECT_EQ(undefined(two, a + "<instance_material symbol='b' target='#red'/>").size(), 0U);
  EXPECT_EQ(undefined(two, a + "<instance_material symbol='b' target='#blue'/>").size(), 1U);
  EXPECT_EQ(undefined("<triangles material='red'/><triangles/>", "").size(), 0U) << "its id";
  EXPECT_EQ(undefined("<tristrips material='b'/><trifans material='b'/>", "").size(), 1U);
}

TEST(MeshAsset, ColladaThatIsCutTellsWhatItCan) {
  const MemoryDisk disk({{"a.dae", "<COLLADA><asset><unit meter='1'/></asset><library_im"},
                         {"b.dae", "no"},
                         {"c.dae", ""}});
  const Asset cut = asset_of(disk, "a.dae", Format::kCollada);
  EXPECT_FALSE(cut.problem.empty());
  EXPECT_EQ(cut.collada.value().meter, 1);
  EXPECT_FALSE(asset_of(disk, "b.dae", Format::kCollada).problem.empty());
  EXPECT_FALSE(asset_of(disk, "c.dae", Format::kCollada).collada);
  EXPECT_FALSE(asset_of(disk, "d.dae", Format::kCollada).problem.empty()) << "is not there";
}

// ---- OBJ

TEST(MeshAsset, ObjNamesLibrariesAndTheyNameTextures) {
  const MemoryDisk disk(
      {{"m/a.obj",
        "# made by hand\nmtllib a.mtl\nmtllib two words.mtl\nmtllib b.mtl gone.mtl\n"
        "usemtl wood\nv 0 0 0\nusemtl iron\nusemtl wood\nusemtl iron\nusemtl lead\n"},
       {"m/a.mtl",
        "newmtl wood\n Kd 1 1 1\n\tmap_Kd -s 1 2 -o 0.5 -clamp on Oak bark.png\n"
        "map_Ks C:\\art\\x.png\n"},
       {"m/two words.mtl", "newmtl tin\nbump -bm 0.2 dents.png\n"},
       {"m/b.mtl", "newmtl lead\nmap_kd DENTS.png\r\n"},
       {"m/Oak bark.png", png(3, 5)},
       {"m/dents.png", ""}});
  const Asset asset = asset_of(disk, "m/a.obj", Format::kObj);
  const std::vector<FileReference>& libraries = asset.obj.value().libraries;
  ASSERT_EQ(libraries.size(), 4U);
  EXPECT_EQ(libraries[1].path, "m/two words.mtl");
  EXPECT_EQ(libraries[2].path, "m/b.mtl");
  EXPECT_EQ(libraries[3].state, State::kMissing);
  EXPECT_EQ(libraries[3].line, 4U);
  EXPECT_TRUE(asset.undefined_materials.empty()) << "gone.mtl may define them";

  ASSERT_EQ(asset.textures.size(), 4U);
  EXPECT_EQ(asset.textures[0].written, "Oak bark.png");
  EXPECT_EQ(asset.textures[0].from, "m/a.mtl");
  EXPECT_EQ(asset.textures[0].line, 3U);
  EXPECT_EQ(asset.textures[0].height, 5U);
  EXPECT_EQ(asset.textures[1].state, State::kAbsolute);
  EXPECT_EQ(asset.textures[2].path, "m/dents.png");
  EXPECT_EQ(asset.textures[3].state, State::kWrongCase);
}

using Mentions = std::vector<Mention>;

TEST(MeshAsset, ObjMaterialsThatFacesHaveAndNobodyDefines) {
  const std::string body =
      "usemtl wood\nf 1 2 3\nusemtl iron\nusemtl lead\nf 1 2 3\nf 1 2 3\nusemtl iron\nf 1 2 3\n"
      "usemtl lead\nf 1 2 3\nusemtl tin\n";
  const MemoryDisk disk({{"none.obj", body},
                         {"whole.obj", "mtllib a.mtl b.mtl\n" + body},
                         {"some.obj", "mtllib a.mtl\n" + body},
                         {"gone.obj", "mtllib a.mtl gone.mtl\n" + body},
                         {"a.mtl", "newmtl wood\nnewmtl iron\n"},
                         {"b.mtl", "newmtl lead\n"}});
  const auto undefined = [&](const std::string& path) {
    return asset_of(disk, path, Format::kObj).undefined_materials;
  };
  EXPECT_EQ(undefined("none.obj"), (Mentions{{"wood", 1}, {"lead", 4}, {"iron", 7}}));
  EXPECT_EQ(undefined("whole.obj"), Mentions());
  EXPECT_EQ(undefined("some.obj"), (Mentions{{"lead", 5}}));
  EXPECT_EQ(undefined("gone.obj"), Mentions()) << "who knows what it defines";
}

// ---- glTF

constexpr const char* kGltf = R"({
"asset": {"version": "2.0", "generator": "a \"hand\" \u00e9", "extras": {"version": "9"}},
"extensionsRequired": ["KHR_a", "KHR_b"],
"nodes": [{"name": "uri", "extras": {"uri": "x"}}],
"buffers": [{"byteLength": 3, "uri": "data:;base64,AAAA"}, {"uri": "gone.bin"}],
"images": [{"uri": "skin%2epng"},
 {"bufferView": 0}, {"extras": {"uri": "no"}, "uri": "textures\/x.png"}]})";

void expect_gltf(const Asset& asset) {
  EXPECT_EQ(asset.problem, "");
  const GltfFacts& facts = asset.gltf.value();
  EXPECT_EQ(facts.version, "2.0");
  EXPECT_EQ(facts.generator, "a \"hand\" \xC3\xA9");
  EXPECT_EQ(facts.extensions_required, (std::vector<std::string>{"KHR_a", "KHR_b"}));
  ASSERT_EQ(facts.buffers.size(), 2U);
  EXPECT_EQ(facts.buffers[0].state, State::kEmbedded);
  EXPECT_EQ(facts.buffers[1].state, State::kMissing);
  EXPECT_EQ(facts.overruns, GltfOverruns());
  EXPECT_EQ(facts.nameless_buffers, Sighting());
  ASSERT_EQ(asset.textures.size(), 2U);
  EXPECT_EQ(asset.textures[0].path, "skin.png");
  EXPECT_EQ(asset.textures[0].width, 6U);
  EXPECT_EQ(asset.textures[1].written, "textures/x.png");
}

TEST(MeshAsset, GltfAsTextAndInAContainer) {
  std::string json = kGltf;
  while (json.size() % 4 != 0) json += ' ';  // glTF 2.0, 4.4.3.2
  std::string glb("glTF\2\0\0\0\0\0\0\0\0\0\0\0JSON", 20);
  glb[12] = static_cast<char>(json.size() & 0xFF);
  glb[13] = static_cast<char>(json.size() >> 8U);
  glb += json + "\"images\":[{\"uri\":\"behind.png\"}]";
  const MemoryDisk disk({{"a.gltf", json}, {"a.glb", glb}, {"skin.png", png(6, 6)}});
  const Asset text = asset_of(disk, "a.gltf", Format::kGltf);
  expect_gltf(text);
  EXPECT_EQ(text.textures.at(1).line, 7U);
  const Asset container = asset_of(disk, "a.glb", Format::kGlb);
  expect_gltf(container);
  EXPECT_EQ(container.textures.at(1).line, 0U);
}

// ---- Damage

TEST(MeshAsset, SurvivesDamage) {
  const std::string collada =
      "<COLLADA><asset><unit meter='1'/></asset><image id='a'><init_from>a%20b</init_from></image>"
      "<geometry id='g'/><node><scale>1 2 3</scale><instance_geometry url='#g'/></node></COLLADA>";
  const std::string ascii =
      "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
      "vertex 0 1 0\nendloop\nendfacet\nendsolid\n";
  const std::array<std::pair<Format, std::string>, 6> files{
      {{Format::kCollada, collada},
       {Format::kStlAscii, ascii},
       {Format::kStlBinary, test::binary_stl(test::box_mesh({1, 1, 1}))},
       {Format::kObj, "mtllib a.obj\nusemtl x\nnewmtl x\nmap_Kd -s 1 1 1 -bm 2 a b\n"},
       {Format::kGltf, kGltf},
       {Format::kGlb, std::string("glTF\2\0\0\0\0\0\0\0\xff\0\0\0JSON", 20) + kGltf}}};
  std::mt19937 random(5);
  for (const auto& [format, whole] : files) {
    for (int round = 0; round < 1000; ++round) {
      std::string bytes = whole;
      for (int i = 0; i < 3; ++i) bytes[random() % bytes.size()] ^= static_cast<char>(random());
      if (round % 2 == 0) bytes.resize(random() % bytes.size());
      bytes.shrink_to_fit();
      const MemoryDisk disk({{"a.obj", bytes}});
      const Asset asset = asset_of(disk, "a.obj", format);
      EXPECT_LE(asset.textures.size(), bytes.size());
    }
  }
}

// ---- The corpus

template <class Use>
int for_each_of(const std::string& set, const std::string& ending, const Use& use) {
  const RealDisk disk;
  int files = 0;
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(test::corpus() + "/" + set)) {
    const std::string path = entry.path().string();
    if (extension(path) != ending) continue;
    const std::string bytes = test::read_file(path);
    use(path, bytes, asset_of(disk, path, format_of(bytes.substr(0, 512), bytes.size(), path)));
    ++files;
  }
  return files;
}

std::uint64_t occurrences(const std::string& bytes, const std::string& text) {
  std::uint64_t count = 0;
  for (std::size_t at = bytes.find(text); at != std::string::npos; at = bytes.find(text, at + 1)) {
    ++count;
  }
  return count;
}

TEST(MeshAsset, ColladaOfTheCorpusAsASearchSeesIt) {
  RIGOR_NEEDS_CORPUS();
  int undefined = 0;
  const int files = for_each_of(
      "gazebo_models", ".dae",
      [&](const std::string& path, const std::string& bytes, const Asset& asset) {
        const ColladaFacts& facts = asset.collada.value();
        const std::string head = bytes.substr(0, 3000);
        const std::size_t unit = head.find("meter=\"", head.find("<unit"));
        ASSERT_NE(unit, std::string::npos) << path;
        EXPECT_EQ(facts.meter, std::stod(head.substr(unit + 7))) << path;
        EXPECT_EQ(facts.up_axis == Up::kZ, head.find("<up_axis>Z_UP<") != std::string::npos)
            << path;
        EXPECT_EQ(facts.up_axis == Up::kY, head.find("<up_axis>Y_UP<") != std::string::npos)
            << path;
        EXPECT_EQ(facts.instance_nodes.count, occurrences(bytes, "<instance_node ")) << path;
        EXPECT_EQ(facts.double_sided.count, occurrences(bytes, "<double_sided>1<")) << path;
        EXPECT_EQ(facts.cameras.count, occurrences(bytes, "<camera ")) << path;
        EXPECT_EQ(facts.lights.count, occurrences(bytes, "<light ")) << path;
        for (const FileReference& texture : asset.textures) {
          undefined += texture.state == State::kUndefined;
          EXPECT_NE(texture.state, State::kWrongCase) << path;
        }
      });
  EXPECT_EQ(files, 112);
  EXPECT_EQ(undefined, 9) << "what assimp 5.2.5 refuses and Gazebo does not";
}

TEST(MeshAsset, StlOfTheCorpus) {
  RIGOR_NEEDS_CORPUS();
  int solid = 0;
  int zero = 0;
  int attributes = 0;
  const int files =
      for_each_of("gazebo_models", ".stl",
                  [&](const std::string& path, const std::string& bytes, const Asset& asset) {
                    const StlFacts& facts = asset.stl.value();
                    EXPECT_TRUE(facts.binary) << path;
                    EXPECT_EQ(facts.facets, (bytes.size() - 84) / 50) << path;
                    EXPECT_EQ(facts.contrary_normals.count, 0U) << path;
                    solid += facts.solid_header;
                    zero += facts.zero_normals.count > 0;
                    attributes += facts.attributes.count > 0;
                  });
  EXPECT_EQ(files, 41);
  // Of all 92 files of their origin 11, 12 and 2.
  EXPECT_EQ(solid, 4);
  EXPECT_EQ(zero, 7);
  EXPECT_EQ(attributes, 1);
}

}  // namespace
}  // namespace rigor::mesh
