# SPDX-License-Identifier: BSD-3-Clause

# Configures projects that have this one as a part: whole (add_subdirectory), without a host, beside a
# VTK of their own, or as a VTK module, shared or static.
function (configure project work)
  set(work "${BINARY_DIR}/Testing/${work}")
  file(REMOVE_RECURSE "${work}")
  # As deep as the sources: VTK 9.1 builds ../../Filters in ../../Filters of the build, not to be our own.
  execute_process(COMMAND "${CMAKE_COMMAND}" -G "${GENERATOR}"
    -S "${SOURCE_DIR}/Testing/${project}" -B "${work}/Testing/${project}"
    "-DHASHEDOCTREE_SOURCE_DIR=${SOURCE_DIR}" ${ARGN}
    COMMAND_ERROR_IS_FATAL ANY)
endfunction ()

configure(Subproject Subproject)
configure(Subproject SubprojectWithoutHost -DHASHEDOCTREE_HOST=NONE)
configure(Subproject SubprojectOfVTK -DOUTER_FINDS_VTK_ALONE=ON "-DVTK_DIR=${VTK_DIR}")
configure(Module Module)
configure(Module StaticModule -DBUILD_SHARED_LIBS=OFF
  -DCMAKE_CXX_STANDARD=14 -DCMAKE_EXPORT_COMPILE_COMMANDS=ON)
file(STRINGS "${BINARY_DIR}/Testing/StaticModule/Testing/Module/compile_commands.json" older
  REGEX "std=gnu\\+\\+14.*${SOURCE_DIR}/Filters/[A-Za-z/]*[.]cxx")
if (older)
  message(FATAL_ERROR "the module is compiled as C++14, and needs C++17: ${older}")
endif ()
