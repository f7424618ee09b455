# SPDX-License-Identifier: BSD-3-Clause

# Installs the project, moves the result, and uses it as others do: from CMake, Python and ParaView.
function (run)
  execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY)
endfunction ()

set(work "${BINARY_DIR}/Testing/Install")
set(prefix "${work}/moved here")
file(REMOVE_RECURSE "${work}")
file(MAKE_DIRECTORY "${work}")
# The list of what the user has installed stays, whoever wrote it; after a run that was killed, too.
set(manifest "${BINARY_DIR}/install_manifest.txt")
set(list_of_user "${BINARY_DIR}/install_manifest_of_user.txt")
if (EXISTS "${manifest}" AND NOT EXISTS "${list_of_user}")
  file(RENAME "${manifest}" "${list_of_user}")
endif ()
unset(ENV{DESTDIR})
execute_process(RESULT_VARIABLE result COMMAND
  "${CMAKE_COMMAND}" --install "${BINARY_DIR}" --config "${CONFIG}" --prefix "${work}/first")
if (EXISTS "${manifest}")
  file(STRINGS "${manifest}" listed)
endif ()
file(REMOVE "${manifest}")
if (EXISTS "${list_of_user}")
  file(RENAME "${list_of_user}" "${manifest}")
endif ()
if (NOT result EQUAL 0)
  message(FATAL_ERROR "The project cannot be installed")
endif ()
foreach (file IN LISTS listed)
  if (NOT EXISTS "${file}")
    message(SEND_ERROR "The list of installed files names one that is not: ${file}")
  endif ()
endforeach ()
file(RENAME "${work}/first" "${prefix}")

# What must not be there: paths of the build, the core, and the static wrapper.
file(GLOB_RECURSE files "${prefix}/*")
foreach (file IN LISTS files)
  if (file MATCHES "\\.a$")
    message(SEND_ERROR "A static library is installed: ${file}")
  endif ()
  file(READ "${file}" content HEX)
  string(HEX "${BINARY_DIR}/" needle)
  if (content MATCHES "${needle}")
    message(SEND_ERROR "The path of the build is in ${file}")
  endif ()
endforeach ()

if (NOT EXISTS "${prefix}/share/licenses/HashedOctree/LICENSE")
  message(SEND_ERROR "The license is not installed")
endif ()

# What must not leave the library, by its mangled namespace: two versions of the core may be in one program.
execute_process(COMMAND "${NM}" --dynamic --defined-only "${prefix}/${LIBRARY}"
  OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
if (NOT symbols MATCHES "vtkHashedOctreeFilter")
  message(SEND_ERROR "The library shows none of its classes")
endif ()
string(REGEX MATCH "[^ \n]*12hashedoctree[^ \n]*" symbol "${symbols}")
if (symbol)
  message(SEND_ERROR "The library shows the core's ${symbol}")
endif ()

run("${CMAKE_COMMAND}" -G "${GENERATOR}" -S "${SOURCE_DIR}/Testing/Consumer" -B "${work}/consumer"
  "-DCMAKE_PREFIX_PATH=${prefix}" "-DPython3_EXECUTABLE=${PYTHON}" -DCMAKE_BUILD_TYPE=Release)
run("${CMAKE_COMMAND}" --build "${work}/consumer")
run("${work}/consumer/consumer")

file(WRITE "${work}/other/CMakeLists.txt" "cmake_minimum_required(VERSION 3.22)
project(Other CXX)
find_package(HashedOctree REQUIRED COMPONENTS Filters Other)
")
execute_process(COMMAND "${CMAKE_COMMAND}" -G "${GENERATOR}" -S "${work}/other" -B "${work}/other/build"
  "-DCMAKE_PREFIX_PATH=${prefix}" RESULT_VARIABLE result ERROR_VARIABLE problem OUTPUT_QUIET)
if (result EQUAL 0 OR NOT problem MATCHES "HashedOctree has no component Other")
  message(SEND_ERROR "A component that is not there is not told of: ${problem}")
endif ()

file(GLOB_RECURSE plugin "${prefix}/*/${PLUGIN}")
set(ENV{PYTHONPATH} "${prefix}/${PYTHON_DIR}")
run("${PVPYTHON}" --dr "${SOURCE_DIR}/Testing/Consumer/LoadInstalled.py" "${plugin}" "${prefix}")
