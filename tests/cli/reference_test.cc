// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The committed reference is what the program says of itself.

#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

#include <cli/program.h>
#include <support/corpus.h>

namespace rigor::test {
namespace {

TEST(Reference, IsNotStale) {
  const Folder folder;
  const std::string root = RIGOR_SOURCE_DIR;
  const std::string make = "'" + root + "/tools/docs.sh' '" RIGOR_BINARY "' '" +
                           folder.path("reference") + "' >'" + folder.path("said") + "' 2>&1";
  ASSERT_EQ(std::system(make.c_str()), 0) << folder.get("said");
  const std::string compare = "diff -r '" + root + "/docs/reference' '" + folder.path("reference") +
                              "' >'" + folder.path("said") + "' 2>&1";
  EXPECT_EQ(std::system(compare.c_str()), 0) << "tools/dev docs writes it anew\n"
                                             << folder.get("said").substr(0, 2000);
}

TEST(PackageXml, SaysTheVersionOfTheProgram) {
  const Folder folder;
  const std::string version = folder.rigor("--version").out;  // "rigor 0.1.0" and the engines
  const std::size_t begin = version.find(' ') + 1;
  const std::string number = version.substr(begin, version.find('\n') - begin);
  const std::string bytes = read_file(std::string(RIGOR_SOURCE_DIR) + "/package.xml");
  EXPECT_NE(bytes.find("<version>" + number + "</version>"), std::string::npos) << number;
}

}  // namespace
}  // namespace rigor::test
