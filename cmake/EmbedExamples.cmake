# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0

# embed_examples(OUT FOLDER): a source file that holds the examples of the rules. They lie in FOLDER, in
# <category>/<rule-name>/, as files of their own formats: bad.sdf, bad_2.urdf, bad.fixed.sdf, good.sdf …
# What lies beside such a file in its example is in a folder of its name (bad_2/meshes/wheel.stl), what
# lies in the folder above it in one named bad_2.parent. <category>/good.sdf is the good example of the
# rules of that category that have none.
#
# The source is written when the project is built: this file is also the script that writes it.
function(embed_examples out folder)
  file(GLOB_RECURSE files CONFIGURE_DEPENDS ${folder}/*/*)
  list(FILTER files EXCLUDE REGEX "\\.(cc|h)$")
  set(source ${CMAKE_CURRENT_BINARY_DIR}/embedded_examples.cc)
  list(JOIN files "\n" list)
  file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/examples.txt CONTENT "@list@" @ONLY)
  add_custom_command(OUTPUT ${source}
    COMMAND ${CMAKE_COMMAND} -DLIST=${CMAKE_CURRENT_BINARY_DIR}/examples.txt -DFOLDER=${folder}
            -DSOURCE=${source} -P ${CMAKE_CURRENT_FUNCTION_LIST_FILE}
    DEPENDS ${files} ${CMAKE_CURRENT_BINARY_DIR}/examples.txt ${CMAKE_CURRENT_FUNCTION_LIST_FILE}
    COMMENT "Embedding the rules' examples" VERBATIM)
  set(${out} ${source} PARENT_SCOPE)
endfunction()

if(NOT CMAKE_SCRIPT_MODE_FILE)
  return()
endif()

# Any byte may be in an example: each is written as its number.
function(literal out hex)
  string(LENGTH "${hex}" digits)
  math(EXPR size "${digits} / 2")
  string(REGEX REPLACE "(..)" "\\\\x\\1" bytes "${hex}")
  set(${out} "{\"${bytes}\", ${size}}" PARENT_SCOPE)
endfunction()

file(STRINGS ${LIST} files)
list(SORT files COMPARE NATURAL)
set(examples "")
foreach(file IN LISTS files)
  file(RELATIVE_PATH path ${FOLDER} ${file})
  if(NOT path MATCHES "^([^/]+)/([^/]+/)?((bad|good)(_[0-9]+)?)\\.[a-z]+$")
    continue()
  endif()
  cmake_path(GET file PARENT_PATH folder)
  set(name ${CMAKE_MATCH_3})
  set(kind ${CMAKE_MATCH_4})
  cmake_path(GET folder FILENAME rule)  # or its whole category
  file(READ ${file} text HEX)
  if(file MATCHES "\\.xacro$")
    string(HEX "=== robot.urdf.xacro\n" line)
    string(PREPEND text ${line})
  elseif(file MATCHES "\\.srdf$")
    string(HEX "=== robot.srdf\n" line)
    string(PREPEND text ${line})
  endif()
  foreach(beside "" ".parent")
    if(NOT IS_DIRECTORY ${folder}/${name}${beside})
      continue()
    endif()
    file(GLOB_RECURSE others ${folder}/${name}${beside}/*)
    list(SORT others COMPARE NATURAL)
    foreach(other IN LISTS others)
      file(RELATIVE_PATH path ${folder}/${name}${beside} ${other})
      if(beside)
        string(PREPEND path "../")
      endif()
      string(HEX "=== ${path}\n" line)
      file(READ ${other} bytes HEX)
      string(APPEND text ${line}${bytes})
    endforeach()
  endforeach()
  literal(text "${text}")
  cmake_path(GET file EXTENSION LAST_ONLY ending)
  set(fixed "{}")
  if(EXISTS ${folder}/${name}.fixed${ending})
    file(READ ${folder}/${name}.fixed${ending} fixed HEX)
    literal(fixed "${fixed}")
  endif()
  string(APPEND examples "    {\"${rule}\", ExampleKind::k_${kind}, {${text}, ${fixed}}},\n")
endforeach()
string(REPLACE "k_bad" "kBad" examples "${examples}")
string(REPLACE "k_good" "kGood" examples "${examples}")
file(WRITE ${SOURCE} "#include <rigor/rules/embedded_examples.h>

namespace rigor::rules {
namespace {

constexpr EmbeddedExample kExamples[] = {
${examples}};

}  // namespace

std::span<const EmbeddedExample> embedded_examples() { return kExamples; }

}  // namespace rigor::rules
")
