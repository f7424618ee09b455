# SPDX-License-Identifier: BSD-3-Clause

# Configures projects that have this one as a part, whole (add_subdirectory) or as a VTK module.
foreach (project IN ITEMS Subproject Module)
  set(work "${BINARY_DIR}/Testing/${project}")
  file(REMOVE_RECURSE "${work}")
  execute_process(COMMAND "${CMAKE_COMMAND}" -G "${GENERATOR}"
    -S "${SOURCE_DIR}/Testing/${project}" -B "${work}" "-DHASHEDOCTREE_SOURCE_DIR=${SOURCE_DIR}"
    COMMAND_ERROR_IS_FATAL ANY)
endforeach ()
