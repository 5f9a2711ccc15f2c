// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor_fuzz_seeds TESTDATA`: every fuzz target on the seeds it starts from, without a fuzzer, so that CI compiles
// the targets and sees what they have always found.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace {
using Target = int(const std::uint8_t*, std::size_t);
}

extern "C" {
Target fuzz_config, fuzz_conversion, fuzz_lsp, fuzz_results, fuzz_scenario, fuzz_scene, fuzz_stl,
    fuzz_validate, fuzz_xacro;
}

namespace {

struct Seeded {
  Target* target;
  const char* folder;  ///< in testdata
};

constexpr Seeded kTargets[] = {
    {fuzz_config, "fuzz_config"},   {fuzz_conversion, "fuzz"},        {fuzz_lsp, "fuzz_lsp"},
    {fuzz_results, "fuzz_results"}, {fuzz_scenario, "fuzz_scenario"}, {fuzz_scene, "fuzz_mesh"},
    {fuzz_stl, "fuzz_mesh"},        {fuzz_validate, "fuzz"},          {fuzz_xacro, "xacro/fuzz"},
};

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  for (const Seeded& seeded : kTargets) {
    std::size_t seeds = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(argv[1]) / seeded.folder)) {
      const std::string bytes = bytes_of(entry.path());
      seeded.target(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
      ++seeds;
    }
    std::printf("%s: %zu seeds\n", seeded.folder, seeds);
    if (seeds == 0) return 1;
  }
  return 0;
}
