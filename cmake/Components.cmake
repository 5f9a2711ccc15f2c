# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0

# What rigor can be built without. RIGOR_WITH_X is AUTO (taken where it is installed, the default), ON (the
# configuration ends where it is not) or OFF; RIGOR_HAS_X is what came of it.

# rigor_component(NAME WHAT PACKAGE FOUND...): FOUND are variables that say whether its parts were found.
function(rigor_component name what package)
  set(RIGOR_WITH_${name} AUTO CACHE STRING "${what}: AUTO, ON or OFF")
  set_property(CACHE RIGOR_WITH_${name} PROPERTY STRINGS AUTO ON OFF)
  set(has ON)
  foreach(found IN LISTS ARGN)
    if(NOT ${found})
      set(has OFF)
    endif()
  endforeach()
  set(auto OFF)
  if(RIGOR_WITH_${name} STREQUAL "AUTO")
    set(auto ON)
  elseif(NOT RIGOR_WITH_${name})
    set(has OFF)
  elseif(NOT has)
    message(FATAL_ERROR "${name} is not installed (Debian: apt install ${package}), which is needed for: ${what}. \
To build rigor without it: cmake -DRIGOR_WITH_${name}=OFF")
  endif()
  if(NOT has)
    message(STATUS "Without ${name} (apt install ${package}), so without ${what}")
    if(RIGOR_BUILD_TESTS)
      message(FATAL_ERROR "The tests are of all that rigor does, and need ${name} (Debian: apt install ${package}). \
To build rigor without tests: cmake -DRIGOR_BUILD_TESTS=OFF")
    endif()
  endif()
  set(RIGOR_HAS_${name} ${has} PARENT_SCOPE)
endfunction()

find_package(ODE QUIET)
rigor_component(ODE "rigor simulate" libode-dev ODE_FOUND)

# Opened by name, and linked to nothing. MuJoCo's structs differ between versions: rigor is built for one.
find_path(RIGOR_MUJOCO_INCLUDE mujoco/mujoco.h)
rigor_component(MUJOCO "rigor simulate --engine mujoco" libmujoco-dev RIGOR_MUJOCO_INCLUDE)

# Opened when an image is traced, and linked to nothing. Version 4 before 3.
find_path(RIGOR_EMBREE_INCLUDE NAMES embree4/rtcore.h embree3/rtcore.h)
if(EXISTS "${RIGOR_EMBREE_INCLUDE}/embree4/rtcore.h")
  set(rigor_embree_package libembree4-4)
else()
  set(rigor_embree_package libembree3-3)
endif()
rigor_component(EMBREE "rigor render, and images in reports" libembree-dev RIGOR_EMBREE_INCLUDE)

find_package(urdfdom_headers QUIET)
find_package(urdfdom QUIET)
find_package(console_bridge QUIET)
rigor_component(URDFDOM "a second reader that judges conversions to URDF" liburdfdom-dev
                urdfdom_headers_FOUND urdfdom_FOUND console_bridge_FOUND)

include(${CMAKE_CURRENT_LIST_DIR}/FindAssimpLibrary.cmake)
rigor_component(ASSIMP "meshes other than STL and OBJ" libassimp-dev RIGOR_ASSIMP_INCLUDE RIGOR_ASSIMP_SONAME)

find_package(PkgConfig QUIET)
if(PkgConfig_FOUND)
  pkg_check_modules(httplib QUIET IMPORTED_TARGET cpp-httplib)
endif()
rigor_component(HTTPLIB "rigor view --serve" "libcpp-httplib-dev pkg-config" httplib_FOUND)

find_package(SQLite3 QUIET)
rigor_component(SQLITE "rigor merge -o results.sqlite, and its report" libsqlite3-dev SQLite3_FOUND)

# Of a module that is opened when shapes are held against each other.
find_package(fcl CONFIG QUIET)
rigor_component(FCL "the collision matrix of rigor srdf" libfcl-dev fcl_FOUND)

# rigor_choose(SOURCES HEADERS NAME STUB PATTERN): with a component, SOURCES lose its stub, STUB_absent.cc. Without,
# they lose every file that includes what matches PATTERN, itself or by one of HEADERS.
function(rigor_choose sources headers name stub pattern)
  set(chosen ${${sources}})
  if(RIGOR_HAS_${name})
    list(FILTER chosen EXCLUDE REGEX "/${stub}_absent\\.cc$")
  else()
    foreach(header IN LISTS ${headers})
      file(STRINGS ${header} uses REGEX "^#include <${pattern}" LIMIT_COUNT 1)
      if(uses)
        string(REGEX REPLACE ".*/(rigor/.*)" "\\1" included ${header})
        string(APPEND pattern "|${included}")
      endif()
    endforeach()
    foreach(source IN LISTS chosen)
      file(STRINGS ${source} uses REGEX "^#include [<\"](${pattern})" LIMIT_COUNT 1)
      if(uses)
        list(REMOVE_ITEM chosen ${source})
      endif()
    endforeach()
  endif()
  set(${sources} ${chosen} PARENT_SCOPE)
endfunction()
