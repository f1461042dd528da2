# The add-on's few build functions: a library per module, a tool, a test, the package.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
include(CheckCXXSourceCompiles)

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  message(STATUS "No CMAKE_BUILD_TYPE given: choosing Release")
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Debug, Release, RelWithDebInfo or MinSizeRel" FORCE)
endif()

set(PCL_ADDON_INCLUDE_DIR "${CMAKE_INSTALL_INCLUDEDIR}/${PROJECT_NAME}-${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}")

# Whether PCL was built with AVX, as its pcl_config.h tells from 1.15 on; packaged ones are not.
function(pcl_addon_pcl_has_avx result)
  set(${result} FALSE PARENT_SCOPE)
  foreach(folder IN LISTS PCL_INCLUDE_DIRS)
    if(EXISTS "${folder}/pcl/pcl_config.h")
      file(STRINGS "${folder}/pcl/pcl_config.h" aligned REGEX "define PCL_USES_EIGEN_HANDMADE_ALIGNED_MALLOC +1")
      if(aligned)
        set(${result} TRUE PARENT_SCOPE)
      endif()
    endif()
  endforeach()
endfunction()

# Stop if the compiler flags align Eigen's memory otherwise than PCL's do. To be called when PCL is found.
function(pcl_addon_refuse_other_alignment)
  if(PCL_INDOOR_ALLOW_NATIVE)
    return()
  endif()
  string(TOUPPER "${CMAKE_BUILD_TYPE}" type)
  set(flags "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${type}} ${CMAKE_C_FLAGS}")
  unset(PCL_INDOOR_FLAGS_WITHOUT_AVX CACHE)
  check_cxx_source_compiles("#ifdef __AVX__\n#error\n#endif\nint main() {}" PCL_INDOOR_FLAGS_WITHOUT_AVX)
  pcl_addon_pcl_has_avx(pcl_has_avx)
  if(pcl_has_avx)
    if(PCL_INDOOR_FLAGS_WITHOUT_AVX)
      message(FATAL_ERROR
        "The compiler flags do not turn on AVX, with which this PCL was built: Eigen's memory alignment would differ and "
        "corrupt memory. Add -mavx, or configure with -DPCL_INDOOR_ALLOW_NATIVE=ON.")
    endif()
    return()
  endif()
  set(problem "")
  if(flags MATCHES "-m(arch|cpu)=native|-mavx[^ ]*")
    set(problem "contain ${CMAKE_MATCH_0}")
  elseif(NOT PCL_INDOOR_FLAGS_WITHOUT_AVX) # -march=haswell and its like
    set(problem "turn on AVX")
  endif()
  if(problem)
    message(FATAL_ERROR
      "The compiler flags ${problem}: this changes Eigen's memory alignment against the packaged PCL and corrupts "
      "memory (double free in supervoxels and LCCP). Remove the flag, or build PCL itself with it and configure "
      "with -DPCL_INDOOR_ALLOW_NATIVE=ON.")
  endif()
endfunction()

# Build everything with the sanitizers of PCL_INDOOR_SANITIZE; a finding ends the program. Assertions are on.
function(pcl_addon_sanitize)
  if(NOT PCL_INDOOR_SANITIZE)
    return()
  endif()
  add_compile_options(-fsanitize=${PCL_INDOOR_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer -g1 -O1 -UNDEBUG)
  # Under ASan Eigen aligns memory by itself, but the packaged PCL, built without, frees it with free().
  add_compile_definitions(EIGEN_MALLOC_ALREADY_ALIGNED=1)
  add_link_options(-fsanitize=${PCL_INDOOR_SANITIZE})
endfunction()

# Compilers that give no warning: those of Debian 12 and 13. Others may have new ones, which should stop nobody.
set(pcl_addon_known_compilers "^GNU 1[24]\\.")

# Compile options shared by all targets.
function(pcl_addon_set_defaults target)
  target_compile_features(${target} PUBLIC cxx_std_17)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wno-unknown-pragmas)
  # Functions may be inlined within their library, as Clang does: nobody puts others in their place.
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fno-semantic-interposition>)
  set(strict ${PCL_INDOOR_WARNINGS_AS_ERRORS})
  if(strict STREQUAL "KNOWN")
    string(REGEX MATCH "${pcl_addon_known_compilers}" strict "${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}")
  endif()
  if(CMAKE_UNITY_BUILD) # a class of one source file may have members of types of its own
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  endif()
  if(strict)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(OpenMP_CXX_FOUND)
    target_link_libraries(${target} PRIVATE OpenMP::OpenMP_CXX)
  endif()
endfunction()

# With CMAKE_UNITY_BUILD=ON the sources of a folder are compiled as one, which takes a third of the time where nothing was
# built before. Names without linkage are distinct within a folder, therefore.
function(pcl_addon_group_by_folder target)
  foreach(source ${ARGN})
    get_filename_component(folder ${source} DIRECTORY)
    string(MAKE_C_IDENTIFIER "${folder}" group)
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${group})
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
endfunction()

# pkg-config: pcl_indoor_<module>.pc, which requires what the library's headers need
function(pcl_addon_describe_library module)
  list(TRANSFORM ARGN REPLACE "^${PROJECT_NAME}::" "${PROJECT_NAME}_" OUTPUT_VARIABLE required)
  list(JOIN required ", " required)
  file(RELATIVE_PATH to_prefix /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
  set(file ${CMAKE_CURRENT_BINARY_DIR}/${PROJECT_NAME}_${module}.pc)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/module.pc.in ${file} @ONLY)
  install(FILES ${file} DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT dev)
endfunction()

# In place of libraries in a list of what is linked their archives, see pcl_addon_add_library
function(pcl_addon_use_archives result)
  string(REGEX REPLACE "${PROJECT_NAME}::([a-z]+)" "${PROJECT_NAME}_\\1_archive" items "${ARGN}")
  string(REGEX REPLACE "${PROJECT_NAME}_([a-z]+)_internals" "${PROJECT_NAME}_\\1_archive_internals" items "${items}")
  set(${result} "${items}" PARENT_SCOPE)
endfunction()

# pcl_addon_add_library(module SOURCES ... PUBLIC_LINK ... PRIVATE_LINK ...): shared, or static with BUILD_SHARED_LIBS=OFF.
# A shared library shows what is marked with PCL_INDOOR_EXPORTS only. Tests and benchmarks call private functions, too: they
# link an archive of the same objects. What all modules share and nobody else sees is in common/src/internal.
function(pcl_addon_add_library module)
  cmake_parse_arguments(ARG "" "" "SOURCES;PUBLIC_LINK;PRIVATE_LINK" ${ARGN})
  set(target ${PROJECT_NAME}_${module})
  add_library(${target} ${ARG_SOURCES})
  add_library(${PROJECT_NAME}::${module} ALIAS ${target})
  pcl_addon_set_defaults(${target})
  pcl_addon_group_by_folder(${target} ${ARG_SOURCES})
  set_property(GLOBAL APPEND PROPERTY PCL_INDOOR_LIBRARIES ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${module} VERSION ${PROJECT_VERSION}
    SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR} INSTALL_RPATH "$ORIGIN"
    POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  target_include_directories(${target} PUBLIC
    $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include> $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/common/include>
    $<INSTALL_INTERFACE:${PCL_ADDON_INCLUDE_DIR}>
    PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR}/common/src)
  target_link_libraries(${target} PUBLIC ${ARG_PUBLIC_LINK} PRIVATE ${ARG_PRIVATE_LINK})
  if(BUILD_SHARED_LIBS)
    add_library(${target}_archive STATIC EXCLUDE_FROM_ALL $<TARGET_OBJECTS:${target}>)
    set_target_properties(${target}_archive PROPERTIES LINKER_LANGUAGE CXX)
    pcl_addon_set_defaults(${target}_archive)
    target_include_directories(${target}_archive PUBLIC $<TARGET_PROPERTY:${target},INTERFACE_INCLUDE_DIRECTORIES>)
    pcl_addon_use_archives(public_link ${ARG_PUBLIC_LINK})
    pcl_addon_use_archives(private_link ${ARG_PRIVATE_LINK})
    target_link_libraries(${target}_archive PUBLIC ${public_link} PRIVATE ${private_link})
  else()
    target_compile_definitions(${target} PUBLIC PCL_INDOOR_STATIC)
    add_library(${target}_archive ALIAS ${target})
  endif()
  install(TARGETS ${target} EXPORT ${PROJECT_NAME}Targets
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT runtime NAMELINK_COMPONENT dev
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT dev)
  if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/include)
    install(DIRECTORY include/ DESTINATION ${PCL_ADDON_INCLUDE_DIR} COMPONENT dev)
  endif()
  if(BUILD_SHARED_LIBS) # else programs link what the libraries are made of, which CMake alone knows
    pcl_addon_describe_library(${module} ${ARG_PUBLIC_LINK})
  endif()
endfunction()

# pcl_addon_add_internals(module items...): pcl_indoor_<module>_internals is what the project's own programs link that use the
# library beyond its installed headers; pcl_indoor_<module>_archive_internals the same of its archive
function(pcl_addon_add_internals module)
  set(target ${PROJECT_NAME}_${module})
  add_library(${target}_internals INTERFACE)
  target_include_directories(${target}_internals INTERFACE ${CMAKE_CURRENT_SOURCE_DIR}/src)
  target_link_libraries(${target}_internals INTERFACE ${PROJECT_NAME}::${module} ${ARGN})
  pcl_addon_use_archives(archives ${PROJECT_NAME}::${module} ${ARGN})
  add_library(${target}_archive_internals INTERFACE)
  target_include_directories(${target}_archive_internals INTERFACE ${CMAKE_CURRENT_SOURCE_DIR}/src)
  target_link_libraries(${target}_archive_internals INTERFACE ${archives})
endfunction()

# pcl_addon_add_tools(name ... LINK ...): name.cpp becomes pcl_name; the target pcl_indoor_programs stands for all of them
function(pcl_addon_add_tools)
  cmake_parse_arguments(ARG "" "" "LINK" ${ARGN})
  if(NOT TARGET pcl_indoor_programs)
    add_custom_target(pcl_indoor_programs)
  endif()
  foreach(name ${ARG_UNPARSED_ARGUMENTS})
    add_executable(pcl_${name} ${name}.cpp)
    pcl_addon_set_defaults(pcl_${name})
    target_link_libraries(pcl_${name} PRIVATE ${ARG_LINK})
    target_link_options(pcl_${name} PRIVATE LINKER:--as-needed)
    set_target_properties(pcl_${name} PROPERTIES INSTALL_RPATH "$ORIGIN/../${CMAKE_INSTALL_LIBDIR}")
    install(TARGETS pcl_${name} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT tools)
    add_dependencies(pcl_indoor_programs pcl_${name})
    set_property(GLOBAL APPEND PROPERTY PCL_INDOOR_TOOLS ${name})
  endforeach()
endfunction()

# pcl_addon_load_first(target libraries...): let a program load these libraries before all others. Each symbol is looked for
# in one library after the other, so those with many symbols should be the first: PCL's symbols are then found in two
# thirds of the time. The program should need the libraries anyway.
function(pcl_addon_load_first target)
  set(files)
  foreach(library ${ARGN})
    list(APPEND files $<TARGET_FILE:${library}>)
  endforeach()
  target_link_options(${target} PRIVATE LINKER:--push-state,--no-as-needed ${files} LINKER:--pop-state)
endfunction()

# A man page and a completion for bash of every tool, made of what it says with -h
function(pcl_addon_describe_tools)
  if(CMAKE_CROSSCOMPILING)
    message(STATUS "Cross-compiling: there are no man pages and completions, which the tools themselves would tell")
    return()
  endif()
  set(folder ${PROJECT_BINARY_DIR}/tools/documentation)
  set(script ${PROJECT_SOURCE_DIR}/tools/documentation/describe_tool.sh)
  file(MAKE_DIRECTORY ${folder}/man ${folder}/completions)
  get_property(names GLOBAL PROPERTY PCL_INDOOR_TOOLS)
  foreach(name ${names})
    set(man ${folder}/man/pcl_${name}.1)
    set(completion ${folder}/completions/pcl_${name})
    add_custom_command(OUTPUT ${man} ${completion}
      COMMAND ${script} $<TARGET_FILE:pcl_${name}> ${PROJECT_VERSION} ${man} ${completion}
      DEPENDS pcl_${name} ${script})
    list(APPEND mans ${man})
    list(APPEND completions ${completion})
  endforeach()
  add_custom_target(pcl_indoor_documentation ALL DEPENDS ${mans} ${completions})
  install(FILES ${mans} DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT tools)
  install(FILES ${completions} DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT tools)
endfunction()

# Compile options of all tests: they share a precompiled header, which takes the same options. Tests that are stepped
# through are not optimised.
function(pcl_addon_set_test_defaults target)
  pcl_addon_set_defaults(${target})
  target_compile_options(${target} PRIVATE -fPIC $<$<NOT:$<CONFIG:Debug>>:-O1>)
endfunction()

# pcl_addon_add_test_program(target folder LINK ... NAMES ...): test/folder/test_<name>.cpp become a program. The folder begins
# with the module, whose private headers the tests may include and whose private functions they may call: they link
# archives. Tests of programs link what programs link.
function(pcl_addon_add_test_program target folder)
  cmake_parse_arguments(ARG "" "" "LINK;NAMES" ${ARGN})
  string(REGEX MATCH "^[^/]+" module ${folder})
  if(NOT module MATCHES "^(tools|experiments|ros2)$")
    pcl_addon_use_archives(ARG_LINK ${ARG_LINK})
  endif()
  list(TRANSFORM ARG_NAMES REPLACE ".+" "${folder}/test_\\0.cpp" OUTPUT_VARIABLE sources)
  add_executable(${target} ${sources})
  pcl_addon_set_test_defaults(${target})
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/test ${PROJECT_SOURCE_DIR}/${module}/src)
  target_link_libraries(${target} PRIVATE GTest::gtest_main ${ARG_LINK})
  target_link_options(${target} PRIVATE LINKER:--as-needed)
  target_precompile_headers(${target} REUSE_FROM test_headers)
endfunction()

# pcl_addon_add_tests(folder LINK ... NAMES ...): test/folder/test_<name>.cpp become one program and one test of CTest, which
# have the name of the folder
function(pcl_addon_add_tests folder)
  string(REPLACE "/" "_" target test_${folder})
  string(REPLACE "/" "." test ${folder})
  pcl_addon_add_test_program(${target} ${folder} ${ARGN})
  add_test(NAME ${test} COMMAND ${target})
endfunction()

# pcl_addon_add_program_tests(folder LINK ... NAMES ...): each test/folder/test_<name>.cpp becomes a program and a test of
# CTest that runs the project's programs
function(pcl_addon_add_program_tests folder)
  cmake_parse_arguments(ARG "" "" "LINK;NAMES" ${ARGN})
  foreach(name ${ARG_NAMES})
    set(target test_${folder}_${name})
    pcl_addon_add_test_program(${target} ${folder} LINK ${ARG_LINK} NAMES ${name})
    target_compile_definitions(${target} PRIVATE PCL_INDOOR_TOOLS="$<TARGET_FILE_DIR:pcl_indoor_pipeline>"
      PCL_INDOOR_PLANS="${PROJECT_SOURCE_DIR}/simulation/plans")
    add_dependencies(${target} pcl_indoor_programs)
    add_test(NAME ${folder}.${name} COMMAND ${target})
  endforeach()
endfunction()

# Install the CMake package: find_package(pcl_indoor COMPONENTS segmentation ...)
function(pcl_addon_install_package)
  set(destination ${CMAKE_INSTALL_LIBDIR}/cmake/${PROJECT_NAME})
  install(EXPORT ${PROJECT_NAME}Targets NAMESPACE ${PROJECT_NAME}:: DESTINATION ${destination} COMPONENT dev)
  configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/${PROJECT_NAME}Config.cmake.in
    ${PROJECT_BINARY_DIR}/${PROJECT_NAME}Config.cmake INSTALL_DESTINATION ${destination})
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/${PROJECT_NAME}ConfigVersion.cmake COMPATIBILITY SameMinorVersion)
  install(FILES ${PROJECT_BINARY_DIR}/${PROJECT_NAME}Config.cmake ${PROJECT_BINARY_DIR}/${PROJECT_NAME}ConfigVersion.cmake
    DESTINATION ${destination} COMPONENT dev)
endfunction()
