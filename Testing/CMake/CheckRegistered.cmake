# SPDX-License-Identifier: BSD-3-Clause

# Fails when a test file under Testing is not run by ctest, or holds tests under another name.
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

file(GLOB sources "${SOURCE_DIR}/Testing/Core/*.cxx" "${SOURCE_DIR}/Testing/Cxx/*.cxx")
foreach (source IN LISTS sources)
  get_filename_component(name "${source}" NAME_WE)
  file(STRINGS "${source}" tests REGEX "^(TEST|TEST_F|TEST_P|TYPED_TEST)\\(")
  list(FILTER tests EXCLUDE REGEX "\\(${name}[A-Za-z]*,")
  if (tests)
    message(SEND_ERROR "Tests of ${source} begin with its name, unlike: ${tests}")
  endif ()
endforeach ()
