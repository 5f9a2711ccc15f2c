// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What people try first: help, a folder in place of a file, the formats that help names.

#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include <rigor/report/page/model_page.h>

#include <cli/program.h>

namespace rigor::test {
namespace {

constexpr const char* kOneLink =
    "<sdf version='1.9'><model name='m'><link name='l'><visual name='v'><geometry><box>"
    "<size>1 1 1</size></box></geometry></visual><collision name='c'><geometry><box>"
    "<size>1 1 1</size></box></geometry></collision></link></model></sdf>\n";

constexpr const char* kOneUrdf = "<robot name='m'><link name='l'/></robot>\n";

TEST(FirstUse, HelpIsACommand) {
  const Folder folder;
  const Ran alone = folder.rigor("");
  EXPECT_EQ(folder.rigor("help").out, alone.out);
  EXPECT_EQ(folder.rigor("help").exit, 0);
  for (const char* command : {"validate", "simulate", "man"}) {
    const Ran help = folder.rigor(std::string("help ") + command);
    EXPECT_EQ(help.exit, 0) << command;
    EXPECT_EQ(help.out, folder.rigor(std::string(command) + " --help").out);
    EXPECT_NE(help.out.find("Usage: rigor"), std::string::npos);
  }
  const Ran unknown = folder.rigor("help validat");
  EXPECT_EQ(unknown.exit, 2);
  EXPECT_NE(unknown.err.find("did you mean \"validate\"?"), std::string::npos) << unknown.err;
}

/// git writes `.git/info/exclude` into every clone, above the folder that is named.
TEST(FirstUse, AClonesOwnPatternsAreHonored) {
  const Folder folder;
  folder.put(".git/info/exclude", "scratch.sdf\n");
  folder.put("bot/bot.sdf", kOneLink);
  folder.put("bot/scratch.sdf", "<sdf version='1.9'><model/></sdf>\n");
  const Ran ran = folder.rigor("validate bot --fail-on never");
  EXPECT_EQ(ran.exit, 0) << ran.err;
  EXPECT_EQ((ran.out + ran.err).find("info/exclude: lies outside"), std::string::npos)
      << ran.out << ran.err;
  EXPECT_EQ(ran.out.find("scratch.sdf:"), std::string::npos) << ran.out;
}

/// Each command that takes a model, given a folder that holds one and no model.config.
TEST(FirstUse, AFolderWithOneModelIsThatModel) {
  const Folder folder;
  folder.put("bot/bot.sdf", kOneLink);
  folder.put("urdf/bot.urdf", kOneUrdf);
  for (const char* command :
       {"validate bot", "inspect bot", "inertia bot --material abs", "mesh-check bot",
        "sdf2urdf bot -o out.urdf", "urdf2sdf urdf -o out.sdf", "diff bot bot", "simulate bot",
        "render bot -o out.png", "view bot -o view.html", "report bot -o out.html",
        "upgrade bot --to 1.10 --diff"}) {
    const bool lacks_page = report::page_template(report::PageUse::kFile).empty();
    if (lacks_page && std::string_view(command).starts_with("view")) continue;
    const Ran ran = folder.rigor(command);
    EXPECT_NE(ran.exit, 2) << command << ": " << ran.err;
    EXPECT_EQ(ran.err.find("model.config"), std::string::npos) << command << ": " << ran.err;
  }
  EXPECT_EQ(folder.rigor("inspect bot --format tsv").out,
            folder.rigor("inspect bot/bot.sdf --format tsv").out);
}

TEST(FirstUse, AFolderWithSeveralModelsAsksWhichOne) {
  const Folder folder;
  folder.put("bots/a.sdf", kOneLink);
  folder.put("bots/b.sdf", kOneLink);
  folder.put("none/README", "");
  const Ran several = folder.rigor("inspect bots");
  EXPECT_EQ(several.exit, 2);
  EXPECT_NE(several.err.find("bots: 2 models in this folder"), std::string::npos) << several.err;
  EXPECT_NE(several.err.find("bots/a.sdf bots/b.sdf"), std::string::npos) << several.err;
  const Ran none = folder.rigor("inspect none");
  EXPECT_EQ(none.exit, 2);
  EXPECT_NE(none.err.find("none: holds no .sdf"), std::string::npos) << none.err;
}

/// A solid cube of 2 m and 6 kg: 6 · (2² + 2²) / 12 = 4 kg·m² about each axis, of 8 m³ and 0.75 kg/m³.
TEST(FirstUse, InertiaPrintsTheFormatsThatItsHelpNames) {
  const Folder folder;
  const std::string help = folder.rigor("inertia --help").out;
  for (const char* format : {"sdf", "urdf", "mjcf", "json", "text"}) {
    EXPECT_NE(help.find(format), std::string::npos);
    const Ran ran =
        folder.rigor(std::string("inertia box --size 2 2 2 --mass 6 --format ") + format);
    EXPECT_EQ(ran.exit, 0) << format << ": " << ran.err;
  }
  const std::string text = folder.rigor("inertia box --size 2 2 2 --mass 6 --format text").out;
  for (const char* part : {"mass      6 kg\n", "volume    8 m³\n", "density   0.75 kg/m³\n",
                           "ixx 4  iyy 4  izz 4  ixy 0  ixz 0  iyz 0 kg·m²"}) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  }
}

/// A tetrahedron without its last face is repaired: what was made of it comes before what was wrong with it.
TEST(FirstUse, MeshCheckPrintsItsResultBeforeTheFindingsOfItsSource) {
  const Folder folder;
  folder.put("open.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\n");
  const Ran ran = folder.rigor("mesh-check open.obj --repair -o closed.stl --color never");
  const std::size_t written = ran.out.find("closed.stl: written");
  const std::size_t source = ran.out.find("open.obj: ");
  const std::size_t finding = ran.out.find("[mesh-");
  ASSERT_NE(written, std::string::npos) << ran.out << ran.err;
  ASSERT_NE(source, std::string::npos) << ran.out;
  ASSERT_NE(finding, std::string::npos) << ran.out;
  EXPECT_LT(written, source);
  EXPECT_LT(source, finding);
}

/// A wheel's tire as a flat prism about y, put in the place of a cylinder, which is about z.
TEST(FirstUse, AttachSaysThatAWheelLiesOnItsSide) {
  const Folder folder;
  std::string tire;
  for (const char* y : {"-0.1", "0.1"}) {
    for (const char* xz : {"1 {} 0", "0 {} 1", "-1 {} 0", "0 {} -1"}) {
      std::string line = xz;
      line.replace(line.find("{}"), 2, y);
      tire += "v " + line + '\n';
    }
  }
  tire += "f 1 2 3 4\nf 8 7 6 5\nf 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1\n";
  folder.put("w/tire.obj", tire);
  folder.put(
      "w/model.sdf",
      "<sdf version='1.9'><model name='m'><link name='l'><visual name='v'><geometry><cylinder>"
      "<radius>1</radius><length>0.2</length></cylinder></geometry></visual></link></model></"
      "sdf>\n");
  const Ran ran = folder.rigor("mesh-check w/tire.obj --attach w/model.sdf::l::v");
  EXPECT_NE(ran.err.find("is round about its y axis, the shape that it replaces about z"),
            std::string::npos)
      << ran.err;
  EXPECT_NE(ran.err.find("\"1.5707963 0 0\""), std::string::npos) << ran.err;
}

/// The list that it names is the one of the finding.
TEST(FirstUse, TheSearchOfAUriIsAskedForWithItsFile) {
  const Folder folder;
  folder.put("my bots/arm/arm.urdf",
             "<robot name='a'><link name='l'><visual><geometry>"
             "<mesh filename='package://nowhere/m.stl'/></geometry></visual></link></robot>");
  const Ran ran = folder.rigor("validate 'my bots'");
  const std::string asked = "rigor resolve package://nowhere/m.stl --from 'my bots/arm/arm.urdf'";
  ASSERT_NE(ran.out.find(asked), std::string::npos) << ran.out;
  const Ran resolved = folder.rigor(asked.substr(6));
  EXPECT_EQ(resolved.exit, 1) << resolved.err;
  EXPECT_NE(resolved.out.find("my bots/arm"), std::string::npos) << resolved.out;
}

/// It is in every installation of Gazebo classic, or downloaded; gz sim knows no such database.
TEST(FirstUse, ModelsOfGazeboClassicsDatabaseAreNoErrorsInItsWorlds) {
  const Folder folder;
  const auto world = [](const std::string& version, const std::string& model) {
    return "<sdf version='" + version + "'><world name='w'><include><uri>model://" + model +
           "</uri></include></world></sdf>\n";
  };
  folder.put("classic.world", world("1.6", "sun"));
  const Ran classic = folder.rigor("validate classic.world --format concise --show info", "HOME=.");
  EXPECT_EQ(classic.exit, 0) << classic.out;
  EXPECT_NE(classic.out.find("info: 'model://sun' is not installed here"), std::string::npos)
      << classic.out;
  EXPECT_NE(classic.err.find("1 include skipped"), std::string::npos) << classic.err;
  folder.put("misspelt.world", world("1.6", "sunn"));
  EXPECT_EQ(folder.rigor("validate misspelt.world", "HOME=.").exit, 1);
  folder.put("gz.sdf", world("1.9", "sun"));
  EXPECT_EQ(folder.rigor("validate gz.sdf", "HOME=.").exit, 1);
}

}  // namespace
}  // namespace rigor::test
