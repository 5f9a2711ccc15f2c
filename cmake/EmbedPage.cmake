# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0

# embed_page(OUT FOLDER): a source file that holds the page of `rigor view`, which node builds of FOLDER when the
# library is built. What npm fetches goes into the build folder. With RIGOR_PAGE off the page is empty and
# `rigor view` says so; a page that was asked for and cannot be built ends the build.
function(embed_page out folder)
  find_program(RIGOR_NODE NAMES node nodejs)
  find_program(RIGOR_NPM npm)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/embedded_page.cc)
  set(${out} ${source} PARENT_SCOPE)
  set(node "")
  set(files "")
  if(NOT RIGOR_PAGE)
    message(STATUS "RIGOR_PAGE is off: `rigor view` will write no page")
  elseif(NOT RIGOR_NODE OR NOT RIGOR_NPM)
    message(FATAL_ERROR "The page of `rigor view` is built with node and npm, which are not installed (Debian: \
apt install nodejs npm). To build rigor without the page: cmake -DRIGOR_PAGE=OFF")
  else()
    set(node ${RIGOR_NODE})
    file(GLOB_RECURSE files CONFIGURE_DEPENDS RELATIVE ${folder} ${folder}/*)
    list(FILTER files EXCLUDE REGEX "^node_modules/|^out/")
  endif()
  list(TRANSFORM files PREPEND ${folder}/ OUTPUT_VARIABLE dependencies)
  string(REPLACE ";" "|" listed "${files}")
  add_custom_command(OUTPUT ${source}
    COMMAND ${CMAKE_COMMAND} -DNODE=${node} -DNPM=${RIGOR_NPM} -DFOLDER=${folder} -DFILES=${listed}
            -DWORK=${CMAKE_CURRENT_BINARY_DIR}/page -DSOURCE=${source}
            -P ${PROJECT_SOURCE_DIR}/cmake/build_page.cmake
    DEPENDS ${dependencies} ${PROJECT_SOURCE_DIR}/cmake/build_page.cmake VERBATIM)
endfunction()
