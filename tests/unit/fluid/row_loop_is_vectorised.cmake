# SPDX-License-Identifier: BSD-3-Clause
# Fails unless g++ vectorises every instance of the fluid's row loop at the full width of its instruction set.
#   cmake -D COMPILER=g++ -D SOURCE=collide.cpp -D HEADER=row.hpp -D LOOPS=32 -P this -- FLAG...
set(flags)
set(after_dashes FALSE)
math(EXPR last "${CMAKE_ARGC} - 1")
foreach(i RANGE ${last})
  if(after_dashes)
    list(APPEND flags ${CMAKE_ARGV${i}})
  elseif(CMAKE_ARGV${i} STREQUAL "--")
    set(after_dashes TRUE)
  endif()
endforeach()

execute_process(COMMAND ${COMPILER} ${flags} -x c++ -dM -E /dev/null OUTPUT_VARIABLE macros COMMAND_ERROR_IS_FATAL ANY)
set(width 16)
if(macros MATCHES "__AVX512F__")
  set(width 64)
elseif(macros MATCHES "__AVX__")
  set(width 32)
endif()

execute_process(COMMAND ${COMPILER} ${flags} -w -fopt-info-vec-optimized -c ${SOURCE} -o /dev/null
  ERROR_VARIABLE report COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "${HEADER}:[0-9:]+ optimized: loop vectorized using ${width} byte vectors" hits "${report}")
list(LENGTH hits count)
if(NOT count EQUAL LOOPS)
  message(FATAL_ERROR "${count} of ${LOOPS} instances of the row loop are vectorised with ${width} bytes; "
    "compile ${SOURCE} with -fopt-info-vec-missed to see why.")
endif()
message("${count} instances of the row loop are vectorised with ${width} bytes")
