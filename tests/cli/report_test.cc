// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor report` as its users script it.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <tinyxml2.h>
#include <nlohmann/json.hpp>

#include <cli/program.h>
#include <rigor/view/trace.h>

namespace rigor::test {
namespace {

using nlohmann::json;

/// A crate that stands on the ground.
std::string crate(const std::string& name, const std::string& inertial) {
  return "<sdf version='1.9'><model name=\"" + name +
         "\"><link name='body'><pose>0 0 0.1 0 0 0</pose><inertial>" + inertial +
         "</inertial><collision name='c'><geometry><box><size>0.2 0.2 0.2</size></box></geometry>"
         "</collision><visual name='v'><geometry><box><size>0.2 0.2 0.2</size></box></geometry>"
         "</visual></link></model></sdf>\n";
}

constexpr const char* kSound =
    "<mass>6</mass><inertia><ixx>0.04</ixx><iyy>0.04</iyy><izz>0.04</izz></inertia>";
constexpr const char* kImpossible =
    "<mass>6</mass><inertia><ixx>0.04</ixx><iyy>0.04</iyy><izz>9</izz></inertia>";

class ReportCli : public testing::Test {
 protected:
  ReportCli() {
    folder_.put("robots/sane.sdf", crate("sane", kSound));
    folder_.put("robots/odd.sdf", crate("odd", kImpossible));
    folder_.put("robots/broken.sdf", "<sdf version='1.9'><model name='broken'><link name='a'>");
    folder_.put("robots/evil.sdf", crate("&lt;/script>&lt;img src=x onerror=alert(1)>", kSound));
    folder_.put("robots/package/model.config", "<model><name>p</name><sdf>gone.sdf</sdf></model>");
  }

  static std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++found;
    return found;
  }

  /// The row of the table that names the file.
  static std::string row(const std::string& page, const std::string& file) {
    const std::size_t name = page.find("<wbr/>" + file + "<");
    EXPECT_NE(name, page.npos) << file;
    const std::size_t begin = page.rfind("<tr", name);
    return page.substr(begin, page.find("</tr>", name) - begin);
  }

  Folder folder_;
};

TEST_F(ReportCli, TellsOfEveryModelAndABrokenOneTakesNothingFromTheOthers) {
  const Ran ran = folder_.rigor("report robots -o report.html");
  EXPECT_EQ(ran.exit, 1) << ran.err;
  EXPECT_EQ(ran.out, "");
  const std::string page = folder_.get("report.html");
  tinyxml2::XMLDocument document;
  EXPECT_EQ(document.Parse(page.c_str()), tinyxml2::XML_SUCCESS) << document.ErrorStr();
  EXPECT_NE(row(page, "sane.sdf").find(">pass<"), std::string::npos);
  EXPECT_NE(row(page, "evil.sdf").find(">pass<"), std::string::npos);
  EXPECT_NE(row(page, "broken.sdf").find("not simulated"), std::string::npos);
  EXPECT_EQ(page.find("<img src=x"), std::string::npos);
  EXPECT_EQ(count(page, "<script"), 1U);
  // Three crates are drawn twice: in the table, and larger.
  if (!view::tracer().empty()) {
    EXPECT_EQ(count(page, "src=\"data:image/png;base64,"), 6U);
  }
}

TEST_F(ReportCli, EveryFindingOfValidateIsThere) {
  const json found = json::parse(folder_.rigor("validate robots --format json").out);
  folder_.rigor("report robots -o report.html --no-simulate --no-pictures");
  const std::string page = folder_.get("report.html");
  EXPECT_GT(found["diagnostics"].size(), 2U);
  EXPECT_EQ(count(page, "<li class=\"finding "), found["diagnostics"].size());
  for (const json& each : found["diagnostics"]) {
    const std::string rule = each["rule"];
    EXPECT_NE(page.find("href=\"#rule-" + rule + "\""), std::string::npos) << rule;
    EXPECT_NE(page.find("id=\"rule-" + rule + "\""), std::string::npos) << rule;
  }
  EXPECT_EQ(count(page, "Simulation"), 0U);
  EXPECT_EQ(count(page, "<img"), 0U);
}

TEST_F(ReportCli, NumbersAreThoseOfInspect) {
  folder_.rigor("report '" RIGOR_TESTDATA
                "models/my_robot/model.sdf' -o report.html --no-simulate");
  const json robot = json::parse(
      folder_.rigor("inspect '" RIGOR_TESTDATA "models/my_robot/model.sdf' --format json").out);
  const json& totals = robot["models"][0]["totals"];
  const std::string cells = row(folder_.get("report.html"), "model.sdf");
  // Links, joints, mass.
  std::size_t at = 0;
  std::vector<double> values;
  while ((at = cells.find("data-v=\"", at)) != cells.npos) {
    at += 8;
    values.push_back(std::stod(cells.substr(at)));
  }
  ASSERT_GE(values.size(), 3U) << cells;
  EXPECT_EQ(values[0], totals["links"].get<double>());
  EXPECT_EQ(values[1], totals["joints"].get<double>());
  EXPECT_NEAR(values[2], totals["mass"].get<double>(), 1e-9);
}

TEST_F(ReportCli, TheSameBytesForAnyNumberOfThreads) {
  for (const std::string jobs : {"1", "4"}) {
    folder_.rigor("report robots -o " + jobs + ".html -j " + jobs);
  }
  EXPECT_GT(folder_.get("1.html").size(), 1000U);
  EXPECT_EQ(folder_.get("1.html"), folder_.get("4.html"));
}

TEST_F(ReportCli, AFolderHasAPageForEachModel) {
  EXPECT_EQ(folder_.rigor("report robots -o made/site/ --no-simulate").exit, 1);
  const std::string index = folder_.get("made/site/index.html");
  EXPECT_EQ(count(index, "href=\"models/"), 4U);
  for (const char* attribute : {"href=\"models/", "src=\"thumbnails/"}) {
    for (std::size_t at = index.find(attribute); at != index.npos;
         at = index.find(attribute, at + 1)) {
      const std::size_t begin = index.find('"', at) + 1;
      const std::string name = index.substr(begin, index.find('"', begin) - begin);
      EXPECT_FALSE(folder_.get("made/site/" + name).empty()) << name;
    }
  }
  // A folder that is there needs no slash.
  EXPECT_EQ(folder_.rigor("report robots/sane.sdf -o made --no-simulate").exit, 0);
  EXPECT_FALSE(folder_.get("made/index.html").empty());
}

TEST_F(ReportCli, TheVerdictOfASimulationDecidesToo) {
  // Its center of mass is far beside what it stands on.
  folder_.put("leaning.sdf", crate("leaning", "<pose>0.3 0 0 0 0 0</pose>" + std::string(kSound)));
  const std::string quiet = " --ignore inertia,geometry -o report.html";
  EXPECT_EQ(folder_.rigor("report leaning.sdf --no-simulate" + quiet).exit, 0);
  EXPECT_EQ(folder_.rigor("report leaning.sdf" + quiet).exit, 1);
  EXPECT_NE(folder_.get("report.html").find(">fail<"), std::string::npos);
  EXPECT_EQ(folder_.rigor("report leaning.sdf --fail-on never" + quiet).exit, 0);
}

/// Models of files of one name are told apart by their folders, what has no collisions has nothing to fail,
/// and details are folded.
TEST_F(ReportCli, FilesOfOneNameAreToldApartAndDetailsAreFolded) {
  folder_.put("named/left/model.sdf", crate("", kSound));
  folder_.put("named/right/model.sdf", crate("", kSound));
  folder_.put("named/camera.sdf",
              "<sdf version='1.9'><model name='camera'><link name='l'><inertial><mass>1</mass>"
              "</inertial><sensor name='c' type='camera'/></link></model></sdf>\n");
  folder_.rigor("report named --no-pictures -o report.html");
  const std::string page = folder_.get("report.html");
  for (const char* name : {"left/model.sdf", "right/model.sdf"}) {
    EXPECT_NE(page.find(">" + std::string(name) + "<"), page.npos) << name;
  }
  EXPECT_EQ(row(page, "camera.sdf").find(">fail<"), page.npos);
  EXPECT_NE(page.find("has no collisions"), page.npos);
  EXPECT_NE(page.find("<details"), page.npos);
  EXPECT_EQ(page.find("<details open"), page.npos);
}

TEST_F(ReportCli, ABudgetIsADemand) {
  folder_.put("mesh.sdf",
              "<sdf version='1.9'><model name='m'><static>true</static><link name='l'><visual "
              "name='v'><geometry><mesh><uri>m.obj</uri></mesh></geometry></visual><visual "
              "name='w'><geometry><mesh><uri>m.obj</uri></mesh></geometry></visual></link></model>"
              "</sdf>");
  folder_.put("m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  const std::string report = "report mesh.sdf --no-simulate -o report.html --budget visual=";
  EXPECT_EQ(folder_.rigor(report + "8").exit, 0);
  EXPECT_EQ(folder_.get("report.html").find("over budget"), std::string::npos);
  EXPECT_EQ(folder_.rigor(report + "7").exit, 1);
  EXPECT_NE(folder_.get("report.html").find("over budget"), std::string::npos);
  EXPECT_EQ(folder_.rigor(report + "7 --fail-on never").exit, 0);
}

TEST_F(ReportCli, BadInvocationsAreRefused) {
  const auto refused = [this](const std::string& arguments, const std::string& words) {
    const Ran ran = folder_.rigor("report " + arguments);
    EXPECT_EQ(ran.exit, 2) << arguments;
    EXPECT_NE(ran.err.find(words), std::string::npos) << arguments << ": " << ran.err;
  };
  refused("robots", "--out");
  refused("robots -o report.pdf", "FOLDER/");
  refused("- -o report.html", "stdin");
  refused("robots -o report.html --test setle", "did you mean");
  refused("robots -o report.html --budget visua=3", "did you mean");
  refused("robots -o report.html --budget visual=many", "triangles");
  refused("robots -o no/such/report.html --no-simulate", "no/such");
  refused("gone.sdf -o report.html", "gone.sdf");
}

}  // namespace
}  // namespace rigor::test
