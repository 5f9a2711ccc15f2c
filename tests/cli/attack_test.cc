// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What models and repositories that nobody trusts try: to write outside of what was given, and to have what lies
// outside told to whoever reads the report.

#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include <cli/program.h>

namespace rigor::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTriangles =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
    "usemtl x/../../../../NAME\nf 1 2 3\nusemtl x:..:NAME\nf 1 2 4\nusemtl X_.._.._.._.._NAME\nf 1 "
    "3 4\n";

/// A tetrahedron.
constexpr const char* kSolid =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";

std::string model_with_mesh(const std::string& uri) {
  return "<sdf version='1.9'><model name='m'><link name='l'><inertial/><visual name='v'><geometry>"
         "<mesh><uri>" +
         uri + "</uri></mesh></geometry></visual></link></model></sdf>\n";
}

std::set<std::string> all_files(const Folder& folder) {
  std::set<std::string> files;
  for (const auto& each : fs::recursive_directory_iterator(folder.path(""))) {
    if (!each.is_directory()) files.insert(fs::relative(each.path(), folder.path("")).string());
  }
  return files;
}

TEST(Attack, NamesOfMaterialsLeadNowhere) {
  const Folder folder;
  folder.put("a/b/c/d/part.obj", kTriangles);
  const Ran ran = folder.rigor("mesh-check a/b/c/d/part.obj --split material -o a/b/c/d/out.obj");
  EXPECT_EQ(
      all_files(folder),
      (std::set<std::string>{"a/b/c/d/part.obj", "a/b/c/d/out-x_.._.._.._.._NAME.obj",
                             "a/b/c/d/out-x_.._NAME.obj", "a/b/c/d/out-X_.._.._.._.._NAME-2.obj"}))
      << ran.out << ran.err;
  EXPECT_NE(ran.out.find("out-x_.._.._.._.._NAME.obj"), std::string::npos) << ran.out;
}

/// Shapes, parts of meshes, links and models whose names lead up, through all that writes files for them.
TEST(Attack, NamesOfShapesAndPartsLeadNowhere) {
  const Folder folder;
  folder.put("a/b/c/part.obj", std::string("o ../../../NAME\n") + kSolid);
  folder.put("a/b/c/m.sdf",
             "<sdf version='1.9'><model name='../../NAME'><link name='../../../NAME'><inertial/>"
             "<collision name='../../../NAME'><geometry><polyline><point>0 0</point>"
             "<point>1 0</point><point>0 1</point><height>1</height></polyline></geometry>"
             "</collision><visual name='../../../NAME'><geometry><mesh><uri>part.obj</uri>"
             "<submesh><name>../../../NAME</name></submesh></mesh></geometry></visual></link>"
             "</model></sdf>\n");
  folder.put("a/b/c/m.xml",
             "<mujoco model='../../NAME'><asset><mesh name='../../../NAME' file='part.obj' "
             "scale='2 2 2'/></asset><worldbody><body name='../../../NAME'><freejoint/>"
             "<geom name='../../../NAME' type='mesh' mesh='../../../NAME'/></body></worldbody>"
             "</mujoco>\n");
  for (const char* to : {"1", "2", "3", "4"}) {
    fs::create_directories(folder.path(std::string("a/b/c/") + to));
  }
  for (const char* command :
       {"sdf2urdf a/b/c/m.sdf -o a/b/c/1/m.urdf", "sdf2mjcf a/b/c/m.sdf -o a/b/c/2/m.xml",
        "mjcf2sdf a/b/c/m.xml -o a/b/c/3/m.sdf", "mjcf2urdf a/b/c/m.xml -o a/b/c/4/m.urdf"}) {
    const Ran ran = folder.rigor(std::string(command) + " --allow-loss");
    EXPECT_EQ(ran.exit, 0) << command << ran.err;
  }
  std::set<std::string> parts;
  for (const std::string& file : all_files(folder)) {
    EXPECT_TRUE(file.starts_with("a/b/c/")) << file;
    if (file.find("NAME") != std::string::npos) parts.insert(file);
  }
  EXPECT_EQ(parts, (std::set<std::string>{"a/b/c/1/part-_._.._.._NAME.dae",
                                          "a/b/c/2/assets/part-_._.._.._NAME.stl"}));
}

TEST(Attack, NothingIsWrittenThroughALink) {
  const Folder folder;
  folder.put("elsewhere", "mine");
  folder.put("robot/part.obj", kSolid);
  folder.put("robot/model.sdf", model_with_mesh("part.obj"));
  fs::create_symlink("../elsewhere", folder.path("robot/part_edited.obj"));
  const Ran ran = folder.rigor("mesh-check robot/model.sdf --apply --center com");
  EXPECT_EQ(folder.get("elsewhere"), "mine") << ran.err;
}

TEST(Attack, ALinkInTheWayIsNamed) {
  const Folder folder;
  folder.put("elsewhere", "mine");
  folder.put("part.obj", kTriangles);
  fs::create_symlink("elsewhere", folder.path("out-x_.._NAME.obj"));
  const Ran ran = folder.rigor("mesh-check part.obj --split material -o out.obj");
  EXPECT_EQ(ran.exit, 2);
  EXPECT_NE(ran.err.find("out-x_.._NAME.obj: is a link"), std::string::npos) << ran.err;
  EXPECT_EQ(folder.get("elsewhere"), "mine");
}

/// The folder of a mesh may be a link, and its URI may lead anywhere.
TEST(Attack, NoMeshIsAppliedOutOfReach) {
  for (const char* uri : {"meshes/part.obj", "../elsewhere/part.obj"}) {
    const Folder folder;
    folder.put("elsewhere/part.obj", kTriangles);
    folder.put("robot/model.sdf", model_with_mesh(uri));
    fs::create_symlink("../elsewhere", folder.path("robot/meshes"));
    const std::string before = folder.get("robot/model.sdf");
    const Ran ran = folder.rigor("mesh-check robot/model.sdf --apply --center com");
    EXPECT_EQ(ran.exit, 2) << ran.out;
    EXPECT_NE(ran.err.find("is out of reach"), std::string::npos) << ran.err;
    EXPECT_FALSE(fs::exists(folder.path("elsewhere/part_edited.obj")));
    EXPECT_EQ(folder.get("robot/model.sdf"), before);
    EXPECT_EQ(
        folder.rigor("mesh-check robot/model.sdf --apply --center com --model-path elsewhere").exit,
        0);
    EXPECT_TRUE(fs::exists(folder.path("elsewhere/part_edited.obj")));
  }
}

/// Of a folder of pages a part may be a link, too.
TEST(Attack, NoFolderIsWrittenThroughALink) {
  const Folder folder;
  fs::create_directories(folder.path("elsewhere"));
  fs::create_directories(folder.path("pages"));
  fs::create_symlink("../elsewhere", folder.path("pages/models"));
  folder.put("robot/model.sdf", model_with_mesh("part.obj"));
  const Ran ran = folder.rigor("report robot --no-simulate --no-pictures -o pages/");
  EXPECT_EQ(ran.exit, 2);
  EXPECT_NE(ran.err.find("pages/models: is a link"), std::string::npos) << ran.err;
  EXPECT_TRUE(fs::is_empty(folder.path("elsewhere")));
}

/// What was found in a folder, or is named by a model.config, nobody has named.
TEST(Attack, NoModelIsChangedThroughALink) {
  const std::string old = "<sdf version='1.4'><model name='m'><link name='l'/></model></sdf>\n";
  const Folder folder;
  folder.put("elsewhere.sdf", old);
  fs::create_directories(folder.path("robot"));
  fs::create_symlink("../elsewhere.sdf", folder.path("robot/model.sdf"));
  folder.put("other/model.config",
             "<model><name>m</name><sdf version='1.4'>../elsewhere.sdf</sdf></model>");
  EXPECT_NE(folder.rigor("upgrade robot --to 1.9 --write").exit, 0);
  EXPECT_EQ(folder.get("elsewhere.sdf"), old);
  folder.rigor("inertia other --write");
  EXPECT_EQ(folder.get("elsewhere.sdf"), old);
  folder.rigor("upgrade robot/model.sdf --to 1.9 --write");  // here it is named
  EXPECT_NE(folder.get("elsewhere.sdf"), old);
}

TEST(Attack, ABaselineOfAConfigurationStaysInTheProject) {
  const std::string counts = "# rigor baseline\n";
  const Folder folder;
  folder.put("robot/model.sdf", model_with_mesh("part.obj"));
  folder.rigor("validate model.sdf --baseline-write ../known.txt", "cd robot &&");
  const std::string before = folder.get("known.txt");
  ASSERT_NE(before.find("mesh"), std::string::npos) << before;
  folder.put("robot/model.sdf",
             "<sdf version='1.9'><model name='m'><link name='l'/></model></sdf>\n");
  folder.put("robot/rigor.toml", "baseline = \"../known.txt\"\n");
  const Ran ran = folder.rigor("validate model.sdf --baseline-prune", "cd robot &&");
  EXPECT_EQ(ran.exit, 2);
  EXPECT_NE(ran.err.find("lies outside"), std::string::npos) << ran.err;
  EXPECT_EQ(folder.get("known.txt"), before);
}

/// A secret of the machine, under every name that a model can give it.
class Secret : public ::testing::Test {
 protected:
  void SetUp() override {
    const std::string secret = "HUNTER2=&<x> [y: {z\nv HUNTER2\nHUNTER2 HUNTER2\n";
    for (const char* ending :
         {"txt", "obj", "dae", "gltf", "yaml", "toml", "sdf", "xacro", "mtl", "png"}) {
      folder_.put(std::string("secret/plain.") + ending, secret);
      mesh_.append(model_shape(ending));
    }
    folder_.put("secret/good.yaml", "password: HUNTER2\n");
    folder_.put("robot/textured.obj", std::string("mtllib ../secret/plain.txt\n") + kSolid);
    folder_.put("robot/model.sdf",
                "<sdf version='1.9'><model name='m'>"
                "<include><uri>../secret/plain.txt</uri></include>"
                "<include><uri>../secret/plain.sdf</uri></include>"
                "<include merge='true'><uri>/proc/self/environ</uri></include><link name='l'>" +
                    mesh_ + "</link></model></sdf>\n");
    folder_.put("robot/bad.urdf.xacro",
                template_of("<xacro:include filename='../secret/plain.xacro'/>"
                            "<xacro:include filename='/proc/self/environ'/>"));
    folder_.put(
        "robot/bad_yaml.urdf.xacro",
        template_of("<xacro:property name='y' value=\"${load_yaml('../secret/plain.yaml')}\"/>"));
    folder_.put(
        "robot/good_yaml.urdf.xacro",
        template_of("<xacro:property name='y' value=\"${load_yaml('../secret/good.yaml')}\"/>"
                    "<link name=\"${y['password']}\"/>"));
  }

  static std::string template_of(const std::string& inside) {
    return "<robot name='a' xmlns:xacro='http://www.ros.org/wiki/xacro'>\n" + inside +
           "\n</robot>\n";
  }

  static std::string model_shape(const std::string& ending) {
    return "<collision name='c" + ending + "'><geometry><mesh><uri>../secret/plain." + ending +
           "</uri></mesh></geometry></collision>";
  }

  void tells_nothing(const std::string& arguments) {
    const Ran ran = folder_.rigor(arguments, "HUNTER2=HUNTER2");
    EXPECT_GE(ran.exit, 0);
    EXPECT_LT(ran.exit, 3) << arguments << ran.err;
    EXPECT_EQ(ran.out.find("HUNTER2"), std::string::npos) << arguments << "\n" << ran.out;
    EXPECT_EQ(ran.err.find("HUNTER2"), std::string::npos) << arguments << "\n" << ran.err;
  }

  std::string mesh_;
  const Folder folder_;
};

TEST_F(Secret, IsNamedAndNotQuoted) {
  for (const char* format :
       {"pretty", "concise", "json", "sarif", "junit", "jsonl", "github", "gitlab"}) {
    tells_nothing(std::string("validate robot --format ") + format);
  }
  for (const char* file : {"bad", "bad_yaml", "good_yaml"}) {
    tells_nothing(std::string("validate robot/") + file + ".urdf.xacro");
    tells_nothing(std::string("expand -v robot/") + file + ".urdf.xacro");
    tells_nothing(std::string("inspect robot/") + file + ".urdf.xacro");
    tells_nothing(std::string("urdf2sdf robot/") + file + ".urdf.xacro");
  }
  tells_nothing("mesh-check robot/model.sdf --format json");
  tells_nothing("mesh-check robot/textured.obj --format json");
  tells_nothing("sdf2urdf robot/model.sdf --allow-loss");
  tells_nothing("inertia robot/model.sdf");
  const Ran named = folder_.rigor("validate robot/bad.urdf.xacro");
  EXPECT_NE(named.out.find("secret/plain.xacro:1 lies outside"), std::string::npos) << named.out;
  tells_nothing("report robot --no-simulate --no-pictures -o page.html");
  EXPECT_EQ(folder_.get("page.html").find("HUNTER2"), std::string::npos);
  tells_nothing("view robot/model.sdf -o view.html");
  EXPECT_EQ(folder_.get("view.html").find("HUNTER2"), std::string::npos);
}

TEST_F(Secret, IsNotToldByAConfiguration) {
  folder_.put("robot/rigor.toml", "extend = \"../secret/plain.txt\"\n");
  fs::create_directories(folder_.path("robot/.git"));
  const Ran ran =
      folder_.rigor("validate robot/model.sdf", "cd robot && cd .. && cd robot && cd .. &&");
  EXPECT_EQ(ran.exit, 2);
  const Ran inside = folder_.rigor("validate model.sdf", "cd robot &&");
  EXPECT_EQ(inside.exit, 2);
  EXPECT_EQ(inside.err.find("HUNTER2"), std::string::npos) << inside.err;
  EXPECT_NE(inside.err.find("lies outside of the project"), std::string::npos) << inside.err;
}

/// What is well-formed and wrong is described by its own words.
TEST_F(Secret, OfAModelOrMeshWithErrorsIsNotQuoted) {
  folder_.put("secret/bad.sdf",
              "<sdf version='1.9'><model name='b'><link name='l'><inertial><inertia>"
              "<ixx>HUNTER2</ixx></inertia></inertial></link></model></sdf>");
  folder_.put("secret/numbers.dae",
              "<COLLADA version='1.4.1'><library_geometries><geometry id='g'><mesh><source id='p'>"
              "<float_array id='a' count='3'>HUNTER2 0 0</float_array></source></mesh></geometry>"
              "</library_geometries></COLLADA>");
  folder_.put(
      "secret/buffer.gltf",
      "{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":9,\"uri\":\"HUNTER2.bin\"}]}");
  folder_.put("secret/paint.obj", std::string("mtllib no.mtl\nusemtl HUNTER2\n") + kSolid);
  std::string parts;
  for (const char* file : {"numbers.dae", "buffer.gltf", "paint.obj"}) {
    for (const char* role : {"collision", "visual"}) {
      parts += std::string("<") + role + " name='" + file + role +
               "'><geometry><mesh><uri>../secret/" + file + "</uri></mesh></geometry></" + role +
               ">";
    }
  }
  folder_.put("robot/wrong.sdf",
              "<sdf version='1.9'><model name='m'><include><uri>../secret/bad.sdf</uri></include>"
              "<include merge='true'><uri>../secret/bad.sdf</uri></include><link name='l'>" +
                  parts + "</link></model></sdf>\n");
  for (const char* format : {"pretty", "json", "sarif", "github"}) {
    tells_nothing(std::string("validate robot/wrong.sdf --format ") + format);
  }
  const Ran named = folder_.rigor("validate robot/wrong.sdf --format concise");
  EXPECT_NE(named.out.find("include-has-errors"), std::string::npos) << named.out;
  EXPECT_NE(named.out.find("secret/bad.sdf lies outside"), std::string::npos) << named.out;
  EXPECT_NE(named.out.find("mesh-malformed"), std::string::npos) << named.out;
  tells_nothing("mesh-check robot/wrong.sdf");
  tells_nothing("render robot/wrong.sdf -o wrong.png --size 40x40");
  tells_nothing("simulate robot/wrong.sdf --test settle");
  tells_nothing("sdf2urdf robot/wrong.sdf --allow-loss");
  // Within reach it is quoted.
  const Ran open = folder_.rigor("validate robot/wrong.sdf --model-path secret");
  EXPECT_NE(open.out.find("HUNTER2"), std::string::npos) << open.out;
}

/// Models and meshes are read wherever they lie: no other reader is to have them for that.
TEST_F(Secret, InAModelIsNoYaml) {
  folder_.put("secret/settings.xml", "HUNTER2: <b>\n");
  folder_.put("secret/mesh.obj", "password: HUNTER2\n");
  fs::create_symlink(folder_.path("secret/mesh.obj"), folder_.path("robot/linked.obj"));
  fs::create_symlink(folder_.path("secret/settings.xml"), folder_.path("robot/linked.yaml"));
  for (const char* file :
       {"../secret/settings.xml", "../secret/mesh.obj", "linked.obj", "linked.yaml"}) {
    folder_.put("robot/any.urdf.xacro",
                template_of(std::string("<xacro:property name='y' value=\"${load_yaml('") + file +
                            "')}\"/><link name=\"${y}\"/>"));
    tells_nothing("validate robot/any.urdf.xacro --format sarif");
    tells_nothing("expand -v robot/any.urdf.xacro");
  }
}

/// A link has the name that the repository gave it.
TEST_F(Secret, IsNotReadThroughALink) {
  fs::create_symlink("../secret/plain.txt", folder_.path("robot/inner.xacro"));
  folder_.put("robot/linked.urdf.xacro", template_of("<xacro:include filename='inner.xacro'/>"));
  tells_nothing("validate robot/linked.urdf.xacro");
  tells_nothing("expand robot/linked.urdf.xacro");
}

/// How a mesh is shaped holds no text of it; what is called like one may be a link to anything.
TEST_F(Secret, OfAMeshThatIsOutOfReachNumbersAreTold) {
  folder_.put("meshes/open.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\n");
  folder_.put("meshes/bytes.txt", std::string(80, 'H') + "UNTER2 and so on, which is no mesh");
  fs::create_symlink("bytes.txt", folder_.path("meshes/cut.stl"));
  folder_.put("urdf/a.sdf", model_with_mesh("../meshes/open.obj"));
  const Ran open = folder_.rigor("validate urdf/a.sdf --format concise --show info");
  EXPECT_NE(open.out.find("the mesh has no normals"), std::string::npos) << open.out;
  folder_.put("urdf/b.sdf", model_with_mesh("../meshes/cut.stl"));
  const Ran linked = folder_.rigor("validate urdf/b.sdf --format concise --show info");
  EXPECT_NE(linked.out.find("lies outside"), std::string::npos) << linked.out;
  EXPECT_EQ(linked.out.find("promises"), std::string::npos) << linked.out;
}

TEST_F(Secret, IsWithinReachWhereItIsNamed) {
  const Ran ran = folder_.rigor("expand --model-path secret robot/good_yaml.urdf.xacro");
  EXPECT_EQ(ran.exit, 0) << ran.err;
  EXPECT_NE(ran.out.find("HUNTER2"), std::string::npos);
}

TEST_F(Secret, IsNotThereWithAConfinement) {
  folder_.put("secret/box.sdf",
              "<sdf version='1.9'><model name='b'><link name='HUNTER2'/></model></sdf>\n");
  folder_.put("robot/model.sdf",
              "<sdf version='1.9'><model name='m'><include><uri>../secret/box.sdf</uri></include>"
              "<link name='l'/></model></sdf>\n");
  EXPECT_NE(folder_.rigor("inspect robot/model.sdf").out.find("HUNTER2"), std::string::npos);
  const auto is_not_there = [&](const std::string& folder, const std::string& file,
                                const std::string& before) {
    for (const char* command : {"inspect", "validate"}) {
      const Ran ran =
          folder_.rigor(std::string(command) + " --confine " + folder + " " + file, before);
      EXPECT_EQ(ran.exit, 1) << command << ran.out << ran.err;
      EXPECT_EQ((ran.out + ran.err).find("HUNTER2"), std::string::npos) << ran.out << ran.err;
      EXPECT_NE((ran.out + ran.err).find("include"), std::string::npos) << ran.out << ran.err;
    }
  };
  is_not_there("robot", "robot/model.sdf", "");
  // Neither a repository around it nor a configuration there is seen.
  fs::create_directories(folder_.path(".git"));
  is_not_there(".", "model.sdf", "cd robot &&");
  folder_.put("rigor.toml", "extend = 'HUNTER2'\n");
  is_not_there("robot", "robot/model.sdf", "");
  const Ran ran = folder_.rigor("validate --confine robot secret/box.sdf");
  EXPECT_EQ(ran.exit, 2) << ran.out;
  EXPECT_EQ(folder_.rigor("validate --confine nowhere robot").exit, 2);
}

/// What is read of models anywhere otherwise: meshes, and models that a template includes.
TEST_F(Secret, OfMeshesAndTemplatesIsNotThereWithAConfinement) {
  folder_.put("secret/mesh.obj", kSolid);
  folder_.put("robot/mesh.sdf", model_with_mesh("../secret/mesh.obj"));
  folder_.put("secret/links.xacro", template_of("<link name='HUNTER2'/>"));
  folder_.put("robot/links.urdf.xacro",
              template_of("<xacro:include filename='../secret/links.xacro'/><link name='l'/>"));
  const std::string mesh = "mesh-check robot/mesh.sdf --format json";
  EXPECT_NE(folder_.rigor(mesh).out.find("\"triangles\": 4"), std::string::npos);
  EXPECT_EQ(folder_.rigor(mesh + " --confine robot").out.find("\"triangles\": 4"),
            std::string::npos);
  EXPECT_NE(folder_.rigor("expand robot/links.urdf.xacro").out.find("HUNTER2"), std::string::npos);
  for (const char* file : {"links", "good_yaml"}) {
    const std::string named = std::string(file) + ".urdf.xacro";
    EXPECT_EQ(folder_.rigor("expand --confine robot robot/" + named).exit, 1) << file;
    tells_nothing("expand --confine robot robot/" + named);
    tells_nothing("validate --confine robot robot/" + named);
  }
}

/// What runs in pull requests, and before commits, is confined to the repository where nothing else is asked for.
TEST_F(Secret, IsNotThereInAPullRequest) {
  folder_.put("secret/box.sdf",
              "<sdf version='1.9'><model name='b'><link name='l'/></model></sdf>\n");
  folder_.put("robot/model.sdf",
              "<sdf version='1.9'><model name='m'><include><uri>../secret/box.sdf</uri></include>"
              "<link name='l'/></model></sdf>\n");
  fs::create_directories(folder_.path("robot/.git"));
  const std::string inside =
      "cd robot && PATH='" + fs::path(RIGOR_BINARY).parent_path().string() + "':\"$PATH\" ";
  const auto found = [&](const std::string& command) {
    const Ran ran = folder_.run(inside + command);
    EXPECT_TRUE(ran.exit == 0 || ran.exit == 1) << command << ran.out << ran.err;
    return ran.out.find("is not found") == std::string::npos;
  };
  const std::string action =
      "RIGOR_PATHS=model.sdf RIGOR_FAIL_ON=error RIGOR_SARIF= GITHUB_OUTPUT=/dev/null bash "
      "'" RIGOR_SOURCE_DIR "/packaging/action/run.sh'";
  EXPECT_TRUE(found("GITHUB_EVENT_NAME=push RIGOR_ARGUMENTS= " + action));
  EXPECT_FALSE(found("GITHUB_EVENT_NAME=pull_request RIGOR_ARGUMENTS= " + action));
  EXPECT_FALSE(found("GITHUB_EVENT_NAME=pull_request_target RIGOR_ARGUMENTS= " + action));
  EXPECT_TRUE(found("GITHUB_EVENT_NAME=pull_request RIGOR_ARGUMENTS=--confine=.. " + action));

  std::ifstream hooks(RIGOR_SOURCE_DIR "/.pre-commit-hooks.yaml");
  std::size_t validating = 0;
  std::size_t confined = 0;
  for (std::string line; std::getline(hooks, line);) {
    if (line.starts_with("  entry: rigor validate")) ++validating;
    if (line == "  args: [--confine=.]") ++confined;
  }
  EXPECT_GE(validating, 3U);
  EXPECT_EQ(confined, validating);
  EXPECT_FALSE(found("rigor validate --confine=. model.sdf"));
}

/// A link to what lies outside is named where it is in the way.
TEST_F(Secret, ALinkOutOfAConfinementIsNoConfiguration) {
  folder_.put("robot/model.sdf",
              "<sdf version='1.9'><model name='m'><link name='l'/></model></sdf>\n");
  fs::create_symlink("../secret/plain.toml", folder_.path("robot/rigor.toml"));
  const Ran ran = folder_.rigor("validate --confine robot robot/model.sdf");
  EXPECT_EQ(ran.exit, 2);
  EXPECT_NE(ran.err.find("robot/rigor.toml: lies outside of what --confine names"),
            std::string::npos)
      << ran.err;
  EXPECT_EQ(ran.err.find("HUNTER2"), std::string::npos) << ran.err;
}

/// What `$(find …)` reads around the model is quoted as it is; a file beside those packages is not.
TEST_F(Secret, OfTheSameRepositoryModelsAndPackagesAreQuotedAndNothingElse) {
  fs::create_directories(folder_.path("repo/.git"));
  folder_.put("repo/arm/package.xml", "<package><name>arm</name></package>");
  folder_.put("repo/sub/hand/package.xml", "<package><name>hand</name></package>");
  folder_.put("repo/sub/hand/h.xacro", template_of("<link name=\"${TOLD_OF_HAND}\"/>"));
  folder_.put("repo/common/c.xacro", template_of("<link name=\"${TOLD_OF_COMMON}\"/>"));
  folder_.put("repo/common/key.txt", template_of("<link name=\"${HUNTER2}\"/>"));
  folder_.put("repo/common/key.xml", template_of("<link name=\"${HUNTER2}\"/>"));
  folder_.put("repo/.secret/s.xacro", template_of("<link name=\"${HUNTER2}\"/>"));
  folder_.put("outside/o.xacro", template_of("<link name=\"${HUNTER2}\"/>"));
  fs::create_symlink("key.txt", folder_.path("repo/common/linked.xacro"));
  std::string includes;
  for (const char* file :
       {"$(find hand)/h.xacro", "../common/c.xacro", "../common/key.xml", "../.secret/s.xacro",
        "../../outside/o.xacro", "../common/key.txt", "../common/linked.xacro"}) {
    includes += std::string("<xacro:include filename='") + file + "'/>";
  }
  folder_.put("repo/arm/a.urdf.xacro", template_of(includes));
  tells_nothing("validate repo/arm --format json");
  const Ran ran = folder_.rigor("validate repo/arm --format concise");
  EXPECT_NE(ran.out.find("'TOLD_OF_HAND' is undefined"), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("'TOLD_OF_COMMON' is undefined"), std::string::npos) << ran.out;
}

}  // namespace
}  // namespace rigor::test
