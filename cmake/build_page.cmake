# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0

# What the build runs for EmbedPage.cmake: NODE (empty for none) and NPM make pages of FILES in FOLDER, in WORK;
# SOURCE holds them. Without node they are empty.

function(run)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${WORK} RESULT_VARIABLE result
                  OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(NOT result EQUAL 0)
    string(JOIN " " command ${ARGN})
    message(FATAL_ERROR "The page of `rigor view` cannot be built: `${command}` failed.\n${said}\n\
npm fetches packages from a registry, which takes a network. To build rigor without the page: \
cmake -DRIGOR_PAGE=OFF")
  endif()
endfunction()

# Installed anew only when the lock file says something else.
function(install_packages)
  file(SHA256 ${WORK}/package-lock.json digest)
  set(installed ${WORK}/node_modules/.rigor-lock)
  set(known "")
  if(EXISTS ${installed})
    file(READ ${installed} known)
  endif()
  if(NOT known STREQUAL digest)
    run(${NPM} ci --no-audit --no-fund --loglevel=error)
    file(WRITE ${installed} ${digest})
  endif()
endfunction()

set(page "")
set(live "")
if(NODE)
  file(MAKE_DIRECTORY ${WORK})
  string(REPLACE "|" ";" files "${FILES}")
  foreach(name IN LISTS files)
    cmake_path(GET name PARENT_PATH parent)
    file(COPY ${FOLDER}/${name} DESTINATION ${WORK}/${parent})
  endforeach()
  install_packages()
  run(${NODE} build.mjs ${WORK}/out)
  file(READ ${WORK}/out/page.html page)
  file(READ ${WORK}/out/page_live.html live)
endif()
file(WRITE ${SOURCE} "#include <rigor/report/page/embedded_page.h>\n\nnamespace rigor::report {\n
std::string_view embedded_page() {\n  return R\"RIGORPAGE(" "${page}" ")RIGORPAGE\";\n}\n
std::string_view embedded_live_page() {\n  return R\"RIGORPAGE(" "${live}" ")RIGORPAGE\";\n}\n
}  // namespace rigor::report\n")
