# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
#
# What a release holds beside the program, and how CPack makes Debian packages of it: `rigor` (the program, its
# worker and modules, pages and completions) and `librigor-dev` (the library, its headers, its CMake package). The
# component of a file is the default one of the folder that installs it (see the top CMakeLists.txt).

# Pages and completions come from the program itself, so that they say what it does.
set(rigor_share ${PROJECT_BINARY_DIR}/share)
set(rigor_completions ${rigor_share}/bash-completion/completions/rigor
                      ${rigor_share}/zsh/vendor-completions/_rigor
                      ${rigor_share}/fish/vendor_completions.d/rigor.fish)
add_custom_command(OUTPUT ${rigor_completions} ${rigor_share}/man/man1/rigor.1
  COMMAND ${CMAKE_COMMAND} -E rm -rf ${rigor_share}
  COMMAND ${CMAKE_COMMAND} -E make_directory
          ${rigor_share}/bash-completion/completions ${rigor_share}/zsh/vendor-completions
          ${rigor_share}/fish/vendor_completions.d ${rigor_share}/man/man1
  COMMAND rigor_cli completion bash > ${rigor_share}/bash-completion/completions/rigor
  COMMAND rigor_cli completion zsh > ${rigor_share}/zsh/vendor-completions/_rigor
  COMMAND rigor_cli completion fish > ${rigor_share}/fish/vendor_completions.d/rigor.fish
  COMMAND rigor_cli man -o ${rigor_share}/man/man1
  DEPENDS rigor_cli VERBATIM)
add_custom_target(rigor_manual ALL DEPENDS ${rigor_share}/man/man1/rigor.1)
# All that an installation needs, and no test.
add_custom_target(rigor_release DEPENDS rigor rigor_cli rigor_worker rigor_docs rigor_manual)

install(DIRECTORY ${rigor_share}/ DESTINATION ${CMAKE_INSTALL_DATAROOTDIR} COMPONENT program)
install(FILES README.md CHANGELOG.md LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)

# By which colcon and ROS tools know an installed package.
install(FILES package.xml DESTINATION ${CMAKE_INSTALL_DATAROOTDIR}/rigor COMPONENT dev)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME rigor)
set(CPACK_PACKAGE_VENDOR "The rigor authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL program dev)
# Umask of who runs CPack must not show.
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(RIGOR_MAINTAINER "The rigor authors <rigor@users.noreply.example>" CACHE STRING
    "Name and address of who answers for the packages")
set(CPACK_DEBIAN_PACKAGE_MAINTAINER ${RIGOR_MAINTAINER})
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME rigor)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
# Opened when a Collada, glTF or PLY mesh is first read, so that no dependency shows.
string(REPLACE ".so." "" rigor_assimp_package "${RIGOR_ASSIMP_SONAME}")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "${rigor_assimp_package}, ${rigor_embree_package}")
# Opened by `simulate --engine mujoco`.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS libmujoco2.2.2)
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION
"rigor tells what is wrong with a robot model (SDFormat, URDF, xacro, MJCF)
before a simulator loads it: XML, schema, names, references, frames, inertia,
joints, shapes, meshes and packages, each finding with its place and what to
do.
.
It also computes mass and inertia exactly, checks and repairs meshes, converts
between the formats with an account of every loss, edits models with a proof of
what changed, serves editors, and simulates a model without a window for a
verdict that a script can use.")

set(CPACK_DEBIAN_DEV_PACKAGE_NAME librigor-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
# The library runs importers and engines in the worker, which is in the program's package.
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS
    "rigor (= ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}), libboost-dev, libconsole-bridge-dev, libeigen3-dev, libfmt-dev, libmeshoptimizer-dev, libode-dev, libpng-dev, libqhull-dev, \
libsqlite3-dev, libtinyxml2-dev, libturbojpeg0-dev, liburdfdom-dev, libxxhash-dev, libyaml-cpp-dev, zlib1g-dev")
set(CPACK_DEBIAN_DEV_PACKAGE_RECOMMENDS "${rigor_assimp_package}, ${rigor_embree_package}")
set(CPACK_COMPONENT_DEV_DESCRIPTION
"rigor tells what is wrong with a robot model (SDFormat, URDF) before a
simulator loads it.
.
This package holds its library (static), the headers and a CMake package:
say find_package(rigor CONFIG) and link rigor::rigor.")

# What only a Debian package has: copyright, changelog and overrides in their places, compressed pages.
set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/packaging/debian/files.cmake)
set(CPACK_RIGOR_PACKAGING ${PROJECT_SOURCE_DIR}/packaging/debian)
# Read by that script.
set(CPACK_RIGOR_VERSION ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})
set(CPACK_RIGOR_MAINTAINER ${RIGOR_MAINTAINER})
include(CPack)
