# Settings that every target of the project shares.
include(GNUInstallDirs)

option(PAL_BUILD_WORKCELL "Build the MuJoCo workcell and the skills that run in it" ${PROJECT_IS_TOP_LEVEL})
option(PAL_WORKSTATION "Build the page that the workcell serves (needs Node 18 and npm)" ON)
option(PAL_BUILD_TESTS "Build the tests" ${PROJECT_IS_TOP_LEVEL})
option(PAL_WARNINGS_AS_ERRORS "Treat compiler warnings as errors (set by the presets)" OFF)
option(PAL_PRECOMPILE "Read the standard library's headers once for all files; hides an #include that is missing" OFF)
option(PAL_FAST_LINK "Link with mold, where it is installed" OFF)
option(PAL_INSTALL "Make rules to install pal, and its packages" ${PROJECT_IS_TOP_LEVEL})
set(PAL_PROGRAM "" CACHE FILEPATH
  "A pal that runs on this machine: only the runtime is built then, as for a robot's controller (docs/reference/runtime.md)")
if(PAL_PROGRAM)
  foreach(part PAL_INSTALL PAL_BUILD_WORKCELL PAL_BUILD_TESTS)
    set(${part} OFF)
  endforeach()
endif()
option(PAL_FUZZ "Build the fuzz targets for libFuzzer (clang only; docs/internals/fuzzing.md)" OFF)
set(PAL_SANITIZE "" CACHE STRING "Sanitizers, as for -fsanitize= (set by the presets)")

if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 12)
  message(FATAL_ERROR "pal needs g++ 12 or newer (this is ${CMAKE_CXX_COMPILER_VERSION}): apt-get install g++-12")
endif()

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
if(PROJECT_IS_TOP_LEVEL)
  set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/bin")
endif()
if(PROJECT_IS_TOP_LEVEL AND NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release)
endif()

if(PAL_SANITIZE)
  add_compile_options(-fsanitize=${PAL_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${PAL_SANITIZE})
  if(PAL_SANITIZE STREQUAL "thread" AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    add_compile_options(-Wno-tsan)  # Boost.Asio has fences, which the sanitizer does not know
  endif()
endif()

if(PAL_FAST_LINK)
  find_program(PAL_MOLD mold)
  if(PAL_MOLD)
    add_link_options(-fuse-ld=mold)
  endif()
endif()

if(PAL_FUZZ)
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    message(FATAL_ERROR "PAL_FUZZ needs clang: -DCMAKE_CXX_COMPILER=clang++")
  endif()
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()

# pal_library(NAME [IN_PLUGINS] SOURCES … [USES …] [PRIVATE_USES …]): a library pal_NAME with alias pal::NAME.
# IN_PLUGINS: its code also goes into shared libraries, those of skills.
# Headers are included from the project's root: #include "pal/support/source.hpp". A library that other projects use has a
# folder include/pal/NAME: its headers are #include "pal/runtime/thread.hpp" everywhere, and its users find these alone.
function(pal_library name)
  cmake_parse_arguments(ARG "IN_PLUGINS" "" "SOURCES;USES;PRIVATE_USES" ${ARGN})
  add_library(pal_${name} STATIC ${ARG_SOURCES})
  if(ARG_IN_PLUGINS)
    pal_in_plugins(pal_${name})
  endif()
  add_library(pal::${name} ALIAS pal_${name})
  if(IS_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}/include")
    target_include_directories(pal_${name} PRIVATE ${PROJECT_SOURCE_DIR} PUBLIC
      $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
    if(PAL_INSTALL)
      install(DIRECTORY include/ DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" COMPONENT development)
    endif()
  else()
    target_include_directories(pal_${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
      $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/pal-workcell>)
  endif()
  target_compile_features(pal_${name} PUBLIC cxx_std_20)
  target_link_libraries(pal_${name} PUBLIC ${ARG_USES} PRIVATE ${ARG_PRIVATE_USES})
  set_target_properties(pal_${name} PROPERTIES EXPORT_NAME ${name})
  pal_warnings(pal_${name})
  pal_precompiled(pal_${name})
  pal_links_alone(${name})
endfunction()

# pal_links_alone(NAME): the build fails if the library uses one that it does not name. All of it is linked with what it names.
function(pal_links_alone name)
  if(PAL_BUILD_TESTS AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    add_executable(links_${name} "${PROJECT_SOURCE_DIR}/cmake/links_alone.cpp")
    target_link_libraries(links_${name} PRIVATE $<LINK_LIBRARY:WHOLE_ARCHIVE,pal_${name}>)
    set_target_properties(links_${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}" UNITY_BUILD OFF)
  endif()
endfunction()

# pal_warnings(TARGET): the project's warnings; code that a generator wrote by ANTLR is left out.
function(pal_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wconversion -Wshadow
    -Wnon-virtual-dtor -Wold-style-cast $<$<BOOL:${PAL_WARNINGS_AS_ERRORS}>:-Werror>)
  if(CMAKE_UNITY_BUILD)
    # Both are about names of other files, which the compiler sees as one with this.
    target_compile_options(${target} PRIVATE -Wno-shadow $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  endif()
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    # g++ 12 sees overlaps in std::string (GCC bug 105329) and unset values in std::optional (80635) where there are none.
    target_compile_options(${target} PRIVATE -Wno-restrict -Wno-maybe-uninitialized)
  endif()
  if(PAL_SANITIZE AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # With a sanitizer's calls in between, g++ sees accesses beyond vectors in the standard library where there are none.
    target_compile_options(${target} PRIVATE -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread)
  endif()
endfunction()

# pal_precompiled(TARGET [FOR_TESTS]): with PAL_PRECOMPILE its files are read with the standard library's headers as they
# were read before. All that share such headers have the same options. FOR_TESTS: Catch2 too, and without optimization.
function(pal_precompiled target)
  if(NOT PAL_PRECOMPILE)
    return()
  endif()
  set(headers pal_precompiled_headers)
  get_target_property(in_plugins ${target} POSITION_INDEPENDENT_CODE)
  if("FOR_TESTS" IN_LIST ARGN)
    set(headers pal_precompiled_headers_in_tests)
  elseif(in_plugins)
    set(headers pal_precompiled_headers_in_plugins)
  endif()
  if(NOT TARGET ${headers})
    add_library(${headers} OBJECT "${PROJECT_SOURCE_DIR}/cmake/precompiled.cpp")
    if("FOR_TESTS" IN_LIST ARGN)
      pal_without_optimization(${headers})
      pal_quick_checks(${headers})
      target_precompile_headers(${headers} PRIVATE <catch2/catch.hpp>)
    elseif(in_plugins)
      pal_in_plugins(${headers})
    endif()
    target_precompile_headers(${headers} PRIVATE <algorithm> <chrono> <cstdint> <functional> <iostream> <map>
      <memory> <optional> <set> <sstream> <string> <variant> <vector>)
    pal_warnings(${headers})
  endif()
  target_precompile_headers(${target} REUSE_FROM ${headers})
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # ccache cannot tell otherwise what a file depends on. The standard library's own warnings are not held back here.
    target_compile_options(${target} PRIVATE -fpch-preprocess
      -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread)
  endif()
endfunction()

# pal_without_optimization(TARGET): for code that runs for a moment only and would take longer to compile.
function(pal_without_optimization target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O0>)
endfunction()

# pal_quick_checks(TARGET): Catch2's checks compile in less time. One that throws ends its whole case, which fails.
function(pal_quick_checks target)
  target_compile_definitions(${target} PRIVATE CATCH_CONFIG_FAST_COMPILE)
endfunction()
