// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Nothing is lost in silence. For every element and attribute of the schemas one document is made in
// which it stands, with a value that is not the default: taking it away, and giving it another value,
// must change what is written, or the account must have a line about it.

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/convert/sdf/robot.h>
#include <rigor/convert/urdf_to_sdf.h>

#include "convert/converted.h"
#include "convert/schema_fixture.h"
#include "robot/robots.h"
#include "support/part.h"
#include "support/workers.h"

namespace rigor::convert {
namespace {

using test::Plant;
using test::SchemaPlace;
using test::WordTable;

constexpr std::string_view kOneTriangle =
    "solid t\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
    "endfacet\nendsolid t\n";

/// What a conversion says and writes, without the head comment, which counts.
struct Said {
  std::string body;  ///< empty where nothing is written
  Notes notes;
};

Said said_of(std::string text, const std::string& path) {
  const std::string other =
      "<sdf version='1.5'><model name='o'><link name='ol'/><link name='ol2'><pose>1 2 3 0 0 "
      "0.5</pose>"
      "</link><joint name='oj' type='fixed'><parent>ol</parent><child>ol2</child></joint>"
      "</model></sdf>";
  const std::string bigger = test::with(other, "1 2 3", "1 2 4");
  const MemoryDisk disk(std::map<std::string, std::string>{{path, std::move(text)},
                                                           {"a.stl", std::string(kOneTriangle)},
                                                           {"b.stl", std::string(kOneTriangle)},
                                                           {"a.sdf", other},
                                                           {"b.sdf", bigger}});
  const test::ReadRobot read(disk, path);
  const bool sdf = read.loaded.root.format == model::Format::kSdf;
  const Source source{read.loaded.root,
                      read.frames,
                      read.documents,
                      read.resolver,
                      sdf ? test::sdf_schema() : test::urdf_schema(),
                      test::workers(),
                      path};
  if (sdf) {
    UrdfConversion result = sdf_to_urdf(source, {.roots = RootPolicy::kAddRoot});
    return {result.robot ? urdf_text(*result.robot) : "", std::move(result.account.notes)};
  }
  SdfConversion result = urdf_to_sdf(source, {});
  return {result.robot ? sdf_text(*result.robot) : "", std::move(result.account.notes)};
}

/// But for where it stands: what stands before it may have grown.
bool is_same_line(const Note& a, const Note& b) {
  return a.kind == b.kind && a.outcome == b.outcome && a.subject == b.subject &&
         a.written == b.written && a.instead == b.instead && a.count == b.count;
}

bool has_line(const Notes& notes, const Note& line) {
  return std::any_of(notes.begin(), notes.end(),
                     [&line](const Note& note) { return is_same_line(note, line); });
}

/// A line that refers to what stands there (bytes of the document).
bool speaks_of(const Note& note, std::size_t begin, std::size_t end) {
  return note.where.begin >= begin && note.where.end <= end;
}

/// A place in a document, and who holds it.
struct Grown {
  std::string text;
  std::string name;                ///< of the element
  std::size_t begin = 0, end = 0;  ///< of the element, or of the tag that has the attribute
  std::vector<std::pair<std::size_t, std::size_t>> above;  ///< tags of the elements around it
};

bool tells(const Said& said, const Grown& grown, const Said& without) {
  for (const Note& note : said.notes) {
    if (speaks_of(note, grown.begin, grown.end) && !(has_line(without.notes, note))) return true;
    // A subtree that is lost as a whole has one line, with the number of what is in it.
    for (const auto& [begin, end] : grown.above) {
      if (speaks_of(note, begin, end) && !has_line(without.notes, note)) return true;
    }
  }
  return false;
}

/// That holds whichever value it has: lost, or expressed otherwise.
bool is_told(const Said& said, const Grown& grown) {
  for (const Note& note : said.notes) {
    if (speaks_of(note, grown.begin, grown.end)) return true;
    for (const auto& [begin, end] : grown.above) {
      const bool named = note.count > 1 || note.written.find(grown.name) != std::string::npos;
      const bool whole = note.outcome == Outcome::kLost || note.outcome == Outcome::kImplied;
      if (whole && named && speaks_of(note, begin, end)) return true;
    }
  }
  return false;
}

/// One format, one version, one robot.
struct Bench {
  Plant document;
  std::vector<std::string> host;  ///< the way from the document's root to what is filled
  schema::Node node;              ///< of the host
  WordTable words;
  std::string path = "robot.sdf";
};

Plant* host_of(const Bench& bench, Plant& document) {
  Plant* at = &document;
  for (const std::string& step : bench.host) at = at->child(step);
  return at;
}

Grown written(Plant document, const Bench& bench, const std::vector<std::string>& way) {
  Grown grown;
  grown.text = write_plant(document);
  Plant* at = host_of(bench, document);
  for (const std::string& step : way) {
    grown.above.emplace_back(at->begin, at->tag_end);
    at = at->child(step);
  }
  grown.name = at->name;
  grown.begin = at->begin;
  grown.end = at->end;
  return grown;
}

/// Whether the place's element may hold what no schema knows.
bool holds_anything(schema::Node host, const SchemaPlace& place) {
  for (const std::string& step : place.path) host = host.child(step).value();
  return host.open();
}

/// What is silent at this place; empty when nothing is.
std::string silent_at(const Bench& bench, const SchemaPlace& place,
                      const std::function<void(Plant&)>& arrange) {
  const auto first = value_of(place, 0, bench.words);
  if (place.node.type() == schema::Type::kNone && place.node.required_attributes().empty() &&
      place.node.required_children().empty() && !place.node.open()) {
    return {};  // an element that says nothing by itself: what it may hold is a place of its own
  }
  Plant with = bench.document;
  arrange(*host_of(bench, with));
  const auto way = grow(*host_of(bench, with), bench.node, place, bench.words);
  Plant& leaf = *way.back();
  Plant without = with;
  if (leaf.children.empty() && holds_anything(bench.node, place)) leaf.must("odd").text = "1";
  if (place.attribute.empty()) {
    if (place.node.type() != schema::Type::kNone) leaf.text = first.value_or("");
    without = with;
    Plant* parent = host_of(bench, without);
    for (std::size_t i = 0; i + 1 < place.path.size(); ++i) parent = parent->child(place.path[i]);
    const auto gone = std::find_if(parent->children.begin(), parent->children.end(),
                                   [&](const Plant& p) { return p.name == place.path.back(); });
    parent->children.erase(gone);
  } else {
    std::erase_if(leaf.attributes, [&](const auto& a) { return a.first == place.attribute; });
    without = with;
    leaf.attributes.emplace_back(place.attribute, first.value_or(""));
  }
  const Grown full = written(with, bench, place.path);
  const Said said = said_of(full.text, bench.path);
  const Said bare = said_of(write_plant(without), bench.path);
  if (said.body.empty() && bare.body.empty() && !said.notes.empty()) return {};  // refused
  if (said.body == bare.body && !tells(said, full, bare)) return "taken away: " + full.text;

  const auto second = value_of(place, 1, bench.words);
  if (!second) return {};
  if (place.attribute.empty()) {
    leaf.text = *second;
  } else {
    *leaf.attribute(place.attribute) = *second;
  }
  const Said other = said_of(write_plant(with), bench.path);
  if (said.body == other.body && !is_told(said, full)) return "changed: " + full.text;
  return {};
}

bool enter_all(const std::vector<std::string>&) { return true; }

// --- SDF ---

const WordTable kSdfWords{
    {"@relative_to", {"base", "tip"}},
    {"@expressed_in", {"base", "tip"}},
    {"@attached_to", {"base", "tip"}},
    {"@canonical_link", {"tip", "toe"}},
    {"@placement_frame", {"base", "tip"}},
    {"include/placement_frame", {"ol2", "ol"}},
    {"include/uri", {"a.sdf", "b.sdf"}},
    {"mesh/uri", {"a.stl", "b.stl"}},
    {"mimic/@joint", {"wrist", "elbow"}},
    {"mimic/@axis", {"axis2", "axis"}},
    {"joint/parent", {"base", "tip"}},
    {"joint/child", {"arm", "spare"}},
    {"joint/@type", {"revolute", "prismatic"}},
    {"gearbox_reference_body", {"base", "tip"}},
    {"@frame", {"base", "tip"}},
};

Plant plant(std::string name, std::vector<std::pair<std::string, std::string>> attributes,
            std::string text, std::vector<Plant> children = {}) {
  return {std::move(name), std::move(attributes), std::move(text), std::move(children)};
}

Plant sdf_shape(const std::string& kind, const std::string& name) {
  return plant(kind, {{"name", name}}, "",
               {plant("geometry", {}, "", {plant("box", {}, "", {plant("size", {}, "1 2 3")})})});
}

Plant sdf_body(const std::string& name, const std::string& pose) {
  return plant(
      "link", {{"name", name}}, "",
      {plant("pose", {}, pose),
       plant("inertial", {}, "",
             {plant("mass", {}, "2"),
              plant("inertia", {}, "",
                    {plant("ixx", {}, "0.3"), plant("iyy", {}, "0.4"), plant("izz", {}, "0.5")})}),
       sdf_shape("visual", name + "_v"), sdf_shape("collision", name + "_c")});
}

Plant sdf_turn(const std::string& name, const std::string& parent, const std::string& child) {
  return plant("joint", {{"name", name}, {"type", "revolute"}}, "",
               {plant("parent", {}, parent), plant("child", {}, child),
                plant("axis", {}, "",
                      {plant("xyz", {}, "0 0 1"),
                       plant("limit", {}, "",
                             {plant("lower", {}, "-1"), plant("upper", {}, "1"),
                              plant("effort", {}, "5"), plant("velocity", {}, "6")})})});
}

std::vector<Plant> sdf_parts() {
  return {sdf_body("arm", "0 0 0.5 0.3 0.2 0.1"), sdf_turn("shoulder", "base", "arm"),
          sdf_body("base", "0 0 0 0.5 0 0.25"),   sdf_body("tip", "0 0 1 0.5 0 0"),
          sdf_body("toe", "0 0 1.5 0 0.5 0"),     sdf_turn("wrist", "base", "tip"),
          sdf_turn("elbow", "tip", "toe")};
}

Bench sdf_bench(int minor) {
  const schema::Node sdf = test::sdf_schema().root("sdf", schema::Version{minor}).value();
  Plant document = plant("sdf", {{"version", "1." + std::to_string(minor)}}, "",
                         {plant("model", {{"name", "m"}}, "", sdf_parts())});
  return {std::move(document), {"model"}, sdf.child("model").value(), kSdfWords};
}

/// A geometry holds one shape.
void clear_shapes(Plant& model) {
  for (Plant& link : model.children) {
    for (Plant& part : link.children) {
      if (Plant* geometry = part.child("geometry")) geometry->children.clear();
    }
  }
}

/// Of another than the robot's boxes; `empty` stands beside them.
bool is_other_shape(const std::string& name) {
  const std::size_t at = name.find("geometry/");
  if (at == std::string::npos) return false;
  const std::string shape = name.substr(at + 9);
  return !shape.starts_with("box") && !shape.starts_with("@");
}

/// Looks at every place of a bench, or with sanitizers at a part of them, but those that `skip` names, and tells where silence is.
class SilenceFinder {
 public:
  using Skip = std::function<bool(const SchemaPlace&)>;

  void look(const Bench& bench, const std::string& title, const Skip& skip = {}) {
    for (const SchemaPlace& place : test::places_of(bench.node, enter_all)) {
      const std::string name = place.name();
      if ((skip && skip(place)) || !test::in_part(title + ' ' + name)) continue;
      ++places_;
      const std::string silent = silent_at(
          bench, place, is_other_shape(name) ? clear_shapes : [](Plant&) {});
      if (silent.empty()) continue;
      ++silent_;
      lines_ += title + ' ' + name + ' ' + silent + '\n';
    }
  }

  std::size_t places() const { return places_; }
  std::string report() const {
    return lines_.empty()
               ? ""
               : std::to_string(silent_) + " of " + std::to_string(places_) + '\n' + lines_;
  }

 private:
  std::size_t places_ = 0, silent_ = 0;
  std::string lines_;
};

TEST(SilentLoss, ThereIsNoneOfWhatAnSdfModelMayHold) {
  SilenceFinder finder;
  for (const int minor : {6, 12}) {
    finder.look(sdf_bench(minor), "1." + std::to_string(minor));
  }
  EXPECT_GT(finder.places(), test::part_of(2000));
  EXPECT_EQ(finder.report(), "");
}

bool begins(const SchemaPlace& place, std::string_view start) {
  return place.name().starts_with(start);
}

/// What only decides what the rest of an element means, or cannot stand beside what else is there.
bool is_alternative(const SchemaPlace& place) {
  const std::string name = place.name();
  if (begins(place, "joint/sensor/")) return true;  // as those of links
  if (begins(place, "include") || begins(place, "model/") || name == "model" ||
      name == "self_collide" || begins(place, "/@") || begins(place, "pose/@"))
    return true;
  for (const char* end : {"@rotation_format", "@degrees", "inertial/@auto", "static",
                          "frame/@attached_to", "ode/provide_feedback"}) {
    if (test::ends_with_place(name, end)) return true;
  }
  return is_other_shape(name);
}

TEST(SilentLoss, ThereIsNoneInAModelThatHoldsEverything) {
  Bench bench = sdf_bench(12);
  for (const SchemaPlace& place : test::places_of(bench.node, enter_all)) {
    if (is_alternative(place)) continue;
    Plant& leaf = *grow(*host_of(bench, bench.document), bench.node, place, bench.words).back();
    const std::string value = value_of(place, 0, bench.words).value_or("");
    if (place.attribute.empty()) {
      if (place.node.type() != schema::Type::kNone) leaf.text = value;
    } else if (leaf.attribute(place.attribute) == nullptr) {
      leaf.attributes.emplace_back(place.attribute, value);
    }
  }
  Plant everything = bench.document;
  ASSERT_FALSE(said_of(write_plant(everything), bench.path).body.empty());
  SilenceFinder finder;
  finder.look(bench, "all", is_alternative);
  EXPECT_GT(finder.places(), test::part_of(700));
  EXPECT_EQ(finder.report(), "");
}

TEST(SilentLoss, ThereIsNoneInAJointOfAnyType) {
  SilenceFinder finder;
  for (const char* type :
       {"continuous", "prismatic", "fixed", "ball", "universal", "revolute2", "screw", "gearbox"}) {
    Bench bench = sdf_bench(12);
    *host_of(bench, bench.document)->child("joint")->attribute("type") = type;
    finder.look(bench, type, [](const SchemaPlace& place) {
      return !begins(place, "joint/") || begins(place, "joint/sensor/");
    });
  }
  EXPECT_EQ(finder.report(), "");
}

TEST(SilentLoss, ThereIsNoneInAnAutomaticInertial) {
  SilenceFinder finder;
  Bench bench = sdf_bench(12);
  host_of(bench, bench.document)->child("link")->child("inertial")->attributes = {{"auto", "true"}};
  finder.look(bench, "auto", [](const SchemaPlace& place) {
    return !begins(place, "link/inertial") && !begins(place, "link/collision");
  });
  EXPECT_EQ(finder.report(), "");
}

TEST(SilentLoss, ThereIsNoneInANestedModel) {
  SilenceFinder finder;
  Bench bench = sdf_bench(12);
  bench.document.child("model")->children.push_back(
      plant("model", {{"name", "inner"}}, "", sdf_parts()));
  bench.host = {"model", "model"};
  finder.look(bench, "nested",
              [](const SchemaPlace& place) { return begins(place, "joint/sensor/"); });
  EXPECT_EQ(finder.report(), "");
}

TEST(SilentLoss, ThereIsNoneOfWhatIsAroundTheModel) {
  SilenceFinder finder;
  for (const int minor : {12}) {
    const schema::Node sdf = test::sdf_schema().root("sdf", schema::Version{minor}).value();
    Bench bench = sdf_bench(minor);
    Plant model = *bench.document.child("model");
    bench.document.children = {plant("world", {{"name", "w"}}, "", {std::move(model)})};
    bench.host = {"world"};
    bench.node = sdf.child("world").value();
    finder.look(bench, "world", [](const SchemaPlace& place) { return begins(place, "model"); });
  }
  Bench bench = sdf_bench(6);
  bench.host = {};
  bench.node = test::sdf_schema().root("sdf", schema::Version{6}).value();
  finder.look(bench, "sdf", [](const SchemaPlace& place) {
    return begins(place, "model") || begins(place, "world") || begins(place, "/@version");
  });
  EXPECT_EQ(finder.report(), "");
}

// --- URDF ---

const WordTable kUrdfWords{
    {"parent/@link", {"base", "tip"}},
    {"child/@link", {"arm", "spare"}},
    {"mimic/@joint", {"wrist", "elbow"}},
    {"joint/@type", {"revolute", "prismatic"}},
    {"mesh/@filename", {"a.stl", "b.stl"}},
    {"texture/@filename", {"a.png", "b.png"}},
    {"link/visual/material/@name", {"red", "blue"}},
    {"@quat_xyzw", {"0 0 0.6 0.8", "0 0.6 0 0.8"}},
    {"gazebo/@reference", {"arm", "tip"}},
    {"link/@name", {"arm", "stray"}},
};

Plant urdf_inertial_plant() {
  return plant("inertial", {}, "",
               {plant("mass", {{"value", "2"}}, ""), plant("inertia",
                                                           {{"ixx", "0.3"},
                                                            {"ixy", "0"},
                                                            {"ixz", "0"},
                                                            {"iyy", "0.4"},
                                                            {"iyz", "0"},
                                                            {"izz", "0.5"}},
                                                           "")});
}

Plant urdf_body(const std::string& name) {
  const Plant geometry = plant("geometry", {}, "", {plant("box", {{"size", "1 2 3"}}, "")});
  return plant("link", {{"name", name}}, "",
               {urdf_inertial_plant(), plant("visual", {}, "", {geometry}),
                plant("collision", {}, "", {geometry})});
}

Plant urdf_turn(const std::string& name, const std::string& parent, const std::string& child) {
  return plant(
      "joint", {{"name", name}, {"type", "revolute"}}, "",
      {plant("parent", {{"link", parent}}, ""), plant("child", {{"link", child}}, ""),
       plant("origin", {{"xyz", "0 0 1"}}, ""), plant("axis", {{"xyz", "0 0 1"}}, ""),
       plant("limit", {{"lower", "-1"}, {"upper", "1"}, {"effort", "5"}, {"velocity", "6"}}, "")});
}

Bench urdf_bench(int minor) {
  Plant robot = plant(
      "robot", {{"name", "m"}}, "",
      {urdf_body("arm"), urdf_body("base"), urdf_body("tip"), urdf_body("toe"),
       urdf_turn("shoulder", "base", "arm"), urdf_turn("wrist", "base", "tip"),
       urdf_turn("elbow", "tip", "toe"),
       plant("material", {{"name", "spare"}}, "", {plant("color", {{"rgba", "0 0 1 1"}}, "")})});
  if (minor > 0) robot.attributes.emplace_back("version", "1." + std::to_string(minor));
  return {std::move(robot),
          {},
          test::urdf_schema().root("robot", schema::Version{minor}).value(),
          kUrdfWords,
          "robot.urdf"};
}

TEST(SilentLoss, ThereIsNoneOfWhatAUrdfMayHold) {
  SilenceFinder finder;
  for (const int minor : {0, 1, 2})
    finder.look(urdf_bench(minor), "urdf 1." + std::to_string(minor),
                [](const SchemaPlace& place) { return begins(place, "/@version"); });
  EXPECT_EQ(finder.report(), "");
}

TEST(SilentLoss, ThereIsNoneInAUrdfJointOfAnyType) {
  SilenceFinder finder;
  for (const char* type : {"continuous", "prismatic", "fixed", "floating", "planar"}) {
    Bench bench = urdf_bench(2);
    *bench.document.child("joint")->attribute("type") = type;
    finder.look(bench, type, [](const SchemaPlace& place) { return !begins(place, "joint/"); });
  }
  EXPECT_EQ(finder.report(), "");
}

TEST(SilentLoss, ThereIsNoneInAUrdfLinkWithoutMass) {
  SilenceFinder finder;
  for (const char* type : {"revolute", "fixed"}) {
    Bench bench = urdf_bench(2);
    *bench.document.child("joint")->attribute("type") = type;
    Plant* link = bench.document.child("link");
    link->children.erase(link->children.begin());
    finder.look(bench, type, [](const SchemaPlace& place) { return !begins(place, "link/"); });
  }
  EXPECT_EQ(finder.report(), "");
}

/// The keys of Gazebo's reader of URDF and others; a block is open, so the schema has no names for them.
TEST(SilentLoss, ThereIsNoneOfTheKeysOfBlocks) {
  constexpr const char* kValues[][3] = {{"mu1", "0.25", "0.5"},
                                        {"mu2", "0.25", "0.5"},
                                        {"mu", "0.25", "0.5"},
                                        {"fdir1", "1 0 0", "0 1 0"},
                                        {"kp", "10", "20"},
                                        {"kd", "10", "20"},
                                        {"maxVel", "1", "2"},
                                        {"minDepth", "1", "2"},
                                        {"maxContacts", "3", "4"},
                                        {"laserRetro", "3", "4"},
                                        {"selfCollide", "true", "false"},
                                        {"self_collide", "true", "false"},
                                        {"gravity", "false", "true"},
                                        {"turnGravityOff", "true", "false"},
                                        {"dampingFactor", "0.5", "0.25"},
                                        {"material", "Gazebo/Red", "Gazebo/Blue"},
                                        {"static", "true", "false"},
                                        {"stopCfm", "0.5", "0.25"},
                                        {"stopErp", "0.5", "0.25"},
                                        {"fudgeFactor", "0.5", "0.25"},
                                        {"cfmDamping", "true", "false"},
                                        {"implicitSpringDamper", "true", "false"},
                                        {"provideFeedback", "true", "false"},
                                        {"springReference", "0.5", "0.25"},
                                        {"springStiffness", "0.5", "0.25"},
                                        {"odd", "1", "2"},
                                        {"gripper", "1", "2"},
                                        {"bounce", "0.5", "0.25"},
                                        {"rolling_friction", "1", "2"},
                                        {"projector", "1", "2"}};
  std::string silent;
  for (const char* reference : {"", "arm", "shoulder", "hand", "nobody"}) {
    for (const char* type : {"revolute", "fixed"}) {
      for (const auto& [key, first, second] : kValues) {
        const auto document = [&, &key = key](const std::string& content) {
          Plant robot = urdf_bench(0).document;
          *robot.child("joint")->attribute("type") = type;
          Plant block = plant("gazebo", {}, "");
          if (reference[0] != 0) block.attributes.emplace_back("reference", reference);
          if (!content.empty()) block.children.push_back(plant(key, {}, content));
          robot.children.push_back(std::move(block));
          robot.children.push_back(plant("link", {{"name", "hand"}}, ""));
          robot.children.push_back(urdf_turn("grip", "arm", "hand"));
          *robot.children.back().attribute("type") = type;
          return robot;
        };
        Plant with = document(first);
        Grown grown;
        grown.text = write_plant(with);
        const Plant& block = *with.child("gazebo");
        grown.name = key;
        grown.begin = block.children[0].begin;
        grown.end = block.children[0].end;
        grown.above = {{block.begin, block.children[0].begin}};
        Plant without = document(""), changed = document(second);
        const Said said = said_of(grown.text, "robot.urdf");
        const Said bare = said_of(write_plant(without), "robot.urdf");
        const Said other = said_of(write_plant(changed), "robot.urdf");
        const std::string where = std::string(reference) + " (" + type + ") " + key;
        if (said.body == bare.body && !tells(said, grown, bare)) silent += where + " taken\n";
        if (said.body == other.body && !is_told(said, grown)) silent += where + " changed\n";
      }
    }
  }
  EXPECT_EQ(silent, "");
}

}  // namespace
}  // namespace rigor::convert
