# SPDX-License-Identifier: BSD-3-Clause

# Fails when clang-tidy finds something in a C++ file of ours (never in code that VTK generates).
# Nearly all of its time goes to headers, so that several files are read at a time: tests in the units
# that they are compiled in, others in units that are made here, so that sources of one folder must not
# have the same name for two things, in nameless namespaces either.
include("${CMAKE_CURRENT_LIST_DIR}/SkipOtherClang.cmake")
find_program(CLANG_TIDY NAMES clang-tidy-14 clang-tidy REQUIRED) # Debian: clang-tidy
find_program(RUN_CLANG_TIDY NAMES run-clang-tidy-14 run-clang-tidy REQUIRED)
skip_other_clang("${CLANG_TIDY}")
set(FILES_IN_UNIT 16)
set(folder "${BINARY_DIR}/Testing/Tidy")

file(REMOVE_RECURSE "${folder}")
file(COPY "${SOURCE_DIR}/.clang-tidy" DESTINATION "${folder}")
file(READ "${BINARY_DIR}/compile_commands.json" compilations)
string(JSON last LENGTH "${compilations}")
math(EXPR last "${last} - 1")

# Files that are compiled in the same way go together; but for units of tests, and for fuzzers, all of
# which define one function.
set(groups "")
foreach (i RANGE ${last})
  string(JSON compilation GET "${compilations}" ${i})
  string(JSON file GET "${compilation}" file)
  file(RELATIVE_PATH path "${SOURCE_DIR}" "${file}")
  file(RELATIVE_PATH made "${BINARY_DIR}" "${file}")
  if (made MATCHES "^Testing/[^/]*\\.cxx$" OR path MATCHES "^Testing/Fuzz/.*\\.cxx$")
    set(group "${file}")
  elseif (path MATCHES "^(Filters|Testing)/.*\\.cxx$")
    string(JSON group GET "${compilation}" command)
    string(REGEX REPLACE " -o .*" "" group "${group}")
  else ()
    continue()
  endif ()
  string(MD5 group "${group}")
  list(APPEND groups "${group}")
  list(APPEND "files_${group}" "${file}")
  set("compilation_${group}" "${compilation}")
  set("example_${group}" "${file}")
endforeach ()
list(REMOVE_DUPLICATES groups)

set(database "")
set(separator "")
set(number 0)
foreach (group IN LISTS groups)
  while (files_${group})
    list(SUBLIST "files_${group}" 0 ${FILES_IN_UNIT} files)
    list(REMOVE_ITEM "files_${group}" ${files})
    list(TRANSFORM files REPLACE "^.+$" "#include \"\\0\" // NOLINT\n" OUTPUT_VARIABLE unit)
    list(JOIN unit "" unit)
    math(EXPR number "${number} + 1")
    set(file "${folder}/Unit${number}.cxx")
    file(WRITE "${file}" "${unit}")
    string(REPLACE "${example_${group}}" "${file}" compilation "${compilation_${group}}")
    string(APPEND database "${separator}${compilation}")
    set(separator ",\n")
  endwhile ()
endforeach ()
file(WRITE "${folder}/compile_commands.json" "[\n${database}\n]\n")

execute_process(
  COMMAND "${RUN_CLANG_TIDY}" -quiet -j 2 -p "${folder}"
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
