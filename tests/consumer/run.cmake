# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0

function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${RIGOR_BUILD} --prefix ${WORK}/prefix)
run(${CMAKE_COMMAND} -S ${SOURCE} -B ${WORK}/build -DCMAKE_PREFIX_PATH=${WORK}/prefix
    -DCMAKE_CXX_COMPILER=${COMPILER})
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/consumer ${SOURCE}/good.sdf)
# The mesh is one for the worker.
foreach(bad bad bad_mesh)
  execute_process(COMMAND ${WORK}/build/consumer ${SOURCE}/${bad}.sdf RESULT_VARIABLE errors)
  if(NOT errors EQUAL 1)
    message(FATAL_ERROR "${bad}.sdf has one error, but the consumer counted ${errors}")
  endif()
endforeach()
