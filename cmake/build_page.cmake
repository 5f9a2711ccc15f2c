# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0

# What the build runs for EmbedPage.cmake: NODE (empty for none) and NPM make pages of FILES in FOLDER, in WORK;
# SOURCE is written in any case.

# Whether it went well; what it said when it did not.
function(try out)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${WORK} RESULT_VARIABLE result
                  OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(result EQUAL 0)
    set(${out} TRUE PARENT_SCOPE)
  else()
    set(${out} FALSE PARENT_SCOPE)
    string(JOIN " " command ${ARGN})
    message("rigor: this build has no page for `rigor view`: `${command}` failed (remove ${SOURCE} to \
try again):\n${said}")
  endif()
endfunction()

# Installed anew only when the lock file says something else.
function(install_packages out)
  file(SHA256 ${WORK}/package-lock.json digest)
  set(installed ${WORK}/node_modules/.rigor-lock)
  set(known "")
  if(EXISTS ${installed})
    file(READ ${installed} known)
  endif()
  if(known STREQUAL digest)
    set(${out} TRUE PARENT_SCOPE)
    return()
  endif()
  try(well ${NPM} ci --no-audit --no-fund --loglevel=error)
  if(well)
    file(WRITE ${installed} ${digest})
  endif()
  set(${out} ${well} PARENT_SCOPE)
endfunction()

set(page "")
set(live "")
if(NODE AND FILES)
  file(MAKE_DIRECTORY ${WORK})
  string(REPLACE "|" ";" files "${FILES}")
  foreach(name IN LISTS files)
    cmake_path(GET name PARENT_PATH parent)
    file(COPY ${FOLDER}/${name} DESTINATION ${WORK}/${parent})
  endforeach()
  install_packages(well)
  if(well)
    try(well ${NODE} build.mjs ${WORK}/out)
  endif()
  if(well)
    file(READ ${WORK}/out/page.html page)
    file(READ ${WORK}/out/page_live.html live)
  endif()
endif()
file(WRITE ${SOURCE} "#include <rigor/report/page/embedded_page.h>\n\nnamespace rigor::report {\n
std::string_view embedded_page() {\n  return R\"RIGORPAGE(" "${page}" ")RIGORPAGE\";\n}\n
std::string_view embedded_live_page() {\n  return R\"RIGORPAGE(" "${live}" ")RIGORPAGE\";\n}\n
}  // namespace rigor::report\n")
