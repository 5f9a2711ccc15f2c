# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0

# A compiler cache and a quick linker, where they are installed. Neither changes what is built.
find_program(RIGOR_CCACHE ccache)
if(RIGOR_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # A precompiled header is named by what went into it, not by when it was written: ccache's manual,
  # "Precompiled headers".
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env
    CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime ${RIGOR_CCACHE})
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    add_compile_options(-fpch-preprocess)
  endif()
endif()
find_program(RIGOR_MOLD mold)
if(RIGOR_MOLD)
  add_link_options(-fuse-ld=mold)
endif()
