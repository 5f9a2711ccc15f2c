// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/fix.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <rigor/author/edit_set.h>
#include <rigor/author/patched_text.h>
#include <rigor/mass/mesh/survey.h>
#include <rigor/read/load.h>
#include <rigor/report/inspect/inspect.h>
#include <rigor/rules/environment.h>
#include <rigor/rules/example.h>
#include <rigor/rules/validate.h>

#include "support/part.h"

namespace rigor::author {
namespace {

constexpr Applicability kSafe = Applicability::kSafe;
constexpr Applicability kUnsafe = Applicability::kUnsafe;

/// A model's text with something in its link.
std::string with_link(const std::string& inside) {
  return "<sdf version=\"1.9\">\n  <model name=\"box\">\n    "
         "<static>true</static>\n    <link name=\"body\">\n" +
         inside + "    </link>\n  </model>\n</sdf>\n";
}

std::vector<FixedFile> fix(const MemoryDisk& disk, rules::ValidateOptions options,
                           Applicability most) {
  const Environment environment(disk, {});
  Sources sources;
  const auto result = rules::validate(environment, options, sources);
  return fix_files(environment, options, result, sources, most);
}

/// Of a file on its own.
FixedFile fix(const std::string& bytes, Applicability most, rules::Selection selection = {}) {
  MemoryDisk disk;
  disk.put("a.sdf", bytes);
  auto files = fix(disk, {.paths = {"a.sdf"}, .selection = std::move(selection)}, most);
  EXPECT_LE(files.size(), 1U);
  if (files.empty()) return {.path = "a.sdf", .before = bytes, .after = bytes};
  EXPECT_EQ(files.front().before, bytes);
  EXPECT_EQ(apply_edits(bytes, files.front().edits), files.front().after);
  EXPECT_EQ(files.front().changed(), files.front().after != bytes);
  return std::move(files.front());
}

TEST(Fix, RenamesWhatARenamedElementUncovers) {
  const auto fixed = fix(with_link("      <Visual name=\"v\">\n"
                                   "        <Geometry><Sphere "
                                   "><radius>1</radius></Sphere\n></Geometry>\n"
                                   "      </Visual>\n"),
                         kUnsafe, {.select = {"wrong-case-element"}});
  EXPECT_EQ(fixed.after, with_link("      <visual name=\"v\">\n"
                                   "        <geometry><sphere "
                                   "><radius>1</radius></sphere\n></geometry>\n"
                                   "      </visual>\n"));
  EXPECT_EQ(fixed.applied.at("wrong-case-element"), 3U);
  EXPECT_TRUE(fixed.settled);
  EXPECT_TRUE(fixed.held_back.empty());
}

TEST(Fix, DoesUnsafeOnesOnlyWhenAsked) {
  const std::string text = with_link("      <Light name=\"lamp\" type=\"point\"/>\n");
  EXPECT_FALSE(fix(text, kSafe).changed());
  EXPECT_TRUE(fix(text, kUnsafe).changed());
}

TEST(Fix, DoesNothingOfRulesThatAreOff) {
  const std::string text = with_link("      <light name=\"lamp\"type=\"point\"/>\n");
  EXPECT_TRUE(fix(text, kSafe).changed());
  EXPECT_FALSE(fix(text, kSafe, {.ignore = {"xml-attributes-touch"}}).changed());
  EXPECT_FALSE(fix(text, kSafe, {.select = {"inertia"}}).changed());
}

TEST(Fix, KeepsLineEndsMarksAndWhatIsMissingAtTheEnd) {
  const std::string head =
      "\xEF\xBB\xBF<?xml version='1.0'?>\r\n<sdf "
      "version='1.9'>\r\n\t<model name='m'>\r"
      "<static>1</static><link name='a'><light name='l'";
  const std::string tail = "type='point'/>\r\n\r\n</link> <!-- é -->\t</model></sdf>";
  EXPECT_EQ(fix(head + tail, kSafe).after, head + " " + tail);
}

/// Visuals, the second of which nobody sees; as it is now, or as it should be.
std::string hidden_visual(const std::string& element, const std::string& first,
                          const std::string& second) {
  return "      <visual name=\"" + first + "\"/>\n      <" + element + " name=\"" + second +
         "\"/>\n";
}

TEST(Fix, UndoesAFixThatWouldMakeSomethingWorse) {
  const std::string taken = hidden_visual("Visual", "a", "a");  // the name would be there twice
  const auto fixed = fix(with_link(taken + hidden_visual("Visual", "b", "c")), kUnsafe,
                         {.select = {"wrong-case-element", "naming"}});
  EXPECT_EQ(fixed.after, with_link(taken + hidden_visual("visual", "b", "c")));
  EXPECT_EQ(fixed.applied.at("wrong-case-element"), 1U);
  ASSERT_EQ(fixed.held_back.size(), 1U);
  EXPECT_EQ(fixed.held_back[0].why, HeldBack::kBringsFinding);
  EXPECT_TRUE(fixed.settled);
}

TEST(Fix, SaysWhatAFixWouldBring) {
  MemoryDisk disk;
  disk.put("a.sdf", with_link("<visual name=\"v\"><geometry><mesh><uri>meshes/Hull.stl</uri></mesh>"
                              "</geometry></visual>\n"));
  disk.put("meshes/hull.stl", "this is no mesh");
  const auto files = fix(disk, {.paths = {"a.sdf"}}, kUnsafe);
  ASSERT_EQ(files.size(), 1U);
  EXPECT_FALSE(files[0].changed());
  ASSERT_EQ(files[0].held_back.size(), 1U);
  EXPECT_EQ(files[0].held_back[0].rule, "mesh-case-mismatch");
  EXPECT_EQ(files[0].held_back[0].why, HeldBack::kBringsFinding);
  EXPECT_TRUE(files[0].held_back[0].brings.starts_with("mesh-"));
  EXPECT_TRUE(files[0].settled);
}

/// A tetrahedron as ASCII STL, without its last face.
std::string open_tetrahedron() {
  std::string text = "solid hull\n";
  for (const char* face : {"0 0 0  0 1 0  1 0 0", "0 0 0  1 0 0  0 0 1", "0 0 0  0 0 1  0 1 0"}) {
    std::istringstream numbers(face);
    double x = 0;
    double y = 0;
    double z = 0;
    text += "facet normal 0 0 0\nouter loop\n";
    while (numbers >> x >> y >> z) text += fmt::format("vertex {} {} {}\n", x, y, z);
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid hull\n";
}

TEST(Fix, OfAnErrorMayRevealAWarning) {
  MemoryDisk disk;
  disk.put("a.sdf",
           with_link("<collision name=\"c\"><geometry><mesh><uri>meshes/Hull.stl</uri></mesh>"
                     "</geometry></collision>\n"));
  disk.put("meshes/hull.stl", open_tetrahedron());
  const Environment environment(disk, {});
  const auto severities = [&](const std::string& bytes) {
    rules::ValidateOptions options;
    options.buffer = {"a.sdf", bytes};
    Sources sources;
    std::map<Severity, int> count;
    const rules::ValidateResult result = rules::validate(environment, options, sources);
    for (const Diagnostic& found : result.diagnostics.list()) ++count[found.severity];
    return count;
  };
  const auto files = fix(disk, {.paths = {"a.sdf"}}, kUnsafe);
  ASSERT_EQ(files.size(), 1U);
  // The mesh that could not be found is open, which nobody could know before.
  EXPECT_NE(files[0].after.find("meshes/hull.stl"), std::string::npos);
  EXPECT_TRUE(files[0].held_back.empty());
  EXPECT_LT(severities(files[0].after)[Severity::kError],
            severities(files[0].before)[Severity::kError]);
  EXPECT_GT(severities(files[0].after)[Severity::kWarning],
            severities(files[0].before)[Severity::kWarning]);
}

/// A model that moves, with these parts of a link.
std::string moving(const std::string& inertial, const std::string& size) {
  return "<sdf version=\"1.9\"><model name=\"m\"><link name=\"a\">" + inertial +
         "<collision name=\"c\"><geometry><box><size>" + size +
         "</size></box></geometry></collision></link></model></sdf>\n";
}

/// Of which each number is the author's: 2 kg in a cubic meter are little, but no reason not to read them.
TEST(Fix, WritesTheInertialOfUrdfAsThatOfSdf) {
  const auto fixed = fix(moving("<inertial><mass value=\"2\"/><inertia ixx=\"0.1\" iyy=\"0.2\" "
                                "izz=\"0.2\"/></inertial>",
                                "1 1 1"),
                         kUnsafe);
  EXPECT_EQ(fixed.after, moving("<inertial><mass>2</mass><inertia><ixx>0.1</ixx><iyy>0.2</iyy>"
                                "<izz>0.2</izz></inertia></inertial>",
                                "1 1 1"));
}

/// In 1.9 <inertia> has no attributes, so a moment is missing: nobody knows whether the one in the
/// attribute is older than the others.
TEST(Fix, WritesNoInertialOverNumbersThatNobodyReads) {
  const std::string text = moving(
      "<inertial><mass>2</mass><inertia ixx=\"0.1\"><ixx>9</ixx><iyy>9</iyy></inertia></inertial>",
      "0.3 0.3 0.3");
  EXPECT_FALSE(fix(text, kUnsafe).changed());
}

/// 300 m and 50 m were millimeters: no inertia follows from them.
TEST(Fix, WritesNoInertialOfShapesThatAreTooLargeOrTooLight) {
  const std::string inertial =
      "<inertial><mass>5</mass><inertia><ixx>0.01</ixx><iyy>0.01</iyy><izz>0.01</izz></inertia>"
      "</inertial>";
  EXPECT_FALSE(fix(moving(inertial, "300 300 300"), kUnsafe).changed());
  EXPECT_FALSE(fix(moving(inertial, "50 50 50"), kUnsafe).changed());
}

TEST(Fix, MendsXmlThatIsCutWhenThatHelps) {
  const std::string fixed = with_link("      <light name=\"lamp\" type=\"point\"/>\n");
  const std::string twice = with_link(
      "      <light name=\"lamp\" name=\"lamp\" type=\"point\"  "
      "type=\"point\"/>\n");
  EXPECT_EQ(fix(twice, kSafe).after, fixed);
  EXPECT_EQ(fix(twice, kSafe).applied.at("xml-duplicate-attribute"), 2U);
}

TEST(Fix, LeavesXmlThatIsCutElsewhereAlone) {
  const std::string touching = "      <light name=\"lamp\"type=\"point\"/>\n";
  EXPECT_FALSE(fix(with_link(touching) + "</end>", kUnsafe).changed());
  // The first fault can be mended, the second can not.
  const auto half = fix(with_link("      <light name=\"l\" name=\"l\"/>\n      "
                                  "<light name=\"a\" name=\"b\"/>\n"),
                        kSafe);
  EXPECT_FALSE(half.changed());
  EXPECT_TRUE(half.applied.empty());
  ASSERT_FALSE(half.held_back.empty());
  EXPECT_EQ(half.held_back.back().why, HeldBack::kNotXml);
}

TEST(Fix, DoesAllOfManyThoughFewAreListed) {
  std::string wrong;
  std::string right;
  for (int i = 0; i < 70; ++i) {
    const std::string name = "      <light name=\"" + std::to_string(i);
    wrong += name + " & co\" type=\"point\"/>\n";
    right += name + " &amp; co\" type=\"point\"/>\n";
  }
  EXPECT_EQ(fix(with_link(wrong), kSafe).after,
            with_link(right));  // of a fault, 20 are kept

  wrong.clear();
  right.clear();
  for (int i = 0; i < 30; ++i) {
    const std::string name = " name=\"" + std::to_string(i) + "\" type=\"point\"";
    wrong += "      <Light" + name + "/>\n";
    right += "      <light" + name + "/>\n";
  }
  const rules::Selection selection{.select = {"wrong-case-element"}, .max_listed = 7};
  EXPECT_EQ(fix(with_link(wrong), kUnsafe, selection).after, with_link(right));
}

TEST(Fix, FixesFilesThatWereNamedOnly) {
  MemoryDisk disk;
  disk.put("world.sdf",
           "<sdf version='1.9'><world "
           "name='w'><include><uri>box</uri></include></world></sdf>");
  disk.put("box/model.config", "<model><name>box</name><sdf>model.sdf</sdf></model>");
  disk.put("box/model.sdf", with_link("      <light name=\"lamp\"type=\"point\"/>\n"));
  for (const FixedFile& file : fix(disk, {.paths = {"world.sdf"}}, kUnsafe)) {
    EXPECT_EQ(file.path, "world.sdf");
  }
  const auto files = fix(disk, {.paths = {"world.sdf", "box/model.sdf"}}, kUnsafe);
  ASSERT_FALSE(files.empty());
  EXPECT_EQ(files.back().path, "box/model.sdf");
  EXPECT_TRUE(files.back().changed());
}

TEST(Fix, TakesAUriForUnsafeWhereLinksOrTheirMassComeWithIt) {
  const auto with_mesh = [](const std::string& inertial, const std::string& uri) {
    return with_link("      " + inertial + "<visual name=\"v\"><geometry><mesh><uri>" + uri +
                     "</uri></mesh></geometry></visual>\n");
  };
  const rules::Selection selection{.select = {"uri-backslash"}};
  EXPECT_EQ(fix(with_mesh("", "a\\b.stl"), kSafe, selection).after, with_mesh("", "a/b.stl"));
  const std::string automatic = with_mesh("<inertial auto=\"true\"/>", "a\\b.stl");
  EXPECT_FALSE(fix(automatic, kSafe, selection).changed());
  EXPECT_TRUE(fix(automatic, kUnsafe, selection).changed());
  const std::string include =
      "<sdf version='1.9'><world name='w'><include><uri>a\\b</uri></include></world></sdf>";
  EXPECT_FALSE(fix(include, kSafe, selection).changed());
  EXPECT_TRUE(fix(include, kUnsafe, selection).changed());
}

/// A model's text as a template that has nothing of xacro's in it.
std::string as_template(std::string_view text) {
  std::string result(text);
  const std::size_t at = result.find("<robot");
  return at == result.npos
             ? ""
             : result.insert(at + 6, " xmlns:xacro=\"http://www.ros.org/wiki/xacro\"");
}

TEST(Fix, OfATemplateIsThatOfItsExpansion) {
  const rules::Registry registry;
  std::size_t all = 0;
  std::size_t same = 0;
  std::string others;
  for (const rules::Rule& rule : registry.rules()) {
    if (rule.category == rules::Category::kXml)
      continue;  // a template that is no XML is not expanded
    for (const rules::Example& example : rules::examples_of(rule).bad) {
      const rules::ParsedExample parsed = rules::parse_example(example.text);
      const std::string path = rules::example_path(parsed.files.front());
      const std::string text = as_template(parsed.files.front().bytes);
      if (example.fixed.empty() || !path.ends_with(".urdf") || text.empty()) continue;
      MemoryDisk disk;
      for (const auto& file : parsed.files) disk.put(rules::example_path(file), file.bytes);
      const std::string named = path.substr(0, path.size() - 5) + ".xacro";
      disk.put(named, text);
      const Environment environment(disk, {});
      Sources sources;
      const auto result = rules::validate(
          environment,
          {.paths = {named},
           .selection = {.select = {std::string(rule.name)}, .targets = rule.targets}},
          sources);
      EditSet edits;
      for (const Diagnostic& finding : result.diagnostics.list()) {
        if (finding.rule == rule.name && !finding.fixes.empty())
          edits.take(finding.fixes.front().edits);
      }
      ++all;
      if (apply_edits(text, edits.list()) == as_template(example.fixed)) {
        ++same;
      } else {
        others += std::string(rule.name) + ' ';
      }
    }
  }
  EXPECT_GT(all, 10U);
  // Those fixes change a value and remove an element at once, which is not offered in a template.
  EXPECT_EQ(others, "limit-equal limit-equal missing-attribute ");
  EXPECT_EQ(same + 3, all);
}

TEST(Fix, FixesBytesThatStandInNoFile) {
  const MemoryDisk disk;
  rules::ValidateOptions options;
  options.buffer = {"<stdin>", with_link("      <light name=\"lamp\"type=\"point\"/>\n")};
  const auto files = fix(disk, options, kSafe);
  ASSERT_EQ(files.size(), 1U);
  EXPECT_EQ(files[0].after, with_link("      <light name=\"lamp\" type=\"point\"/>\n"));
}

TEST(Fix, LeavesAFileThatWasWrittenSinceAlone) {
  const std::string text = with_link("      <light name=\"lamp\"type=\"point\"/>\n");
  MemoryDisk disk;
  disk.put("a.sdf", text);
  const Environment environment(disk, {});
  Sources sources;
  const rules::ValidateOptions options{.paths = {"a.sdf"}};
  const auto result = rules::validate(environment, options, sources);
  EXPECT_EQ(fix_files(environment, options, result, sources, kSafe).size(), 1U);
  disk.put("a.sdf", text + "\n");
  EXPECT_TRUE(fix_files(environment, options, result, sources, kSafe).empty());
}

TEST(Fix, BoundsItsTrials) {
  // Every other one would bring a name twice; finding which takes trials.
  std::string inside;
  for (int i = 0; i < 120; ++i) {
    const std::string name = std::to_string(i);
    inside += hidden_visual("Visual", name, i % 2 == 0 ? name : name + "b");
  }
  const rules::Selection selection{.select = {"wrong-case-element", "naming"}};
  const auto fixed = fix(with_link(inside), kUnsafe, selection);
  EXPECT_FALSE(fixed.settled);
  EXPECT_TRUE(fixed.changed());
  EXPECT_TRUE(std::any_of(fixed.held_back.begin(), fixed.held_back.end(),
                          [](const auto& held) { return held.why == HeldBack::kNotTried; }));
}

/// What inspect prints of an example; nothing when it is no XML.
std::string inspected_example(const Environment& environment, const std::string& path,
                              const std::string& bytes) {
  Sources sources;
  read::Workspace workspace(environment.disk, sources);
  const read::Reader reader{workspace, environment.resolver, environment.sdf, environment.urdf};
  const read::Loaded loaded = read::load(reader, workspace.put(path, bytes));
  if (!loaded.file->document->complete()) return "";
  const model::Frames frames(loaded.root);
  mass::MeshSurveys surveys(environment.disk);
  const auto find = [&](const model::Mesh& mesh) -> const mass::MeshSurvey* {
    const auto found = environment.resolver.resolve(mesh.uri.value, path);
    return found.path ? &surveys.find({*found.path, mesh.submesh.value, mesh.center.value})
                      : nullptr;
  };
  return report::inspect_tsv({path, loaded.root, frames, find});
}

TEST(Fix, OfEveryRuleKeepsItsPromise) {
  const rules::Registry registry;
  for (const rules::Rule& rule : registry.rules()) {
    if (rule.category == rules::Category::kConvert || rule.category == rules::Category::kSimulate) {
      continue;
    }
    if (!test::in_part(rule.name)) continue;
    for (const rules::Example& example : rules::examples_of(rule).bad) {
      SCOPED_TRACE(example.text);
      const rules::ParsedExample parsed = rules::parse_example(example.text);
      MemoryDisk disk;
      for (const auto& file : parsed.files) disk.put(rules::example_path(file), file.bytes);
      const std::string path = rules::example_path(parsed.files.front());
      const Environment environment(disk, {});
      for (const Applicability most : {kSafe, kUnsafe}) {
        for (const FixedFile& fixed : fix(disk, {.paths = {path}}, most)) {
          EXPECT_TRUE(fixed.settled);
          rules::ValidateOptions again;
          again.buffer = {path, fixed.after};
          for (const FixedFile& more : fix(disk, again, most)) EXPECT_FALSE(more.changed());
          const std::string before = inspected_example(environment, path, fixed.before);
          if (most == kUnsafe || before.empty()) continue;
          EXPECT_EQ(inspected_example(environment, path, fixed.after), before) << fixed.after;
        }
      }
    }
  }
}

TEST(FixEditSet, TakesAFixAsAWholeOrNotAtAll) {
  const auto edit = [](std::uint32_t begin, std::uint32_t end, const char* text) {
    return Edit{{SourceId{0}, begin, end}, text};
  };
  EditSet set;
  EXPECT_TRUE(set.take({edit(2, 4, "x"), edit(8, 8, "y")}));
  EXPECT_TRUE(set.take({edit(2, 4, "x"), edit(4, 6, "z")}));       // one is there already
  EXPECT_FALSE(set.take({edit(10, 11, ""), edit(3, 5, "q")}));     // overlaps
  EXPECT_FALSE(set.take({edit(8, 8, "other")}));                   // another insertion there
  EXPECT_FALSE(set.take({edit(7, 9, "")}));                        // around it
  EXPECT_FALSE(set.take({edit(20, 25, "a"), edit(22, 23, "b")}));  // overlaps itself
  EXPECT_TRUE(set.take({edit(10, 11, "")}));
  const std::vector<Edit> all{edit(2, 4, "x"), edit(4, 6, "z"), edit(8, 8, "y"), edit(10, 11, "")};
  EXPECT_EQ(set.list(), all);
  EXPECT_EQ(apply_edits("0123456789abcdef", set.list()), "01xz67y89bcdef");
}

/// Edits at random places that do not overlap.
std::vector<Edit> random_edits(const std::string& text, std::mt19937& random) {
  EditSet set;
  for (int i = 0; i < 6; ++i) {
    const auto begin = static_cast<std::uint32_t>(random() % (text.size() + 1));
    const auto end =
        static_cast<std::uint32_t>(std::min<std::size_t>(text.size(), begin + random() % 4));
    set.take({{{kNoSource, begin, end},
               std::string(random() % 4, static_cast<char>('A' + random() % 26))}});
  }
  return set.list();
}

TEST(PatchedText, TellsSeveralRoundsAsOneListOfEdits) {
  std::mt19937 random(5);
  for (int run = 0; run < 3000; ++run) {
    const std::string original = std::string("abcdefghijklmnopqrst").substr(0, random() % 21);
    PatchedText patched(original);
    std::string text = original;
    for (int round = 0; round < 4; ++round) {
      const auto edits = random_edits(text, random);
      text = *apply_edits(text, edits);
      ASSERT_TRUE(patched.apply(edits));
      ASSERT_EQ(patched.text(), text);
    }
    const auto edits = patched.edits(SourceId{3});
    ASSERT_EQ(apply_edits(original, edits), text);
    for (std::size_t i = 0; i < edits.size(); ++i) {
      EXPECT_EQ(edits[i].span.source, SourceId{3});
      EXPECT_NE(original.substr(edits[i].span.begin, edits[i].span.size()), edits[i].text);
      EXPECT_TRUE(i == 0 || edits[i].span.begin > edits[i - 1].span.end);
    }
  }
}

TEST(PatchedText, LeavesBytesThatNoEditNamesAlone) {
  PatchedText patched("0123456789");
  ASSERT_TRUE(patched.apply({{{kNoSource, 2, 3}, "xx"}}));
  ASSERT_TRUE(
      patched.apply({{{kNoSource, 2, 4}, "2"}, {{kNoSource, 8, 9}, ""}}));  // undone; and the 7
  const std::vector<Edit> expected{{{SourceId{0}, 7, 8}, ""}};
  EXPECT_EQ(patched.edits(SourceId{0}), expected);
  EXPECT_FALSE(patched.apply({{{kNoSource, 2, 4}, "a"}, {{kNoSource, 3, 5}, "b"}}));
  EXPECT_EQ(patched.text(), "012345689");
}

TEST(PlacesBefore, FindsWhatStaysWhereItWas) {
  std::mt19937 random(6);
  for (int run = 0; run < 3000; ++run) {
    const std::string original = "abcdefghijklmnopqrst";  // each letter once; edits write capitals
    const auto edits = random_edits(original, random);
    const std::string text = *apply_edits(original, edits);
    const PlacesBefore places(edits);
    for (std::uint32_t i = 0; i < text.size(); ++i) {
      const Span before = places.of({kNoSource, i, i + 1});
      if (text[i] >= 'a') {
        EXPECT_EQ(before.begin, original.find(text[i]));
        EXPECT_EQ(before.size(), 1U);
        continue;
      }
      // Written by an edit: the place is the edit's.
      bool is_one = false;
      for (const Edit& edit : edits) {
        is_one = is_one || (edit.span.begin == before.begin && edit.span.end == before.end);
      }
      EXPECT_TRUE(is_one);
    }
  }
}

}  // namespace
}  // namespace rigor::author
