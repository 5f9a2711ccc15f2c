// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/process/confinement.h>

#include <unistd.h>

#include <gtest/gtest.h>

namespace rigor::process {
namespace {

TEST(Confinement, AddressSpaceIsTheFirstNumberInPages) {
  const auto page = static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
  EXPECT_EQ(address_space_in("1234 56 7 8 0 9 0\n"), 1234 * page);
  EXPECT_GT(address_space_in_use(), 0U);
  EXPECT_LE(resident_in_use(), address_space_in_use());
}

/// Where /proc is not mounted a limit on top of zero would be below what is in use.
TEST(Confinement, WithoutProcAFloorIsAssumed) {
  EXPECT_EQ(address_space_in(""), kAssumedAddressSpace);
  EXPECT_EQ(address_space_in("?"), kAssumedAddressSpace);
}

}  // namespace
}  // namespace rigor::process
