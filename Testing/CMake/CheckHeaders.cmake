# SPDX-License-Identifier: BSD-3-Clause

# Fails when a header of the core, or of the tests' support, needs another one before it. One that has
# a source of its own stands first in it, and is not read here.
file(GLOB headers "${SOURCE_DIR}/Filters/Core/*.h" "${SOURCE_DIR}/Testing/Support/*.h")
set(found "")
foreach (header IN LISTS headers)
  string(REGEX REPLACE "h$" "cxx" source "${header}")
  if (EXISTS "${source}")
    continue()
  endif ()
  execute_process(
    COMMAND "${CXX}" -std=c++17 -fsyntax-only "-I${SOURCE_DIR}/Filters/Core"
      "-I${SOURCE_DIR}/Testing/Support" "-I${SOURCE_DIR}/Testing/Benchmarks" -x c++ "${header}"
    ERROR_VARIABLE  output
    RESULT_VARIABLE result)
  if (NOT result EQUAL 0)
    string(APPEND found "${output}\n")
  endif ()
endforeach ()
if (found)
  message(FATAL_ERROR "These headers do not compile by themselves; add what they should #include:\n${found}")
endif ()
