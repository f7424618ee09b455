# SPDX-License-Identifier: BSD-3-Clause

# Sets HASHEDOCTREE_HAVE_HELP: whether ParaView can make pages of help of what the proxies say of
# themselves, for the button "?" of their panels. For that it needs xmlpatterns and the compiler of
# help of its own Qt, which up to 5.12 is Qt 5. (Debian: qtxmlpatterns5-dev-tools, qttools5-dev)
set(HASHEDOCTREE_HAVE_HELP OFF)
if (ParaView_VERSION VERSION_LESS 5.13)
  find_package(Qt5Help QUIET)
  find_program(qt_xmlpatterns_executable NAMES xmlpatterns-qt5 xmlpatterns) # as ParaView does
  mark_as_advanced(Qt5Help_DIR qt_xmlpatterns_executable)
  if (Qt5Help_FOUND AND qt_xmlpatterns_executable)
    set(HASHEDOCTREE_HAVE_HELP ON)
  endif ()
endif ()
