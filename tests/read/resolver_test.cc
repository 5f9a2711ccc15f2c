// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/resolver.h>

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace rigor::read {
namespace {

SearchPaths paths() {
  const std::map<std::string, std::string> variables{{"GZ_SIM_RESOURCE_PATH", "/gz:/gz2"},
                                                     {"SDF_PATH", "/sdf"},
                                                     {"ROS_PACKAGE_PATH", "/ros"},
                                                     {"AMENT_PREFIX_PATH", "/opt/ros"},
                                                     {"HOME", "/home/a"}};
  SearchPaths result = search_paths_from([&variables](const std::string& name) {
    const auto found = variables.find(name);
    return found == variables.end() ? std::string() : found->second;
  });
  result.given.push_back({"/given", "--model-path"});
  result.packages["arm"] = "/packages/arm";
  return result;
}

MemoryDisk disk_with(const std::vector<std::string>& files) {
  MemoryDisk disk;
  for (const std::string& file : files) disk.put(file, "x");
  return disk;
}

TEST(Resolver, SearchesInTheOrderOfTheContract) {
  // Each place holds the model; take the first away and the next one answers.
  const std::vector<std::string> places{"/given/m/a.stl",
                                        "/w/models/m/a.stl",
                                        "/gz/m/a.stl",
                                        "/gz2/m/a.stl",
                                        "/sdf/m/a.stl",
                                        "/ros/m/a.stl",
                                        "/opt/ros/share/m/a.stl",
                                        "/home/a/.gazebo/models/m/a.stl"};
  for (std::size_t first = 0; first < places.size(); ++first) {
    MemoryDisk disk =
        disk_with({places.begin() + static_cast<std::ptrdiff_t>(first), places.end()});
    disk.put("/w/models/other/model.config", "x");
    const Resolver resolver(disk, paths());
    const Resolution found = resolver.resolve("model://m/a.stl", "/w/models/other/model.sdf");
    EXPECT_EQ(found.path, places[first]);
    EXPECT_EQ(found.tried.back().path, places[first]);
  }
}

TEST(Resolver, TheConfigurationComesAfterTheCommandLine) {
  const ConfiguredPaths configured{{"/conf", "/conf2"},
                                   {{"arm", "/conf/arms"}, {"leg", "/conf/legs"}}};
  SearchPaths search = paths();
  search.configured = [&configured](std::string_view file) {
    return file.starts_with("/w/") ? &configured : nullptr;
  };
  const std::vector<std::string> places{"/given/m/a.stl", "/conf/m/a.stl", "/conf2/m/a.stl",
                                        "/w/models/m/a.stl"};
  for (std::size_t first = 0; first < places.size(); ++first) {
    MemoryDisk disk =
        disk_with({places.begin() + static_cast<std::ptrdiff_t>(first), places.end()});
    disk.put("/w/models/other/model.config", "x");
    const Resolver resolver(disk, search);
    for (const char* uri : {"model://m/a.stl", "m/a.stl"}) {
      EXPECT_EQ(resolver.resolve(uri, "/w/models/other/model.sdf").path, places[first]);
    }
  }
  const MemoryDisk disk = disk_with(
      {"/conf/arms/a", "/packages/arm/a", "/conf/legs/b", "/conf2/hand/c", "/conf/m/a.stl"});
  const Resolver resolver(disk, search);
  EXPECT_EQ(resolver.resolve("package://arm/a", "/w/x.urdf").path, "/packages/arm/a");
  EXPECT_EQ(resolver.resolve("package://leg/b", "/w/x.urdf").path, "/conf/legs/b");
  EXPECT_EQ(resolver.resolve("package://leg/b", "/w/x.urdf").tried.back().origin, "rigor.toml");
  EXPECT_EQ(resolver.resolve("package://hand/c", "/w/x.urdf").path, "/conf2/hand/c");
  EXPECT_EQ(resolver.resolve("model://m/a.stl", "/elsewhere/x.sdf").path, std::nullopt)
      << "that file has another configuration";
}

TEST(Resolver, AWorldFindsTheModelsAroundIt) {
  const MemoryDisk disk = disk_with({"/w/models/m/model.config"});
  const Resolver resolver(disk, {});
  EXPECT_EQ(resolver.resolve("model://m", "/w/worlds/lab.world").path, "/w/models/m");
}

TEST(Resolver, AWorldFindsTheModelsOfItsPackage) {
  MemoryDisk disk = disk_with(
      {"/ws/sim/models/deep/model.config", "/ws/sim/assets/arm/model.config",
       "/ws/sim/worlds/2023/models/near/model.config", "/ws/models/outside/model.config"});
  disk.put(
      "/ws/sim/package.xml",
      "<package><name>sim</name><export><gazebo_ros gazebo_model_path=\"${prefix}/assets:/other\"/>"
      "</export></package>");
  const Resolver resolver(disk, paths());
  const auto found = [&resolver](const std::string& name) {
    return resolver.resolve("model://" + name, "/ws/sim/worlds/2023/final.sdf").path;
  };
  EXPECT_EQ(found("near"), "/ws/sim/worlds/2023/models/near");
  EXPECT_EQ(found("deep"), "/ws/sim/models/deep");
  EXPECT_EQ(found("arm"), "/ws/sim/assets/arm");
  EXPECT_EQ(found("outside"), std::nullopt);
  // gz sim looks for the bare name of an include where it looks for model://.
  EXPECT_EQ(resolver.resolve("deep", "/ws/sim/worlds/2023/final.sdf").path, "/ws/sim/models/deep");
}

TEST(Resolver, AFileUriIsLookedForWhereThePackageTellsGazeboOfMedia) {
  MemoryDisk disk = disk_with({"/ws/shop/models/shelf/shelf.dae"});
  disk.put("/ws/shop/package.xml",
           "<package><export><gazebo_ros gazebo_media_path=\"${prefix}\"/></export></package>");
  EXPECT_EQ(
      Resolver(disk, {}).resolve("file://models/shelf/shelf.dae", "/ws/shop/models/m.sdf").path,
      "/ws/shop/models/shelf/shelf.dae");
}

TEST(Resolver, ARelativePathStandsBesideItsFile) {
  const MemoryDisk disk = disk_with({"m/meshes/a.stl"});
  const Resolver resolver(disk, {});
  EXPECT_EQ(resolver.resolve("meshes/a.stl", "m/model.sdf").path, "m/meshes/a.stl");
  EXPECT_EQ(resolver.resolve("file://meshes/a.stl", "m/model.sdf").path, "m/meshes/a.stl");
  EXPECT_EQ(resolver.resolve("../meshes/a.stl", "m/sdf/model.sdf").path, "m/meshes/a.stl");
}

TEST(Resolver, APackageIsTheOneThatItsManifestNames) {
  MemoryDisk disk = disk_with({"/src/checkout/meshes/a.stl", "/packages/arm/b.stl"});
  disk.put("/src/checkout/package.xml", "<package><name> leg </name></package>");
  const Resolver resolver(disk, paths());
  EXPECT_EQ(resolver.resolve("package://leg/meshes/a.stl", "/src/checkout/urdf/leg.urdf").path,
            "/src/checkout/meshes/a.stl");
  EXPECT_EQ(resolver.resolve("package://arm/b.stl", "/elsewhere/x.urdf").path,
            "/packages/arm/b.stl");
  const Resolution missing = resolver.resolve("package://hand/c.stl", "/src/checkout/x.urdf");
  EXPECT_FALSE(missing.path);
  EXPECT_EQ(missing.scheme, "package");
  EXPECT_GT(missing.tried.size(), 3U);
}

TEST(Resolver, AManifestIsReadAsXml) {
  MemoryDisk disk = disk_with({"/src/arm/a.stl", "/src/arm/second/s.dae"});
  disk.put("/src/arm/package.xml",
           "<package><!-- <name>old</name> --><name>arm</name><export><a/></export>"
           "<export><gazebo_ros gazebo_media_path='/x:${prefix}/second'/></export></package>");
  const Resolver resolver(disk, {});
  EXPECT_EQ(resolver.resolve("package://arm/a.stl", "/src/arm/u/r.urdf").path, "/src/arm/a.stl");
  EXPECT_FALSE(resolver.resolve("package://old/a.stl", "/src/arm/u/r.urdf").path);
  EXPECT_EQ(resolver.resolve("file://s.dae", "/src/arm/u/r.urdf").path, "/src/arm/second/s.dae");
}

TEST(Resolver, WhatIsFoundDependsOnNoSearchBefore) {
  MemoryDisk disk = disk_with({"p/models/thing/model.config"});
  disk.put("p/package.xml", "<package><name>p</name></package>");
  std::string deep = "p/w";
  for (int i = 0; i < 30; ++i) deep += "/d";
  for (const bool deep_first : {false, true}) {
    const Resolver resolver(disk, {});
    if (deep_first) resolver.resolve("model://thing", deep + "/a.sdf");
    EXPECT_EQ(resolver.resolve("model://thing", "p/w/z.sdf").path, "p/models/thing");
  }
}

TEST(Resolver, VariablesAreSearchedInTheOrderOfTheContract) {
  const std::vector<std::string> order{
      "/gz/foo/q",       "/ign/foo/q", "/sdf/foo/q",         "/model/foo/q",
      "/resource/foo/q", "/ros/foo/q", "/ament/share/foo/q", "/home/.gazebo/models/foo/q"};
  const std::map<std::string, std::string> variables{{"GZ_SIM_RESOURCE_PATH", "/gz"},
                                                     {"IGN_GAZEBO_RESOURCE_PATH", "/ign"},
                                                     {"SDF_PATH", "/sdf"},
                                                     {"GAZEBO_MODEL_PATH", "/model"},
                                                     {"GAZEBO_RESOURCE_PATH", "/resource"},
                                                     {"ROS_PACKAGE_PATH", "/ros"},
                                                     {"AMENT_PREFIX_PATH", "/ament"},
                                                     {"HOME", "/home"}};
  for (const std::string uri : {"model://foo/q", "package://foo/q"}) {
    const MemoryDisk disk;
    const Resolver resolver(disk, search_paths_from([&](const std::string& name) {
                              const auto found = variables.find(name);
                              return found == variables.end() ? std::string() : found->second;
                            }));
    std::vector<std::string> tried;
    for (const Tried& one : resolver.resolve(uri, "/x/a.sdf").tried) {
      if (std::find(order.begin(), order.end(), one.path) != order.end()) tried.push_back(one.path);
    }
    EXPECT_EQ(tried, order) << uri;
  }
}

TEST(Resolver, ComparesLetterCase) {
  const MemoryDisk disk = disk_with({"m/meshes/Wheel.STL"});
  const Resolver resolver(disk, {});
  const Resolution found = resolver.resolve("meshes/wheel.stl", "m/model.sdf");
  EXPECT_FALSE(found.path);
  EXPECT_EQ(found.other_case, "m/meshes/Wheel.STL");
}

TEST(Resolver, NeverGoesToTheNetwork) {
  MemoryDisk disk = disk_with({"/cache/fuel.gazebosim.org/openrobotics/models/sun/2/model.config",
                               "/cache/fuel.gazebosim.org/openrobotics/models/sun/1/model.config"});
  SearchPaths search;
  search.fuel_cache = "/cache";
  const Resolver resolver(disk, search);
  const std::string base = "https://fuel.gazebosim.org/1.0/OpenRobotics/models/";
  EXPECT_EQ(resolver.resolve(base + "Sun", "a.sdf").path,
            "/cache/fuel.gazebosim.org/openrobotics/models/sun/2");
  for (const char* version : {"1", "2", "9", "10"}) {
    disk.put(std::string("/cache/fuel.gazebosim.org/o/models/car/") + version + "/thumbnails/1.png",
             "");
  }
  const std::string car = "https://fuel.gazebosim.org/1.0/O/models/car";
  EXPECT_EQ(resolver.resolve(car, "a.sdf").path, "/cache/fuel.gazebosim.org/o/models/car/10");
  EXPECT_EQ(resolver.resolve(car + "/9", "a.sdf").path, "/cache/fuel.gazebosim.org/o/models/car/9");
  const Resolution missing = resolver.resolve(base + "Moon", "a.sdf");
  EXPECT_TRUE(missing.remote);
  EXPECT_FALSE(missing.path);
}

void put_package(MemoryDisk& disk, const std::string& folder, const std::string& name) {
  disk.put(folder + "/package.xml", "<package><name>" + name + "</name></package>");
  disk.put(folder + "/meshes/a.stl", "x");
}

/// `$(find NAME)` and `package://NAME` know the same packages.
void expect_both_find(const Disk& disk, const SearchPaths& search, const std::string& file,
                      const std::optional<std::string>& folder) {
  const Resolver resolver(disk, search);
  EXPECT_EQ(resolver.package_folder("lidar", file), folder) << file;
  const auto mesh = resolver.resolve("package://lidar/meshes/a.stl", file).path;
  EXPECT_EQ(mesh, folder ? std::optional(*folder + "/meshes/a.stl") : std::nullopt) << file;
}

TEST(Resolver, AWorkspaceOfRepositoriesIsSearched) {
  const std::string file = "/ws/src/robots/arm/urdf/a.urdf.xacro";
  const std::vector<std::vector<std::string>> marks{
      {}, {"/ws/.git/HEAD"}, {"/ws/src/robots/.git/HEAD", "/ws/src/sensors/.git/HEAD"}};
  for (const std::vector<std::string>& marked : marks) {
    MemoryDisk disk = disk_with(marked);
    put_package(disk, "/ws/src/robots/arm", "arm");
    put_package(disk, "/ws/src/sensors/some_lidar", "lidar");
    expect_both_find(disk, {}, file, "/ws/src/sensors/some_lidar");
  }
  // What builds a workspace tells of it where a file is not in `src`.
  MemoryDisk disk = disk_with({"/ws/install/setup.bash", "/ws/sim/worlds/a.world"});
  put_package(disk, "/ws/src/sensors/some_lidar", "lidar");
  expect_both_find(disk, {}, "/ws/sim/worlds/a.world", "/ws/src/sensors/some_lidar");
  MemoryDisk built_by_nobody = disk_with({"/ws/sim/worlds/a.world"});
  put_package(built_by_nobody, "/ws/src/sensors/some_lidar", "lidar");
  expect_both_find(built_by_nobody, {}, "/ws/sim/worlds/a.world", std::nullopt);
}

TEST(Resolver, APackageDeepInTheSameRepositoryIsFound) {
  MemoryDisk disk;
  put_package(disk, "/my_robot/arm", "arm");
  put_package(disk, "/my_robot/sensors/lidar", "lidar");
  expect_both_find(disk, {}, "/my_robot/arm/urdf/a.urdf", "/my_robot/sensors/lidar");
  // A submodule's packages, and those of the repository around it.
  MemoryDisk submodule = disk_with({"/r/.git/HEAD", "/r/deps/arm/.git"});
  put_package(submodule, "/r/deps/arm/arm", "arm");
  put_package(submodule, "/r/ours/some_lidar", "lidar");
  expect_both_find(submodule, {}, "/r/deps/arm/arm/urdf/a.urdf", "/r/ours/some_lidar");
}

TEST(Resolver, WhatBuildToolsLeaveOutHasNoPackages) {
  for (const std::string marker : {"COLCON_IGNORE", "AMENT_IGNORE", "CATKIN_IGNORE"}) {
    MemoryDisk disk = disk_with({"/ws/.git/HEAD", "/ws/old/" + marker});
    put_package(disk, "/ws/arm", "arm");
    put_package(disk, "/ws/old/some_lidar", "lidar");
    expect_both_find(disk, {}, "/ws/arm/a.urdf", std::nullopt);
  }
  for (const std::string folder : {"build", "install", "log", ".hidden"}) {
    MemoryDisk disk = disk_with({"/ws/.git/HEAD"});
    put_package(disk, "/ws/arm", "arm");
    put_package(disk, "/ws/" + folder + "/some_lidar", "lidar");
    expect_both_find(disk, {}, "/ws/arm/a.urdf", std::nullopt);
  }
}

TEST(Resolver, OfTwoPackagesOfOneNameTheNearerIsTaken) {
  MemoryDisk disk = disk_with({"/ws/.git/HEAD"});
  put_package(disk, "/ws/a/some_lidar", "lidar");
  put_package(disk, "/ws/b/some_lidar", "lidar");
  put_package(disk, "/ws/b/arm", "arm");
  put_package(disk, "/ws/c/arm", "arm");
  expect_both_find(disk, {}, "/ws/b/arm/urdf/a.urdf", "/ws/b/some_lidar");
  expect_both_find(disk, {}, "/ws/c/arm/urdf/a.urdf", "/ws/a/some_lidar");
}

TEST(Resolver, FoldersOfTheEnvironmentAndOfTheCommandAreSearchedWithAllBelow) {
  MemoryDisk disk = disk_with({"/robots/arm/urdf/a.urdf"});
  put_package(disk, "/ros/group/some_lidar", "lidar");
  expect_both_find(disk, paths(), "/robots/arm/urdf/a.urdf", "/ros/group/some_lidar");
  SearchPaths named;
  named.named = {"ros"};
  named.templates.working_folder = "/";
  expect_both_find(disk, named, "/robots/arm/urdf/a.urdf", "/ros/group/some_lidar");
  expect_both_find(disk, {}, "/robots/arm/urdf/a.urdf", std::nullopt);
}

TEST(Resolver, ARelativePathLeadsToARelativeOne) {
  MemoryDisk disk = disk_with({"/ws/.git/HEAD"});
  put_package(disk, "/ws/arm", "arm");
  put_package(disk, "/ws/sensors/some_lidar", "lidar");
  disk.put("sensors/some_lidar/meshes/a.stl", "x");  // the same, as it is seen from /ws
  SearchPaths search;
  search.templates.working_folder = "/ws";
  const Resolution found =
      Resolver(disk, search).resolve("package://lidar/meshes/a.stl", "arm/urdf/a.urdf");
  EXPECT_EQ(found.path, "sensors/some_lidar/meshes/a.stl");
  const Resolution missing = Resolver(disk, search).resolve("package://radar/a.stl", "arm/a.urdf");
  EXPECT_EQ(missing.tried.back().path, "**/package.xml");
  EXPECT_EQ(missing.tried.back().origin, "none gives the package's name");
}

}  // namespace
}  // namespace rigor::read
