# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
#
# Run by CPack between installing and packing: puts into each package what Debian's policy wants of one.

string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)  # of SOURCE_DATE_EPOCH, where that is set

function(compress)
  execute_process(COMMAND gzip -9nf ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

foreach(pair program:rigor dev:librigor-dev)
  string(REPLACE ":" ";" pair ${pair})
  list(GET pair 0 component)
  list(GET pair 1 package)
  set(root ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/${component}/usr)
  if(NOT IS_DIRECTORY ${root})
    continue()
  endif()
  set(doc ${root}/share/doc/${package})
  file(MAKE_DIRECTORY ${doc})
  configure_file(${CPACK_RIGOR_PACKAGING}/copyright ${doc}/copyright COPYONLY)
  file(WRITE ${doc}/changelog.Debian
       "rigor (${CPACK_RIGOR_VERSION}) unstable; urgency=medium\n\n  * Release, as changelog.gz tells.\n\n"
       " -- ${CPACK_RIGOR_MAINTAINER}  ${date}\n")
  if(component STREQUAL program)
    file(RENAME ${doc}/CHANGELOG.md ${doc}/changelog)
    file(REMOVE ${doc}/LICENSE)  # the copyright file says where Debian keeps it
    file(GLOB pages ${root}/share/man/man1/*.1)
    compress(${doc}/changelog ${pages})
  endif()
  compress(${doc}/changelog.Debian)
  set(overrides ${CPACK_RIGOR_PACKAGING}/${package}.lintian-overrides)
  if(EXISTS ${overrides})
    file(MAKE_DIRECTORY ${root}/share/lintian/overrides)
    configure_file(${overrides} ${root}/share/lintian/overrides/${package} COPYONLY)
  endif()
endforeach()

# With all times the release's, the same commit gives the same bytes.
if(DEFINED ENV{SOURCE_DATE_EPOCH})
  execute_process(COMMAND find ${CPACK_TEMPORARY_INSTALL_DIRECTORY}
                          -exec touch -hd @$ENV{SOURCE_DATE_EPOCH} {} + COMMAND_ERROR_IS_FATAL ANY)
endif()
