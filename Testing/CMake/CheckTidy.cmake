# SPDX-License-Identifier: BSD-3-Clause

# Fails when clang-tidy finds something in a C++ file of ours (never in code that VTK generates).
# Nearly all of its time goes to the headers of GoogleTest and VTK, so that the tests are read several
# at a time, in units that are made here.
include("${CMAKE_CURRENT_LIST_DIR}/SkipOtherClang.cmake")
find_program(CLANG_TIDY NAMES clang-tidy-14 clang-tidy REQUIRED) # Debian: clang-tidy
find_program(RUN_CLANG_TIDY NAMES run-clang-tidy-14 run-clang-tidy REQUIRED)
skip_other_clang("${CLANG_TIDY}")
set(TESTS_IN_UNIT 16)
set(folder "${BINARY_DIR}/Testing/Tidy")

# add_command(<compilation> [<from> <to>]): appends one to the compilation database, of another file.
function (add_command compilation)
  if (ARGN)
    list(GET ARGN 0 from)
    list(GET ARGN 1 to)
    string(REPLACE "${from}" "${to}" compilation "${compilation}")
  endif ()
  if (database)
    string(PREPEND compilation ",\n")
  endif ()
  set(database "${database}${compilation}" PARENT_SCOPE)
endfunction ()

# write_unit(<unit> <test>...): all headers first, so that the tests' own #includes do nothing inside
# the namespaces, which keep the tests' names apart.
function (write_unit unit)
  set(headers "")
  set(bodies "")
  foreach (test IN LISTS ARGN)
    file(STRINGS "${test}" lines REGEX "^#include ")
    list(APPEND headers ${lines})
    get_filename_component(name "${test}" NAME_WE)
    string(TOLOWER "${name}" name)
    string(APPEND bodies "namespace ${name}\n{\n#include \"${test}\" // NOLINT\n}\n")
  endforeach ()
  list(REMOVE_DUPLICATES headers)
  list(JOIN headers "\n" headers)
  file(WRITE "${unit}" "${headers}\n${bodies}")
endfunction ()

file(REMOVE_RECURSE "${folder}")
file(COPY "${SOURCE_DIR}/.clang-tidy" DESTINATION "${folder}")
file(READ "${BINARY_DIR}/compile_commands.json" compilations)
string(JSON last LENGTH "${compilations}")
math(EXPR last "${last} - 1")
set(database "")
foreach (room IN ITEMS Core Cxx)
  set(tests_${room} "")
endforeach ()
foreach (i RANGE ${last})
  string(JSON compilation GET "${compilations}" ${i})
  string(JSON file GET "${compilation}" file)
  file(RELATIVE_PATH path "${SOURCE_DIR}" "${file}")
  if (path MATCHES "^Testing/(Core|Cxx)/")
    list(APPEND tests_${CMAKE_MATCH_1} "${file}")
    set(compilation_${CMAKE_MATCH_1} "${compilation}")
  elseif (path MATCHES "^(Filters|Testing)/.*\\.cxx$")
    add_command("${compilation}")
  endif ()
endforeach ()
foreach (room IN ITEMS Core Cxx)
  set(number 0)
  while (tests_${room})
    math(EXPR number "${number} + 1")
    list(SUBLIST tests_${room} 0 ${TESTS_IN_UNIT} tests)
    list(REMOVE_ITEM tests_${room} ${tests})
    set(unit "${folder}/${room}${number}.cxx")
    write_unit("${unit}" ${tests})
    string(JSON file GET "${compilation_${room}}" file)
    add_command("${compilation_${room}}" "${file}" "${unit}")
  endwhile ()
endforeach ()
file(WRITE "${folder}/compile_commands.json" "[\n${database}\n]\n")

execute_process(
  COMMAND "${RUN_CLANG_TIDY}" -quiet -j 2 -p "${folder}"
    "-extra-arg=-I${SOURCE_DIR}/Testing/Core" "-extra-arg=-I${SOURCE_DIR}/Testing/Cxx"
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
