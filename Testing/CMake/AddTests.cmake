# SPDX-License-Identifier: BSD-3-Clause
include(UnitOfTests)

# One line registers one test. A test whose host is not there (no VTK, no plugin) is still recorded
# as registered, because CheckRegistered.cmake compares the record with the files under Testing. With
# the thread sanitizer only the tests that start threads are built: it has nothing to say of others.

# hashedoctree_add_core_test(<name>): GoogleTest in Core/<name>.cxx, with no VTK linked.
function (hashedoctree_add_core_test name)
  _hashedoctree_record("Core/${name}.cxx")
  _hashedoctree_add_gtest("Core/${name}.cxx" core HashedOctree::Core)
endfunction ()

# hashedoctree_add_paper_test(<name>): GoogleTest in Core/<name>.cxx, of the paper's experiments. Not
# with a sanitizer: to compile them takes minutes, and what they measure has tests of its own.
function (hashedoctree_add_paper_test name)
  _hashedoctree_record("Core/${name}.cxx")
  if (NOT HASHEDOCTREE_SANITIZE)
    _hashedoctree_add_gtest("Core/${name}.cxx" paper PaperExperiments)
  endif ()
endfunction ()

# hashedoctree_add_benchmark_test(<folder> <program>): GoogleTest in <folder>/Test<program>.cxx, of a
# benchmark's program as a whole, which is built for it. Not with a sanitizer, as above.
function (hashedoctree_add_benchmark_test folder program)
  set(name "Test${program}")
  _hashedoctree_record("${folder}/${name}.cxx")
  if (HASHEDOCTREE_SANITIZE OR (folder STREQUAL "Cxx" AND NOT HASHEDOCTREE_HAVE_VTK))
    return ()
  endif ()
  _hashedoctree_add_gtest_program("${name}" "${folder}/${name}.cxx")
  add_dependencies("${name}" "${program}")
  _hashedoctree_run_gtest("${name}" benchmark "${name}")
  list(JOIN CMAKE_CROSSCOMPILING_EMULATOR " " emulator) # which ctest knows of, but not the test
  set_property(TEST "${name}" APPEND PROPERTY ENVIRONMENT "EMULATOR=${emulator}")
endfunction ()

# hashedoctree_add_vtk_test(<name>): GoogleTest in Cxx/<name>.cxx.
function (hashedoctree_add_vtk_test name)
  _hashedoctree_record("Cxx/${name}.cxx")
  if (NOT HASHEDOCTREE_HAVE_VTK)
    return ()
  endif ()
  _hashedoctree_add_gtest("Cxx/${name}.cxx" vtk
    HashedOctree::Filters HashedOctree::Core
    VTK::FiltersGeneral VTK::FiltersGeometry VTK::FiltersHyperTree VTK::FiltersPoints
    VTK::FiltersSources)
endfunction ()

# hashedoctree_add_python_test(<name> [DISPLAY | HELP | PLAIN | SERVER | RANKS <n>]): Python/<name>.py with the
# package hashedoctree on its path, and the plugin's file in $HASHEDOCTREE_PLUGIN, in
#   pvpython; with DISPLAY for tests that render
#   PLAIN      the Python that ParaView was built for
#   HELP       the same, with the plugin's pages of help, if there are any, in $HASHEDOCTREE_HELP
#   SERVER     pvpython as the client of a pvserver of two processes; the test is <name>OnServer
#   RANKS <n>  pvbatch in n processes
# The script is given -T <folder for its output> -V <its baseline image> -D <Data>, as
# paraview.smtesting reads them.
function (hashedoctree_add_python_test name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "DISPLAY;HELP;PLAIN;SERVER" "RANKS" "")
  _hashedoctree_record("Python/${name}.py")
  if (NOT HASHEDOCTREE_HAVE_PLUGIN OR NOT HASHEDOCTREE_HAVE_PYTHON)
    return ()
  endif ()
  if (arg_HELP AND NOT HASHEDOCTREE_HAVE_HELP)
    return ()
  endif ()
  set(script "${CMAKE_CURRENT_SOURCE_DIR}/Python/${name}.py")
  set(command "$<TARGET_FILE:ParaView::pvpython>" --dr)
  if (arg_DISPLAY)
    list(PREPEND command "${PROJECT_SOURCE_DIR}/Plugin/with_display.sh") # needs Debian's xvfb
  elseif (arg_PLAIN OR arg_HELP)
    set(command "${Python3_EXECUTABLE}")
  elseif (arg_SERVER)
    string(APPEND name "OnServer")
    list(PREPEND command "$<TARGET_FILE:ParaView::smTestDriver>"
      --server "$<TARGET_FILE:ParaView::pvserver>"
      --client "${CMAKE_CURRENT_SOURCE_DIR}/Python/client_of_localhost.sh")
  elseif (arg_RANKS)
    find_program(MPIEXEC mpiexec REQUIRED) # Debian: openmpi-bin
    set(command "${MPIEXEC}" -n "${arg_RANKS}" "$<TARGET_FILE:ParaView::pvbatch>" --dr --symmetric)
  endif ()
  set(folder "${CMAKE_CURRENT_BINARY_DIR}/Output/${name}")
  file(MAKE_DIRECTORY "${folder}")
  add_test(NAME "${name}" COMMAND ${command} "${script}"
    -T "${folder}" -V "${PROJECT_SOURCE_DIR}/Data/Baseline/${name}.png"
    -D "${PROJECT_SOURCE_DIR}/Data")
  set(environment
    "PYTHONPATH=${PROJECT_BINARY_DIR}/${HASHEDOCTREE_PYTHON_DIR}" "PYTHONDONTWRITEBYTECODE=1"
    "HASHEDOCTREE_PLUGIN=$<TARGET_FILE:HashedOctree>"
    "HASHEDOCTREE_HELP=${PROJECT_BINARY_DIR}/Plugin/paraview_help/HashedOctree.qch"
    # MPI as root, as in a container, and on fewer cores than processes.
    "OMPI_ALLOW_RUN_AS_ROOT=1" "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1"
    "OMPI_MCA_rmaps_base_oversubscribe=1" # as Open MPI 4 has it, and as 5
    "PRTE_MCA_rmaps_default_mapping_policy=:oversubscribe")
  set_tests_properties("${name}" PROPERTIES
    LABELS python ENVIRONMENT "${environment}" TIMEOUT 300)
  if (arg_SERVER OR arg_RANKS)
    set_tests_properties("${name}" PROPERTIES PROCESSORS 2)
  endif ()
endfunction ()

# hashedoctree_add_checks(): what is tested of the project as a whole.
function (hashedoctree_add_checks)
  get_property(registered GLOBAL PROPERTY HASHEDOCTREE_REGISTERED_TESTS)
  list(JOIN registered "\n" registered)
  file(WRITE "${CMAKE_CURRENT_BINARY_DIR}/Registered.txt" "${registered}\n")
  set(checks Registered Layers Format Headers Tidy)
  if (HASHEDOCTREE_HAVE_VTK)
    list(APPEND checks Subproject)
  endif ()
  foreach (check IN LISTS checks)
    add_test(NAME "Check${check}" COMMAND "${CMAKE_COMMAND}"
      "-DSOURCE_DIR=${PROJECT_SOURCE_DIR}" "-DBINARY_DIR=${PROJECT_BINARY_DIR}"
      "-DGENERATOR=${CMAKE_GENERATOR}" "-DCXX=${CMAKE_CXX_COMPILER}" "-DVTK_DIR=${VTK_DIR}"
      -P "${CMAKE_CURRENT_SOURCE_DIR}/CMake/Check${check}.cmake")
    set_tests_properties("Check${check}" PROPERTIES
      LABELS style SKIP_REGULAR_EXPRESSION "^Skipped: ")
  endforeach ()
  set_tests_properties(CheckTidy PROPERTIES PROCESSORS 2 TIMEOUT 1500)

  if (HASHEDOCTREE_HAVE_PLUGIN AND HASHEDOCTREE_HAVE_PYTHON)
    add_test(NAME CheckInstall COMMAND "${CMAKE_COMMAND}"
      "-DSOURCE_DIR=${PROJECT_SOURCE_DIR}" "-DBINARY_DIR=${PROJECT_BINARY_DIR}"
      "-DCONFIG=$<CONFIG>" "-DGENERATOR=${CMAKE_GENERATOR}"
      "-DPYTHON=${Python3_EXECUTABLE}" "-DPVPYTHON=$<TARGET_FILE:ParaView::pvpython>"
      "-DPYTHON_DIR=${HASHEDOCTREE_PYTHON_DIR}" "-DPLUGIN=$<TARGET_FILE_NAME:HashedOctree>"
      "-DNM=${CMAKE_NM}" "-DLIBRARY=${CMAKE_INSTALL_LIBDIR}/$<TARGET_FILE_NAME:HashedOctree::Filters>"
      -P "${CMAKE_CURRENT_SOURCE_DIR}/CMake/CheckInstall.cmake")
    set_tests_properties(CheckInstall PROPERTIES LABELS install TIMEOUT 600)
  endif ()
endfunction ()

function (_hashedoctree_record file)
  set_property(GLOBAL APPEND PROPERTY HASHEDOCTREE_REGISTERED_TESTS "${file}")
endfunction ()

# With the thread sanitizer, whether a test's source starts threads; else always.
function (_hashedoctree_is_wanted result file)
  set(threads yes)
  if (HASHEDOCTREE_SANITIZE STREQUAL "thread")
    file(STRINGS "${file}" threads REGEX
      "#include [\"<](CurveBuilders\\.h|Threads\\.h|vtkSMPTools\\.h|thread)[\">]")
  endif ()
  if (threads)
    set("${result}" yes PARENT_SCOPE)
  else ()
    set("${result}" no PARENT_SCOPE)
  endif ()
endfunction ()

# Adds the GoogleTests of one file to a group, whose programs hashedoctree_add_units() makes.
function (_hashedoctree_add_gtest file group)
  _hashedoctree_is_wanted(wanted "${file}")
  if (wanted)
    set_property(GLOBAL APPEND PROPERTY "HASHEDOCTREE_TESTS_OF_${group}" "${file}")
    set_property(GLOBAL PROPERTY "HASHEDOCTREE_LIBRARIES_OF_${group}" "${ARGN}")
  endif ()
endfunction ()

# hashedoctree_add_units(): the programs of all GoogleTests that were added, eight files to a program,
# which compile in half the time. Each file is still a test of its own.
function (hashedoctree_add_units)
  set(files_in_unit 8)
  foreach (group core paper vtk)
    get_property(files GLOBAL PROPERTY "HASHEDOCTREE_TESTS_OF_${group}")
    get_property(libraries GLOBAL PROPERTY "HASHEDOCTREE_LIBRARIES_OF_${group}")
    set(number 0)
    while (files)
      list(SUBLIST files 0 ${files_in_unit} of_unit)
      list(REMOVE_ITEM files ${of_unit})
      math(EXPR number "${number} + 1")
      _hashedoctree_add_unit("${group}_tests_${number}" "${group}" "${of_unit}" ${libraries})
    endwhile ()
  endforeach ()
endfunction ()

function (_hashedoctree_add_unit unit group files)
  list(TRANSFORM files PREPEND "${CMAKE_CURRENT_SOURCE_DIR}/")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${files}) # for new #includes
  make_unit_of_tests(source ${files})
  file(CONFIGURE OUTPUT "${unit}.cxx" CONTENT "${source}" @ONLY)
  _hashedoctree_add_gtest_program("${unit}" "${CMAKE_CURRENT_BINARY_DIR}/${unit}.cxx" ${ARGN})
  foreach (file IN LISTS files)
    get_filename_component(folder "${file}" DIRECTORY)
    target_include_directories("${unit}" PRIVATE "${folder}")
    get_filename_component(name "${file}" NAME_WE)
    # Suites have parameters behind their names, or before.
    file(STRINGS "${file}" suites REGEX "^(TYPED_)?TEST(_F|_P)?\\(")
    list(TRANSFORM suites REPLACE "^.*\\(([A-Za-z0-9]+).*" "\\1.*:\\1/*:*/\\1.*")
    list(REMOVE_DUPLICATES suites)
    list(JOIN suites ":" filter)
    _hashedoctree_run_gtest("${name}" "${group}" "${unit}" "--gtest_filter=${filter}")
  endforeach ()
endfunction ()

function (_hashedoctree_add_gtest_program program source)
  add_executable("${program}" "${source}")
  target_include_directories("${program}" PRIVATE
    "${CMAKE_CURRENT_SOURCE_DIR}/Support" "${CMAKE_CURRENT_SOURCE_DIR}/Benchmarks")
  target_link_libraries("${program}" PRIVATE ${ARGN} GTest::gtest_main)
  hashedoctree_own_code("${program}")
  # Tests compile in two thirds of the time of -O3; the libraries that they link are as they ship.
  target_compile_options("${program}" PRIVATE $<$<CONFIG:Release>:-O1>)
  file(STRINGS "${source}" scarce REGEX "#include \"ScarceMemory\\.h\"")
  if (scarce)
    target_link_options("${program}" PRIVATE -Wl,--wrap=malloc,--wrap=calloc,--wrap=aligned_alloc)
  endif ()
endfunction ()

function (_hashedoctree_run_gtest name label)
  add_test(NAME "${name}" COMMAND ${ARGN})
  # More memory than there is throws with a sanitizer, too, instead of ending the test.
  set_tests_properties("${name}" PROPERTIES LABELS "${label}" TIMEOUT 600
    FAIL_REGULAR_EXPRESSION "Running 0 tests" ENVIRONMENT
    "ASAN_OPTIONS=allocator_may_return_null=1;TSAN_OPTIONS=allocator_may_return_null=1")
endfunction ()
