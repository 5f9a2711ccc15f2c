// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/page/model_page.h>

#include <cmath>
#include <map>
#include <string>

#include <gtest/gtest.h>
#include <rigor/report/page/changes.h>
#include <rigor/rules/validate.h>
#include <rigor/view/camera.h>
#include <nlohmann/json.hpp>

#include "report/page_decoding.h"
#include "view/drawing_fixture.h"

namespace rigor::report {
namespace {

using nlohmann::json;
using Files = std::map<std::string, std::string>;

struct PageOfModel {
  json data;
  std::string bytes;
  PageFacts facts;
  PageData raw;
};

PageOfModel page_of(const std::string& path, const Files& files) {
  view::DrawnModel model(path, files);
  std::set<view::Layer> layers;
  for (const std::string_view name : view::layer_names()) layers.insert(*view::layer_named(name));
  const model::Frames frames(model.loaded.root);
  const view::Drawing drawing = model.draw(layers);
  const rules::ValidateResult result =
      rules::validate(model.environment, {.paths = {path}}, model.sources);
  const ModelPage page{.path = path,
                       .root = model.loaded.root,
                       .frames = frames,
                       .drawing = drawing,
                       .findings = result.diagnostics,
                       .sources = model.sources};
  PageOfModel out{.data = {}, .bytes = {}, .facts = facts_of(page), .raw = page_data(page)};
  const std::string html = model_page(out.raw, test::kPlainPage);
  out.data = json::parse(
      test::between(html, "<script id=\"data\" type=\"application/json\">", "</script>"));
  out.bytes = test::inflated(test::from_base64(
      test::between(html, "<script id=\"bytes\" type=\"text/plain\">", "</script>")));
  return out;
}

PageOfModel page_of_sdf(const std::string& inside, Files files = {},
                        const std::string& name = "m") {
  files["m.sdf"] =
      "<sdf version='1.9'>\n<model name='" + name + "'>\n" + inside + "</model>\n</sdf>\n";
  return page_of("m.sdf", files);
}

constexpr const char* kBox =
    "<visual name='v'><geometry><box><size>1 2 3</size></box></geometry></visual>";

const std::string kArm =
    std::string("<link name='base'><pose>0 0 1 0 0 0</pose>") + kBox +
    "<inertial><mass>2</mass><pose>0.1 0 0 0 0 "
    "0</pose><inertia><ixx>1</ixx><iyy>1.5</iyy><izz>2</izz>"
    "</inertia></inertial></link>\n"
    "<link name='tip'><pose>0 2 1 0 0 1.5707963267948966</pose>"
    "<inertial><mass>4</mass><inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia></inertial></"
    "link>\n"
    "<joint name='turn' type='revolute'><parent>base</parent><child>tip</child><axis><xyz>1 0 "
    "0</xyz>"
    "<limit><lower>-0.5</lower><upper>0.25</upper></limit></axis></joint>\n"
    "<joint name='roll' type='continuous'><parent>base</parent><child>tip</child><axis><xyz>0 0 "
    "1</xyz>"
    "</axis></joint>\n";

void expect_numbers(const json& values, const std::vector<double>& expected) {
  ASSERT_EQ(values.size(), expected.size()) << values;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(values[i].get<double>(), expected[i], 1e-12) << values;
  }
}

TEST(ModelPage, LinksAndJointsWhereTheyAre) {
  const json data = page_of_sdf(kArm).data;
  EXPECT_EQ(data["format"], 1);
  EXPECT_EQ(data["name"], "m");
  ASSERT_EQ(data["links"].size(), 2U);
  const json& tip = data["links"][1];
  EXPECT_EQ(tip["scoped"], "m::tip");
  EXPECT_EQ(tip["model"], 0);
  EXPECT_EQ(tip["movedBy"], 0);  // of two joints the first one
  EXPECT_EQ(data["links"][0]["movedBy"], -1);
  const double half = std::sqrt(0.5);
  expect_numbers(tip["pose"], {0, 2, 1, half, 0, 0, half});
  const json& turn = data["joints"][0];
  EXPECT_EQ(turn["type"], "revolute");
  EXPECT_EQ(turn["parent"], 0);
  EXPECT_EQ(turn["child"], 1);
  // Its axis is x in the tip's frame, which is turned a quarter about z.
  expect_numbers(turn["axes"][0]["direction"], {0, 1, 0});
  EXPECT_EQ(turn["axes"][0]["lower"], -0.5);
  EXPECT_EQ(turn["axes"][0]["upper"], 0.25);
  EXPECT_EQ(turn["axes"][0]["slides"], false);
  EXPECT_EQ(turn["line"], 5);
  EXPECT_EQ(data["files"][turn["file"].get<std::size_t>()]["path"], "m.sdf");
  EXPECT_TRUE(data["joints"][1]["axes"][0]["upper"].is_null());
}

TEST(ModelPage, MassesAndTheirSum) {
  const json data = page_of_sdf(kArm).data;
  const json& base = data["links"][0];
  EXPECT_EQ(base["mass"], 2);
  expect_numbers(base["com"], {0.1, 0, 0});
  expect_numbers(base["inertia"], {1, 0, 0, 1.5, 0, 2});
  EXPECT_NE(base["inertialText"].get<std::string>().find("<mass>2</mass>"), std::string::npos);
  EXPECT_EQ(data["totals"]["mass"], 6);
  // (2 (0.1, 0, 1) + 4 (0, 2, 1)) / 6
  expect_numbers(data["totals"]["com"], {0.2 / 6, 8.0 / 6, 1});
}

TEST(ModelPage, ANumberThatIsNoneIsNull) {
  const json urdf =
      page_of("a.urdf", {{"a.urdf", "<robot name='a'><link name='l'/></robot>"}}).data;
  EXPECT_TRUE(urdf["links"][0]["mass"].is_null());
  EXPECT_EQ(urdf["links"][0]["inertialText"], "");
  EXPECT_TRUE(urdf["totals"]["mass"].is_null());
}

TEST(ModelPage, AFollowerNamesItsLeader) {
  const std::string follower =
      "<joint name='b' type='prismatic'><parent link='x'/><child link='z'/><axis xyz='0 0 1'/>"
      "<limit lower='0' upper='1' effort='1' velocity='1'/><mimic joint='a' multiplier='2' "
      "offset='0.5'/>"
      "</joint>";
  const json data =
      page_of("a.urdf", {{"a.urdf",
                          "<robot name='r'><link name='x'/><link name='y'/><link name='z'/>"
                          "<joint name='a' type='continuous'><parent link='x'/><child link='y'/>"
                          "<axis xyz='0 0 1'/></joint>" +
                              follower + "</robot>"}})
          .data;
  const json& axis = data["joints"][1]["axes"][0];
  EXPECT_EQ(axis["slides"], true);
  EXPECT_EQ(axis["mimic"]["joint"], 0);
  EXPECT_EQ(axis["mimic"]["axis"], 0);
  EXPECT_EQ(axis["mimic"]["multiplier"], 2);
  EXPECT_EQ(axis["mimic"]["offset"], 0.5);
  EXPECT_EQ(axis["mimic"]["reference"], 0);
}

TEST(ModelPage, NamesAreTextWhateverTheyHold) {
  const std::string hostile = "&lt;/script>&lt;img src=x onerror=alert(1)>&lt;!--";
  const std::string plain = "</script><img src=x onerror=alert(1)><!--";
  const PageOfModel page = page_of_sdf(
      "<link name='" + hostile + "'>" + kBox + "</link><!-- </script> -->", {}, hostile);
  EXPECT_EQ(page.raw.json.find('<'), std::string::npos);
  EXPECT_EQ(page.data["name"], plain);
  EXPECT_EQ(page.data["links"][0]["name"], plain);
  EXPECT_NE(page.data["files"][0]["text"].get<std::string>().find("<!-- </script> -->"),
            std::string::npos);
}

TEST(ModelPage, BytesThatAreNoTextDoNoHarm) {
  EXPECT_EQ(page_of_sdf("<link name='\xff\xfe'/>").data["links"].size(), 1U);
}

constexpr const char* kTriangleObj =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n";

std::string visual_of_mesh(const std::string& name, const std::string& more = {}) {
  return "<visual name='" + name + "'><geometry><mesh><uri>a.obj</uri>" + more +
         "</mesh></geometry></visual>";
}

TEST(ModelPage, AMeshIsWrittenOnceForAllThatUseIt) {
  const json data = page_of_sdf("<link name='l'>" + visual_of_mesh("a") +
                                    visual_of_mesh("b", "<scale>2 2 2</scale>") + "</link>",
                                {{"a.obj", kTriangleObj}})
                        .data;
  std::set<int> meshes;
  for (const json& body : data["bodies"]) {
    if (body["layer"] != "visual") continue;
    meshes.insert(body["mesh"].get<int>());
    EXPECT_EQ(body["link"], 0);
  }
  ASSERT_EQ(meshes.size(), 1U);
  const json& mesh = data["meshes"][static_cast<std::size_t>(*meshes.begin())];
  EXPECT_EQ(mesh["triangles"], 1);
  EXPECT_TRUE(mesh["uvs"].is_null());  // there is no picture
  EXPECT_EQ(data["totals"]["triangles"]["visual"], 2);
}

TEST(ModelPage, EveryIndexLeadsSomewhere) {
  const PageOfModel page = page_of_sdf(kArm);
  const json& data = page.data;
  EXPECT_GT(data["bodies"].size(), 5U);
  for (const json& body : data["bodies"]) {
    EXPECT_LT(body["mesh"].get<std::size_t>(), data["meshes"].size());
    EXPECT_TRUE(view::layer_named(body["layer"].get<std::string>()));
    EXPECT_FALSE(body["surfaces"].empty());
    EXPECT_EQ(body["pose"].size(), 7U);
  }
  for (const json& mesh : data["meshes"]) {
    for (const char* key : {"positions", "normals", "uvs", "colors", "indices"}) {
      if (mesh[key].is_null()) continue;
      EXPECT_EQ(mesh[key]["at"].get<std::size_t>() % 4, 0U);
      EXPECT_LE(mesh[key]["at"].get<std::size_t>() + mesh[key]["bytes"].get<std::size_t>(),
                page.bytes.size());
    }
    std::size_t in_parts = 0;
    for (const json& part : mesh["parts"]) in_parts += part["count"].get<std::size_t>();
    EXPECT_TRUE(mesh["parts"].empty() || in_parts == mesh["triangles"]);
  }
}

TEST(ModelPage, AFindingKnowsWhatItIsAbout) {
  const json data =
      page_of_sdf(
          "<link name='a'/>\n"
          "<link name='b'><inertial><mass>-1</mass></inertial></link>\n"
          "<joint name='j' type='revolute'><parent>a</parent><child>b</child>\n"
          "<axis><xyz>0 0 1</xyz><limit><lower>1</lower><upper>-1</upper></limit></axis>"
          "</joint>\n")
          .data;
  bool inverted = false;
  bool weightless = false;
  for (const json& finding : data["findings"]) {
    if (finding["rule"] == "joint-limit-inverted") {
      inverted = true;
      EXPECT_EQ(finding["joint"], 0);
      EXPECT_EQ(finding["link"], -1);
      EXPECT_EQ(finding["line"], 6);
      EXPECT_EQ(finding["severity"], "error");
      EXPECT_EQ(data["files"][finding["file"].get<std::size_t>()]["path"], "m.sdf");
    }
    weightless = weightless || (finding["link"] == 1 && finding["line"] == 4);
  }
  EXPECT_TRUE(inverted);
  EXPECT_TRUE(weightless);
}

TEST(ModelPage, WhatIsNotDrawnIsListed) {
  const json data = page_of_sdf("<link name='l'>" + visual_of_mesh("a") + "</link>").data;
  ASSERT_EQ(data["notDrawn"].size(), 1U);
  EXPECT_NE(data["notDrawn"][0]["reason"].get<std::string>(), "");
}

TEST(ModelPage, WithoutATemplateThereIsNone) {
  EXPECT_EQ(model_page({"{}", ""}, ""), "");
  EXPECT_EQ(model_page({"{}", ""}, "<body></body>"), "");
}

TEST(PageChanges, SayWhatAnEditDid) {
  const PageFacts before = page_of_sdf(kArm).facts;
  EXPECT_TRUE(page_changes(before, before).empty());
  const auto after = [&](const std::string& old, const std::string& now) {
    std::string text = kArm;
    const std::size_t at = text.find(old);
    EXPECT_NE(at, std::string::npos);
    std::string all;
    for (const std::string& line :
         page_changes(before, page_of_sdf(text.replace(at, old.size(), now)).facts)) {
      all += line + '\n';
    }
    return all;
  };
  EXPECT_EQ(after("<mass>4", "<!-- heavy -->\n<mass>4"), "");
  EXPECT_EQ(after("<mass>4", "<mass>4.5"), "link m::tip weighs 4.5 kg instead of 4 kg\n");
  EXPECT_EQ(after("0 2 1", "0 2 1.25"), "link m::tip moved by 0.25 m\n");
  EXPECT_EQ(after("<upper>0.25", "<upper>0.5"), "joint m::turn changed\n");
  EXPECT_EQ(after("1 2 3", "1 2 3.1"), "m/link base/visual v changed\n");
  EXPECT_EQ(after("<upper>0.25", "<upper>-1").find("joint m::turn changed\nnew error: "), 0U);
  EXPECT_NE(after("</link>\n", "</link>\n<link name='new'/>\n").find("link m::new added\n"),
            std::string::npos);
}

TEST(PageChanges, ManyAreCounted) {
  PageFacts before;
  PageFacts after;
  for (int i = 0; i < 20; ++i) after.joints["j" + std::to_string(i)] = "";
  const auto said = page_changes(before, after);
  ASSERT_EQ(said.size(), kMaxChanges + 1);
  EXPECT_EQ(said.back(), "and 12 other changes");
  EXPECT_EQ(json::parse(page_changes_json({})), json::parse(R"({"changes":[],"nothing":true})"));
}

TEST(ModelPage, GhostsAreThePartsThatAFixMoves) {
  // A box of 2 m at x = 3, a ball of 1 m that it carries half a meter above, and a link that stays.
  const auto robot = [](const std::string& x, const std::string& size) {
    return "<robot name='r'><link name='a'><visual><geometry><sphere "
           "radius='1'/></geometry></visual>"
           "</link><link name='b'><visual><geometry><box size='" +
           size +
           " 2 2'/></geometry></visual></link><link name='c'><collision><geometry><sphere "
           "radius='1'/></geometry></collision></link>"
           "<joint name='j' type='fixed'><origin xyz='" +
           x +
           " 0 0'/><parent link='a'/><child link='b'/></joint>"
           "<joint name='k' type='fixed'><origin xyz='0 0 0.5'/><parent link='b'/><child "
           "link='c'/></joint></robot>";
  };
  const auto drawn = [&](const std::string& x, const std::string& size) {
    return view::DrawnModel("r.urdf", {{"r.urdf", robot(x, size)}})
        .draw({view::Layer::kVisual, view::Layer::kCollision, view::Layer::kFrames});
  };
  const view::Drawing now = drawn("3", "2");
  EXPECT_TRUE(ghosts_between(now, drawn("3.0", "2"), 0).empty());
  const std::vector<PageGhost> moved = ghosts_between(now, drawn("0.003", "2"), 7);
  ASSERT_EQ(moved.size(), 2U);
  EXPECT_EQ(moved[0].finding, 7U);
  EXPECT_EQ(now.bodies[moved[0].body].link.value, 1U);
  EXPECT_EQ(moved[0].pose.translation, (model::Vector3{0.003, 0, 0}));
  EXPECT_EQ(moved[1].pose.translation, (model::Vector3{0.003, 0, 0.5}));
  const std::vector<PageGhost> sized = ghosts_between(now, drawn("3", "0.2"), 7);
  ASSERT_EQ(sized.size(), 1U);
  EXPECT_EQ(sized[0].pose, now.bodies[sized[0].body].pose);
  EXPECT_EQ(sized[0].scale, (model::Vector3{0.2, 2, 2}));
  // Another robot has none.
  EXPECT_TRUE(ghosts_between(now, view::Drawing{}, 7).empty());
}

}  // namespace
}  // namespace rigor::report
