# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0

# The tests of the page, by node and a browser. They run in WORK, so that what npm fetches is not in the source
# tree. Where something is missing they are skipped and say so, unless RIGOR_REQUIRE_BROWSER is in the environment.

function(leave why)
  if(DEFINED ENV{RIGOR_REQUIRE_BROWSER})
    message(FATAL_ERROR "the page cannot be tested: ${why}")
  endif()
  message("the page is not tested: ${why}")
endfunction()

set(browser /usr/bin/chromium)
if(DEFINED ENV{RIGOR_CHROMIUM})
  set(browser $ENV{RIGOR_CHROMIUM})
endif()
if(NOT EXISTS ${browser})
  leave("there is no ${browser} (apt install chromium)")
  return()
endif()
if(NOT NODE OR NOT NPM OR NOT EXISTS ${PAGE}/page.html)
  leave("node and npm were not there when rigor was built")
  return()
endif()

file(COPY ${SOURCE}/tests/page DESTINATION ${WORK}/tests PATTERN node_modules EXCLUDE)
foreach(folder lib testdata)
  file(CREATE_LINK ${SOURCE}/${folder} ${WORK}/${folder} SYMBOLIC)
endforeach()
execute_process(COMMAND ${NPM} ci --no-audit --no-fund --loglevel=error WORKING_DIRECTORY ${WORK}/tests/page
                RESULT_VARIABLE result OUTPUT_VARIABLE said ERROR_VARIABLE said)
if(NOT result EQUAL 0)
  leave("npm ci failed:\n${said}")
  return()
endif()
execute_process(COMMAND ${CMAKE_COMMAND} -E env RIGOR_BINARY=${RIGOR} RIGOR_PAGE=${PAGE} ${NODE} --test
                WORKING_DIRECTORY ${WORK}/tests/page COMMAND_ERROR_IS_FATAL ANY)
