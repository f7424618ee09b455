# SPDX-License-Identifier: BSD-3-Clause

# hashedoctree_own_code(<target>): compile a target of ours with our warnings and sanitizers.
# Code that VTK's wrappers generate is not ours, so these are options of targets, not of all code.
function (hashedoctree_own_code target)
  get_target_property(aliased "${target}" ALIASED_TARGET)
  if (aliased)
    set(target "${aliased}")
  endif ()
  # Clang's -Wconversion includes -Wsign-conversion, GCC's does not.
  target_compile_options("${target}" PRIVATE
    -Wall -Wextra -Wshadow -Wconversion -Wno-sign-conversion)
  # What VTK 9.1 has may be deprecated since.
  target_compile_definitions("${target}" PRIVATE "VTK_DEPRECATION_LEVEL=VTK_VERSION_CHECK(9, 1, 0)")
  if (HASHEDOCTREE_WERROR)
    target_compile_options("${target}" PRIVATE -Werror)
  endif ()
  if (HASHEDOCTREE_SANITIZE)
    set(sanitize "-fsanitize=${HASHEDOCTREE_SANITIZE}")
    target_compile_options("${target}" PRIVATE
      "${sanitize}" -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options("${target}" PRIVATE "${sanitize}")
  endif ()
endfunction ()
