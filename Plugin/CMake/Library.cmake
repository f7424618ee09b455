# SPDX-License-Identifier: BSD-3-Clause

# The VTK module HashedOctree::Filters, its Python package, and find_package(HashedOctree).

# --- The module ---------------------------------------------------------------------------------
vtk_module_scan(
  MODULE_FILES            "${PROJECT_SOURCE_DIR}/Filters/vtk.module"
  REQUEST_MODULES         HashedOctree::Filters
  PROVIDES_MODULES        modules
  WANT_BY_DEFAULT         ON
  HIDE_MODULES_FROM_CACHE ON)
vtk_module_build(
  MODULES             ${modules}
  PACKAGE             HashedOctree
  VERSION             "${PROJECT_VERSION}"
  SOVERSION           "${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}"
  INSTALL_EXPORT      HashedOctree
  HEADERS_DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/hashedoctree"
  CMAKE_DESTINATION   "${HASHEDOCTREE_CMAKE_DIR}"
  ENABLE_WRAPPING     ON) # writes the class hierarchy that both Python and the plugin's wrappers read
hashedoctree_own_code(HashedOctree::Filters)

# --- The Python package ----------------------------------------------------------------------------
if (HASHEDOCTREE_HAVE_PYTHON)
  vtk_module_wrap_python(
    MODULES             ${modules}
    TARGET              HashedOctree::Python
    PYTHON_PACKAGE      hashedoctree
    MODULE_DESTINATION  "${HASHEDOCTREE_PYTHON_DIR}"
    LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}" # gives the installed wrapper its $ORIGIN path
    CMAKE_DESTINATION   "${HASHEDOCTREE_CMAKE_DIR}"
    INSTALL_HEADERS     OFF
    BUILD_STATIC        OFF)
  set(package "${HASHEDOCTREE_PYTHON_DIR}/hashedoctree")
  # Where VTK builds the rest of the package, also when the project is within another.
  configure_file(Plugin/CMake/__init__.py.in "${CMAKE_BINARY_DIR}/${package}/__init__.py" @ONLY)
  configure_file(Filters/Python/arrays.py "${CMAKE_BINARY_DIR}/${package}/arrays.py" COPYONLY)
  install(FILES "${CMAKE_BINARY_DIR}/${package}/__init__.py" Filters/Python/arrays.py
    DESTINATION "${package}")
endif ()

# --- The CMake package -----------------------------------------------------------------------------
include(CMakePackageConfigHelpers)
set(config "${PROJECT_BINARY_DIR}/${HASHEDOCTREE_CMAKE_DIR}/HashedOctreeConfig")
configure_package_config_file(Plugin/CMake/HashedOctreeConfig.cmake.in "${config}.cmake"
  INSTALL_DESTINATION "${HASHEDOCTREE_CMAKE_DIR}")
write_basic_package_version_file("${config}Version.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${config}.cmake" "${config}Version.cmake" DESTINATION "${HASHEDOCTREE_CMAKE_DIR}")
install(FILES LICENSE DESTINATION "${CMAKE_INSTALL_DATADIR}/licenses/HashedOctree")
