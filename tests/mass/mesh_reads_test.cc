// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mass/mesh/reads.h>

#include <atomic>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include <rigor/mass/mesh/facts.h>
#include <rigor/mass/mesh/survey.h>

namespace rigor::mass {
namespace {

constexpr const char* kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

/// Counts how often a file is opened.
class CountingDisk final : public Disk {
 public:
  using Files = std::map<std::string, std::string>;
  explicit CountingDisk(Files files) : disk_(std::move(files)) {}
  std::unique_ptr<OpenFile> open(const std::string& path) const override {
    ++opened;
    return disk_.open(path);
  }
  ReadResult read(const std::string& path, std::uint64_t most) const override {
    return disk_.read(path, most);
  }
  PathKind kind(const std::string& path) const override { return disk_.kind(path); }
  std::vector<std::string> list(const std::string& folder) const override {
    return disk_.list(folder);
  }
  mutable std::atomic<int> opened{0};

 private:
  MemoryDisk disk_;
};

TEST(MeshReads, ReadsOnceWhoeverAsks) {
  const CountingDisk disk(CountingDisk::Files{{"a.obj", kTriangle}});
  const process::Workers workers;
  MeshReads reads(disk, workers);
  std::vector<std::thread> threads;
  for (int i = 0; i < 8; ++i) threads.emplace_back([&] { reads.find("a.obj"); });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(reads.find("a.obj")->mesh.triangles.size(), 1U);
  EXPECT_EQ(disk.opened, 1);
}

TEST(MeshReads, ForgetsWhatWasNotAskedForTheLongest) {
  const CountingDisk disk(
      CountingDisk::Files{{"a.obj", kTriangle}, {"b.obj", kTriangle}, {"c.obj", kTriangle}});
  const process::Workers workers;
  MeshReads measure(disk, workers);
  const auto one = measure.find("a.obj");
  const std::uint64_t size = sizeof *one + 3 * sizeof(model::Vector3) + sizeof(mesh::Triangle);
  MeshReads reads(disk, workers, 2 * size + size / 2);  // room for two
  disk.opened = 0;
  const auto kept = reads.find("a.obj");
  reads.find("b.obj");
  reads.find("a.obj");
  reads.find("c.obj");  // b goes
  EXPECT_EQ(disk.opened, 3);
  reads.find("a.obj");
  EXPECT_EQ(disk.opened, 3);
  reads.find("b.obj");  // c goes
  EXPECT_EQ(disk.opened, 4);
  reads.find("c.obj");
  EXPECT_EQ(disk.opened, 5);
  EXPECT_EQ(kept->mesh.triangles.size(), 1U);  // whoever has it keeps it
}

TEST(MeshReads, GiveFactsAndSurveysAsTheFileDoes) {
  const MemoryDisk disk(
      CountingDisk::Files{{"a.obj", std::string(kTriangle) + "v 0 0 1\nf 1 2 4\n"}});
  const process::Workers workers;
  MeshReads reads(disk, workers);
  MeshSurveys surveys(disk, {nullptr, &reads});
  MeshFiles files(disk, MeshDepth::kShape, {nullptr, &reads});
  const MeshSurvey alone = survey_mesh(disk, {"a.obj"});
  EXPECT_EQ(surveys.find({"a.obj"}).moments.area, alone.moments.area);
  EXPECT_EQ(surveys.find({"a.obj"}).hull->volume, alone.hull->volume);
  EXPECT_EQ(files.find("a.obj", MeshDepth::kFile).shape->topology.boundary_edges, 4U);
}

}  // namespace
}  // namespace rigor::mass
