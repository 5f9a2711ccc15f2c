// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Verdicts as expat and libxml2 have them.

#include <rigor/xml/declaration.h>

#include <gtest/gtest.h>

namespace rigor::xml {
namespace {

TEST(Declaration, TakesWhatXmlTakes) {
  for (const char* inside :
       {R"( version="1.0")", R"( version='1.0' encoding="UTF-8")", R"( version="1.1"  )",
        R"( version="1.0" standalone='no')", " version = \"1.0\"\n encoding\t=\t'iso-8859-1'",
        R"( version="1.0" encoding="utf-8" standalone="yes")"}) {
    EXPECT_EQ(declaration_fault(inside), "") << inside;
  }
}

TEST(Declaration, RefusesWhatXmlRefuses) {
  for (const char* inside : {"",
                             " ",
                             R"( verison="1.0")",
                             R"( encoding="utf-8")",
                             R"( version="1.0"encoding="utf-8")",
                             R"( version="1.0)",
                             R"( version=1.0)",
                             R"( version)",
                             R"( version=)",
                             R"( version="")",
                             R"( version="2.0")",
                             R"( version="1.")",
                             R"( version="1.0" encoding="")",
                             R"( version="1.0" encoding="8bit")",
                             R"( version="1.0" encoding="utf 8")",
                             R"( version="1.0" standalone="maybe")",
                             R"( version="1.0" standalone="yes" encoding="a")",
                             R"( version="1.0" version="1.0")",
                             R"( version="1.0" x="y")",
                             R"(version="1.0")"}) {
    EXPECT_NE(declaration_fault(inside), "") << inside;
  }
}

}  // namespace
}  // namespace rigor::xml
