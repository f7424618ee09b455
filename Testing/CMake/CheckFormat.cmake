# SPDX-License-Identifier: BSD-3-Clause

# Fails when a C++ file is not as .clang-format says. To mend it: clang-format -i <file>
include("${CMAKE_CURRENT_LIST_DIR}/SkipOtherClang.cmake")
find_program(CLANG_FORMAT NAMES clang-format-14 clang-format REQUIRED) # Debian: clang-format
skip_other_clang("${CLANG_FORMAT}")
file(GLOB_RECURSE files
  "${SOURCE_DIR}/Filters/*.h" "${SOURCE_DIR}/Filters/*.cxx"
  "${SOURCE_DIR}/Testing/*.h" "${SOURCE_DIR}/Testing/*.cxx")
execute_process(
  COMMAND "${CLANG_FORMAT}" --dry-run -Werror ${files}
  COMMAND_ERROR_IS_FATAL ANY)
