# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0

# A compiler cache and a quick linker, where they are installed. Neither changes what is built.
find_program(RIGOR_CCACHE ccache)
if(RIGOR_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${PROJECT_SOURCE_DIR}/cmake/ccache.sh ${RIGOR_CCACHE})
endif()
find_program(RIGOR_MOLD mold)
if(RIGOR_MOLD)
  add_link_options(-fuse-ld=mold)
endif()
