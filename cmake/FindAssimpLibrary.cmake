# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
#
# assimp is opened when a scene is first read, in a child process, and is linked to nothing. So only
# its headers are needed, and the name that the loader knows the library by.

find_path(RIGOR_ASSIMP_INCLUDE assimp/scene.h REQUIRED)
find_library(RIGOR_ASSIMP_LIBRARY assimp REQUIRED)
get_filename_component(rigor_assimp_file ${RIGOR_ASSIMP_LIBRARY} REALPATH)
get_filename_component(rigor_assimp_file ${rigor_assimp_file} NAME)
string(REGEX MATCH "^libassimp\\.so\\.[0-9]+" RIGOR_ASSIMP_SONAME ${rigor_assimp_file})
if(NOT RIGOR_ASSIMP_SONAME)
  message(FATAL_ERROR "${RIGOR_ASSIMP_LIBRARY} is no versioned shared library")
endif()
