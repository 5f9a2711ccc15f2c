# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
#
# assimp is opened when a scene is first read, in a child process, and is linked to nothing. So only
# its headers are needed, and the name that the loader knows the library by.

find_path(RIGOR_ASSIMP_INCLUDE assimp/scene.h)
find_library(RIGOR_ASSIMP_LIBRARY assimp)
set(RIGOR_ASSIMP_SONAME "")
if(RIGOR_ASSIMP_LIBRARY)
  file(REAL_PATH ${RIGOR_ASSIMP_LIBRARY} rigor_assimp_file)
  cmake_path(GET rigor_assimp_file FILENAME rigor_assimp_file)
  string(REGEX MATCH "^libassimp\\.so\\.[0-9]+" RIGOR_ASSIMP_SONAME ${rigor_assimp_file})
endif()
