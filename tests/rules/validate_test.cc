// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/validate.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <rigor/rules/environment.h>

namespace rigor::rules {
namespace {

using Files = std::map<std::string, std::string>;

/// "FILE RULE" of every finding of these files, sorted.
std::vector<std::string> findings(const Files& files, std::vector<std::string> paths) {
  const MemoryDisk disk(files);
  const Environment environment(disk, {});
  Sources sources;
  const ValidateResult result = validate(environment, {.paths = std::move(paths)}, sources);
  std::vector<std::string> found;
  for (const Diagnostic& diagnostic : result.diagnostics.list()) {
    found.push_back(std::string(sources.path(diagnostic.where.source)) + " " +
                    std::string(diagnostic.rule));
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::string model(const std::string& parts) {
  return "<sdf version='1.9'><model name='m'><static>1</static><link name='l'/>" + parts +
         "</model></sdf>";
}

std::string including(const std::string& path) {
  return "<include><uri>" + path + "</uri></include>";
}

const char* const kFault = "<pose>wide</pose>";  // value-malformed, an error

using FoundInFiles = std::vector<std::string>;

TEST(IncludeHasErrors, DependsOnNoOrderInACircle) {
  const Files files{{"a.sdf", model(including("b.sdf"))},
                    {"b.sdf", model(including("a.sdf") + kFault)}};
  const FoundInFiles expected{"a.sdf include-cycle", "a.sdf include-has-errors",
                              "b.sdf include-cycle", "b.sdf value-malformed"};
  EXPECT_EQ(findings(files, {"a.sdf", "b.sdf"}), expected);
  EXPECT_EQ(findings(files, {"b.sdf", "a.sdf"}), expected);
}

TEST(IncludeHasErrors, IsToldOnceAlongAChain) {
  const Files files{{"a.sdf", model(including("b.sdf"))},
                    {"b.sdf", model(including("c.sdf"))},
                    {"c.sdf", model(including("d.sdf"))},
                    {"d.sdf", model(kFault)}};
  EXPECT_EQ(findings(files, {"a.sdf", "b.sdf", "c.sdf", "d.sdf"}),
            (FoundInFiles{"c.sdf include-has-errors", "d.sdf value-malformed"}));
}

TEST(IncludeHasErrors, IsToldByTheNearestFileThatWasNamed) {
  // Whoever checks the world alone must not be told that all is well.
  const Files files{{"a.sdf", model(including("b.sdf"))},
                    {"b.sdf", model(including("c.sdf"))},
                    {"c.sdf", model(kFault)}};
  EXPECT_EQ(findings(files, {"a.sdf"}), FoundInFiles{"a.sdf include-has-errors"});
  EXPECT_EQ(findings(files, {"a.sdf", "b.sdf"}), FoundInFiles{"b.sdf include-has-errors"});
}

TEST(IncludeHasErrors, IsToldOncePerFileHoweverOftenItIsIncluded) {
  const auto part = [](const std::string& name, const std::string& path) {
    return "<include><name>" + name + "</name><uri>" + path + "</uri></include>";
  };
  const std::string wheels = part("left", "b.sdf") + part("mast", "c.sdf") + part("right", "b.sdf");
  const Files files{{"a.sdf", model(wheels)}, {"b.sdf", model(kFault)}, {"c.sdf", model(kFault)}};
  EXPECT_EQ(findings(files, {"a.sdf"}),
            (FoundInFiles{"a.sdf include-has-errors", "a.sdf include-has-errors"}));
}

/// The help of every finding of a rule, in order.
std::vector<std::string> helps(const std::string& path, const std::string& text,
                               std::string_view rule) {
  const MemoryDisk disk(Files{{path, text}});
  const Environment environment(disk, {});
  Sources sources;
  const ValidateResult result = validate(environment, {.paths = {path}}, sources);
  std::vector<std::string> found;
  for (const Diagnostic& diagnostic : result.diagnostics.list()) {
    if (diagnostic.rule == rule) found.push_back(diagnostic.help);
  }
  return found;
}

/// A robot of n links, and n references that each miss one of them by a letter.
std::string misspelt(int n) {
  std::string text = "<robot name='r'>";
  for (int i = 0; i < n; ++i) text += "<link name='link_" + std::to_string(i) + "'/>";
  for (int i = 0; i < n; ++i) text += "<gazebo reference='lnk_" + std::to_string(i) + "'/>";
  return text + "</robot>";
}

TEST(Suggestions, EndWhereTheyCostMoreThanTheyHelp) {
  // A hundred of a hundred are compared; of a thousand, a thousand with each would be a million.
  const std::vector<std::string> few = helps("a.urdf", misspelt(100), "gazebo-reference-missing");
  ASSERT_EQ(few.size(), 100U);
  EXPECT_EQ(few.back(), "did you mean 'link_99'?");
  const std::vector<std::string> many = helps("a.urdf", misspelt(1000), "gazebo-reference-missing");
  ASSERT_EQ(many.size(), 1000U);
  EXPECT_EQ(many.front(), "did you mean 'link_0'?");
  EXPECT_EQ(many.back(), "");
}

TEST(ManyFindings, AreCountedAndNotAllListed) {
  std::string text = "<sdf version='1.9'><model name='m'><static>1</static><link name='l'/>";
  for (int i = 0; i < 2500; ++i) text += "<x" + std::to_string(i) + "/>";  // a warning each
  text += "<zz/></model></sdf>";
  const MemoryDisk disk(Files{{"a.sdf", text}});
  const Environment environment(disk, {});
  Sources sources;
  const Diagnostics found = validate(environment, {.paths = {"a.sdf"}}, sources).diagnostics;
  ASSERT_EQ(found.list().size(), 1001U);
  EXPECT_EQ(found.count(Severity::kWarning), 2501U);
  const Diagnostic& rest = found.list().back();
  EXPECT_EQ(rest.count, 1501U);
  EXPECT_EQ(rest.rule, found.list().front().rule);
  EXPECT_EQ(rest.where.begin, found.list()[999].where.begin + std::string("<x999/>").size())
      << "the first that is not listed";
  EXPECT_TRUE(rest.message.find("1501 more") != std::string::npos) << rest.message;
}

/// A lamp whose collision has the diameter for a radius, and beside it what is drawn by a mesh.
std::string lamp(const std::string& more) {
  const auto cylinder = [](const std::string& radius) {
    return "<geometry><cylinder radius='" + radius + "' length='0.5'/></geometry>";
  };
  return "<robot name='lamp'><link name='lamp'><visual>" + cylinder("0.04") +
         "</visual><collision>" + cylinder("0.08") + "</collision>" + more + "</link></robot>";
}

struct LampRun {
  bool sees_size = false;
  std::vector<std::string> skipped;
};

LampRun check_lamp(const std::string& more, MeshPolicy meshes, const Selection& selection = {}) {
  const MemoryDisk disk({{"a.urdf", lamp(more)}, {"a.stl", ""}});
  const Environment environment(disk, {});
  Sources sources;
  const ValidateResult result = validate(
      environment, {.paths = {"a.urdf"}, .selection = selection, .meshes = meshes}, sources);
  LampRun run;
  for (const Diagnostic& found : result.diagnostics.list())
    run.sees_size = run.sees_size || found.rule == "shape-size-slip";
  for (const NotLookedAt& left : result.not_looked_at) run.skipped.push_back(left.what);
  return run;
}

TEST(Assembly, IsLeftOutAloudOfModelsWithMeshesWhereTheseAre) {
  const std::string mesh = "<visual><geometry><mesh filename='a.stl'/></geometry></visual>";
  const std::vector<std::string> skipped{"assembly: meshes are not opened"};
  const LampRun left = check_lamp(mesh, MeshPolicy::kLeaveOut);
  EXPECT_FALSE(left.sees_size);
  EXPECT_EQ(left.skipped, skipped);
  const LampRun without = check_lamp("", MeshPolicy::kLeaveOut);
  EXPECT_TRUE(without.sees_size) << "boxes and cylinders cost nothing";
  EXPECT_TRUE(without.skipped.empty());
  const LampRun closed = check_lamp(mesh, MeshPolicy::kDoNotOpen);
  EXPECT_TRUE(closed.sees_size) << "an editor shows what it can at once";
  EXPECT_TRUE(closed.skipped.empty());
  const LampRun ignored = check_lamp(mesh, MeshPolicy::kLeaveOut, {.ignore = {"assembly"}});
  EXPECT_TRUE(ignored.skipped.empty()) << "nobody asked for it";
}

TEST(ManyFindings, OfABinaryFileAreOneOfAKind) {
  std::string text =
      "\x7f"
      "ELF";
  for (int i = 0; i < 300; ++i) text += "\x01\x02\xff";
  EXPECT_EQ(findings({{"a.sdf", text}}, {"a.sdf"}),
            (FoundInFiles{"a.sdf xml-control-character", "a.sdf xml-empty", "a.sdf xml-not-utf8",
                          "a.sdf xml-text-outside-root"}));
  const MemoryDisk disk(Files{{"a.sdf", text}});
  const Environment environment(disk, {});
  Sources sources;
  const Diagnostics found = validate(environment, {.paths = {"a.sdf"}}, sources).diagnostics;
  for (const Diagnostic& diagnostic : found.list()) {
    const auto says = [&diagnostic](const char* part) {
      return diagnostic.message.find(part) != std::string::npos;
    };
    if (diagnostic.rule == "xml-control-character") {
      EXPECT_TRUE(says("(and 599 more"));
    } else if (diagnostic.rule == "xml-not-utf8") {
      EXPECT_TRUE(says("(and 299 more"));
    }
  }
}

TEST(ManyFindings, OfRepetitionsBehindOtherElementsTakeOneWalk) {
  // With a walk to the first for each repetition, ten thousand million steps.
  std::string text = "<sdf version='1.9'><model name='m'><static>1</static><link name='l'/>";
  for (int i = 0; i < 100'000; ++i) text += "<frame name='f'/>";
  for (int i = 0; i < 100'000; ++i) text += "<self_collide>0</self_collide>";
  text += "<self_collide>1</self_collide></model></sdf>";
  EXPECT_EQ(helps("a.sdf", text, "repeated-element").size(), 1U);
}

TEST(Finding, NamesWhatItIsAbout) {
  const std::string text =
      "<robot name='arm'><link name='base'><visual name='shell'><geometry>"
      "<mesh filename='meshes\\a.stl'/></geometry></visual></link></robot>";
  const MemoryDisk disk(Files{{"a.urdf", text}});
  const Environment environment(disk, {});
  Sources sources;
  const Diagnostics found =
      validate(environment, {.paths = {"a.urdf"}, .selection = {.select = {"uri-backslash"}}},
               sources)
          .diagnostics;
  ASSERT_EQ(found.list().size(), 1U);
  EXPECT_EQ(found.list()[0].subject, "arm/link base/visual shell");
}

TEST(Finding, PointsAtWhatIsWrittenBetweenLines) {
  const std::string text =
      "<sdf version='1.9'><model name='m'><static>1</static><link name='l'><visual name='v'>"
      "<geometry><mesh><uri>\n  "
      "meshes/a.stl\n</uri></mesh></geometry></visual></link></model></sdf>";
  const MemoryDisk disk(Files{{"a.sdf", text}});
  const Environment environment(disk, {});
  Sources sources;
  const Diagnostics found = validate(environment, {.paths = {"a.sdf"}}, sources).diagnostics;
  ASSERT_EQ(found.list().size(), 1U);
  EXPECT_EQ(found.list()[0].rule, "mesh-not-found");
  EXPECT_EQ(sources.bytes(found.list()[0].where), "meshes/a.stl");
}

TEST(DeprecatedElement, NamesWhatToWriteInItsPlace) {
  const std::string text =
      "<robot name='arm'><link name='a'/><link name='b'/><joint name='j' type='continuous'>"
      "<parent link='a'/><child link='b'/><axis xyz='0 0 1' rpy='0 0 0'/>"
      "<joint_properties damping='1'/></joint></robot>";
  const MemoryDisk disk(Files{{"a.urdf", text}});
  const Environment environment(disk, {});
  Sources sources;
  const Diagnostics found =
      validate(environment, {.paths = {"a.urdf"}, .selection = {.select = {"deprecated-element"}}},
               sources)
          .diagnostics;
  ASSERT_EQ(found.list().size(), 2U);
  EXPECT_EQ(found.list()[0].message, "'rpy' is deprecated: it has no effect");
  EXPECT_EQ(found.list()[1].message, "'joint_properties' is ignored: write 'dynamics'");
}

}  // namespace
}  // namespace rigor::rules
