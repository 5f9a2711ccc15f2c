// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The tests start the programs thousands of times, and half of a start would be the registration of some
// hundred thousand constants. The library's are watched where the tests call it themselves.

extern "C" const char* __asan_default_options() {  // NOLINT: the sanitizer's own name
  return "report_globals=0";
}
