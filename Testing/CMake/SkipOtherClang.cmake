# SPDX-License-Identifier: BSD-3-Clause

# skip_other_clang(<tool>): ends a check as skipped where the tool is not Debian 12's, of clang 14.
# Later ones put the same code in other lines, and find other faults.
macro (skip_other_clang tool)
  execute_process(COMMAND "${tool}" --version OUTPUT_VARIABLE version COMMAND_ERROR_IS_FATAL ANY)
  if (NOT version MATCHES "version 14\\.")
    message(NOTICE "Skipped: this check needs clang 14, and ${tool} is another one:\n${version}")
    return()
  endif ()
endmacro ()
