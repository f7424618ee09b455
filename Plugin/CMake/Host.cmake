# SPDX-License-Identifier: BSD-3-Clause

# Finds what HASHEDOCTREE_HOST asks for, and sets HASHEDOCTREE_HAVE_VTK, HASHEDOCTREE_HAVE_PARAVIEW,
# HASHEDOCTREE_HAVE_PLUGIN and HASHEDOCTREE_HAVE_PYTHON. ParaView brings a VTK of its own.
if (NOT HASHEDOCTREE_HOST MATCHES "^(AUTO|PARAVIEW|VTK|NONE)$")
  message(FATAL_ERROR
    "HASHEDOCTREE_HOST is '${HASHEDOCTREE_HOST}', but must be AUTO, PARAVIEW, VTK or NONE.")
endif ()
if (NOT HASHEDOCTREE_PYTHON MATCHES "^(AUTO|ON|OFF)$")
  message(FATAL_ERROR "HASHEDOCTREE_PYTHON is '${HASHEDOCTREE_PYTHON}', but must be AUTO, ON or OFF.")
endif ()

set(HASHEDOCTREE_HAVE_PARAVIEW OFF) # Whatever another project, of which this is a part, has found.
set(quiet)
if (HASHEDOCTREE_HOST STREQUAL "AUTO")
  set(quiet QUIET)
endif ()
set(found_without_python OFF) # VTK, by another project: its target for Python then lacks what it links to.
if (TARGET VTK::CommonCore AND NOT TARGET Python3::Module)
  set(found_without_python ON)
endif ()
if (HASHEDOCTREE_HOST STREQUAL "AUTO" AND TARGET VTK::CommonCore AND NOT ParaView_FOUND)
  message(STATUS "HashedOctree: the VTK that the other project has found")
elseif (HASHEDOCTREE_HOST MATCHES "AUTO|PARAVIEW")
  set(components RemotingCore) # for the VTK inside it
  if (HASHEDOCTREE_PLUGIN)
    list(APPEND components RemotingServerManager)
  endif ()
  find_package(ParaView 5.11 ${quiet} COMPONENTS ${components})
  set(HASHEDOCTREE_HAVE_PARAVIEW "${ParaView_FOUND}")
endif ()
if (HASHEDOCTREE_HOST STREQUAL "VTK" OR
    (HASHEDOCTREE_HOST STREQUAL "AUTO" AND NOT HASHEDOCTREE_HAVE_PARAVIEW))
  find_package(VTK 9.1 ${quiet}
    COMPONENTS CommonCore CommonDataModel CommonExecutionModel ParallelCore
    OPTIONAL_COMPONENTS Python WrappingPythonCore)
endif ()

set(HASHEDOCTREE_HAVE_VTK OFF)
if (HASHEDOCTREE_HAVE_PARAVIEW OR (VTK_FOUND AND HASHEDOCTREE_HOST MATCHES "AUTO|VTK"))
  set(HASHEDOCTREE_HAVE_VTK ON)
elseif (NOT HASHEDOCTREE_HOST STREQUAL "NONE")
  set(missing_AUTO "Neither ParaView 5.11 nor VTK 9.1 was found.")
  set(missing_PARAVIEW "ParaView 5.11 was not found, as HASHEDOCTREE_HOST=PARAVIEW asks.")
  set(missing_VTK "VTK 9.1 was not found, as HASHEDOCTREE_HOST=VTK asks.")
  message(FATAL_ERROR
    "${missing_${HASHEDOCTREE_HOST}} On Debian, install for ParaView: "
    "paraview-dev python3-paraview python3-dev libopenmpi-dev libdouble-conversion-dev; "
    "for VTK alone: libvtk9-dev python3-vtk9 python3-dev; "
    "or build the core alone with -DHASHEDOCTREE_HOST=NONE.")
endif ()

set(HASHEDOCTREE_HAVE_PLUGIN OFF)
if (HASHEDOCTREE_PLUGIN AND HASHEDOCTREE_HAVE_PARAVIEW)
  set(HASHEDOCTREE_HAVE_PLUGIN ON)
endif ()
set(HASHEDOCTREE_HAVE_PYTHON OFF)
if (HASHEDOCTREE_PYTHON AND TARGET VTK::WrappingPythonCore AND TARGET VTK::Python AND
    NOT found_without_python)
  set(HASHEDOCTREE_HAVE_PYTHON ON)
  find_package(Python3 REQUIRED COMPONENTS Interpreter)
elseif (HASHEDOCTREE_PYTHON AND NOT HASHEDOCTREE_PYTHON STREQUAL "AUTO")
  message(WARNING "HASHEDOCTREE_PYTHON=${HASHEDOCTREE_PYTHON}, but there is no VTK here that knows Python: "
    "the Python package is not built. On Debian, install python3-dev; or configure with -DHASHEDOCTREE_PYTHON=OFF.")
endif ()
message(STATUS "HashedOctree: VTK ${VTK_VERSION}, ParaView ${ParaView_VERSION}, "
  "plugin ${HASHEDOCTREE_HAVE_PLUGIN}, Python ${HASHEDOCTREE_HAVE_PYTHON}")
