# SPDX-License-Identifier: BSD-3-Clause

# Configures a project that has this one as a part (add_subdirectory).
set(work "${BINARY_DIR}/Testing/Subproject")
file(REMOVE_RECURSE "${work}")
execute_process(COMMAND "${CMAKE_COMMAND}" -G "${GENERATOR}"
  -S "${SOURCE_DIR}/Testing/Subproject" -B "${work}" "-DHASHEDOCTREE_SOURCE_DIR=${SOURCE_DIR}"
  "-DHASHEDOCTREE_HOST=${HOST}"
  COMMAND_ERROR_IS_FATAL ANY)
