# SPDX-License-Identifier: BSD-3-Clause

# Fails when a test file under Testing is not run by ctest.
file(GLOB_RECURSE found RELATIVE "${SOURCE_DIR}/Testing"
  "${SOURCE_DIR}/Testing/Test*.cxx" "${SOURCE_DIR}/Testing/Test*.py"
  "${SOURCE_DIR}/Testing/Fuzz/Fuzz*.cxx")
file(STRINGS "${BINARY_DIR}/Testing/Registered.txt" registered)
if (NOT found)
  message(FATAL_ERROR "No test files under ${SOURCE_DIR}/Testing")
endif ()
list(REMOVE_ITEM found ${registered})
if (found)
  list(JOIN found ", " found)
  message(FATAL_ERROR "Not registered in Testing/CMakeLists.txt or Testing/Fuzz/CMakeLists.txt: ${found}")
endif ()
