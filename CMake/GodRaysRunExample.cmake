# SPDX-FileCopyrightText: Copyright (c) the vtkGodRays authors
# SPDX-License-Identifier: BSD-3-Clause

# cmake -DPICTURE=<file.png> -P GodRaysRunExample.cmake -- <command>...
#
# Run an example and see that it writes its picture.

set(command)
set(started FALSE)
math(EXPR last "${CMAKE_ARGC} - 1")
foreach(i RANGE ${last})
  if(started)
    list(APPEND command "${CMAKE_ARGV${i}}")
  elseif(CMAKE_ARGV${i} STREQUAL "--")
    set(started TRUE)
  endif()
endforeach()

file(REMOVE "${PICTURE}")
execute_process(COMMAND ${command} "${PICTURE}" RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "The example ended with ${result}: see its messages above.")
endif()
if(NOT EXISTS "${PICTURE}")
  message(FATAL_ERROR "The example did not write ${PICTURE}, the file that its argument names.")
endif()
