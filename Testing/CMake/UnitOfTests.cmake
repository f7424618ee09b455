# SPDX-License-Identifier: BSD-3-Clause

# make_unit_of_tests(<result> <test>...): all headers first, so that the tests' own #includes do
# nothing inside the namespaces, which keep the tests' names apart. GCC does not know that the nameless
# ones in these are included nowhere else.
function (make_unit_of_tests result)
  set(headers
    "#ifndef __clang__" "#pragma GCC diagnostic ignored \"-Wsubobject-linkage\"" "#endif")
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
  set("${result}" "${headers}\n${bodies}" PARENT_SCOPE)
endfunction ()
