# SPDX-License-Identifier: BSD-3-Clause

# Fails when Filters/Core or its tests include VTK, Qt or ParaView, or when Plugin holds C++, or when
# Filters declares classes of VTK instead of including them.
file(GLOB_RECURSE core
  "${SOURCE_DIR}/Filters/Core/*.h" "${SOURCE_DIR}/Filters/Core/*.cxx"
  "${SOURCE_DIR}/Testing/Core/*.h" "${SOURCE_DIR}/Testing/Core/*.cxx")
if (NOT core)
  message(FATAL_ERROR "No sources under ${SOURCE_DIR}/Filters/Core")
endif ()
foreach (file IN LISTS core)
  file(STRINGS "${file}" includes REGEX "^[ \t]*#[ \t]*include[ \t]*[<\"]([^>\"]*/)?(vtk|pq|Q[A-Z])")
  if (includes)
    message(SEND_ERROR "The core must know no VTK: ${file}: ${includes}")
  endif ()
endforeach ()

set(cxx)
foreach (extension IN ITEMS h hpp hxx txx c cc cpp cxx)
  list(APPEND cxx "${SOURCE_DIR}/Plugin/*.${extension}")
endforeach ()
file(GLOB_RECURSE cxx ${cxx})
if (cxx)
  message(SEND_ERROR "Plugin must hold no C++ (it belongs in Filters): ${cxx}")
endif ()

# VTK can be configured to have its classes in a namespace, where such a declaration does not reach.
file(GLOB filters "${SOURCE_DIR}/Filters/*.h" "${SOURCE_DIR}/Filters/*.cxx")
foreach (file IN LISTS filters)
  file(STRINGS "${file}" declared REGEX "^class vtk[A-Za-z0-9]+;")
  list(FILTER declared EXCLUDE REGEX "vtkHashedOctree")
  if (declared)
    message(SEND_ERROR "Include VTK's classes instead of declaring them: ${file}: ${declared}")
  endif ()
endforeach ()
