# SPDX-FileCopyrightText: HashedOctree contributors
# SPDX-License-Identifier: BSD-3-Clause

# Fails when clang-tidy finds something in a C++ file of ours (never in code that VTK generates).
find_program(RUN_CLANG_TIDY NAMES run-clang-tidy-14 run-clang-tidy REQUIRED) # Debian: clang-tidy
string(REGEX REPLACE "([][+.*()^$?|\\])" "\\\\\\1" source "${SOURCE_DIR}")
execute_process(
  COMMAND "${RUN_CLANG_TIDY}" -quiet -j 2 -p "${BINARY_DIR}"
    "^${source}/(Filters|Testing)/.*\\.cxx$"
  OUTPUT_VARIABLE output
  ERROR_VARIABLE  output
  RESULT_VARIABLE result)
if (NOT result EQUAL 0)
  # Not the colours, the command lines, nor the count of warnings in other people's headers.
  string(ASCII 27 escape)
  string(REGEX REPLACE "${escape}\\[[0-9;]*m" "" output "${output}")
  string(REGEX REPLACE "(^|\n)(clang-tidy|[0-9]+ warnings)[^\n]*" "" output "${output}")
  message(NOTICE "${output}")
  message(FATAL_ERROR "clang-tidy found the above")
endif ()
