# What our own programs (tests, examples, benchmarks) are built with; nothing of it reaches the users of the package.

# Few compilations at a time: each needs 1 to 2 GB.
set_property(GLOBAL APPEND PROPERTY JOB_POOLS geodesic_remeshing_compile=${GEODESIC_REMESHING_JOBS})
set(CMAKE_JOB_POOL_COMPILE geodesic_remeshing_compile)

# ccache, allowed to trust precompiled headers (without the sloppiness it would never hit).
find_program(GEODESIC_REMESHING_CCACHE ccache)
if(GEODESIC_REMESHING_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env
    CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime ${GEODESIC_REMESHING_CCACHE})
endif()

# CGAL comes in as an imported target, hence as a system folder: the warnings concern our code only.
add_library(geodesic_remeshing_developer INTERFACE)
target_link_libraries(geodesic_remeshing_developer INTERFACE Geodesic_remeshing::Geodesic_remeshing CGAL::Data)
if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
  target_compile_options(geodesic_remeshing_developer INTERFACE -Wall -Wextra -Wpedantic
    $<$<BOOL:${GEODESIC_REMESHING_WARNINGS_AS_ERRORS}>:-Werror>)
  if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    # a precompiled header without a time stamp is the same bytes each time, which ccache needs
    target_compile_options(geodesic_remeshing_developer INTERFACE "SHELL:-Xclang -fno-pch-timestamp")
  endif()
  if(GEODESIC_REMESHING_SANITIZE)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
      # g++ takes the checks that it inserts for uses of what is not initialized
      target_compile_options(geodesic_remeshing_developer INTERFACE -Wno-maybe-uninitialized)
    endif()
    target_compile_options(geodesic_remeshing_developer INTERFACE
      -fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
    if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
      # A trap where a check fails, in place of a call of UBSan with a message: less than half the time to run. With handle_sigill=1 in
      # ASAN_OPTIONS AddressSanitizer tells the line. The check of dynamic types knows no trap.
      target_compile_options(geodesic_remeshing_developer INTERFACE -fsanitize-trap=undefined -fno-sanitize-trap=vptr)
    endif()
    target_link_options(geodesic_remeshing_developer INTERFACE -fsanitize=address,undefined)
  endif()
endif()

# The stages, which most programs call in the same way: those that link this library do not compile them again. Several threads where
# TBB is, in all of these programs, since one that is compiled otherwise would have other stages.
find_package(TBB QUIET)
include(CGAL_TBB_support)
set(stages_folder ${CMAKE_CURRENT_SOURCE_DIR}/test/Geodesic_remeshing/compiled_stages)
add_library(geodesic_remeshing_compiled_stages OBJECT EXCLUDE_FROM_ALL ${stages_folder}/compiled_stages.cpp)
target_link_libraries(geodesic_remeshing_compiled_stages PUBLIC geodesic_remeshing_developer $<TARGET_NAME_IF_EXISTS:CGAL::TBB_support>)
target_include_directories(geodesic_remeshing_compiled_stages PUBLIC ${stages_folder})

# What else tests and examples have in common: the headers that all include, precompiled, and -O1. Optimising their own code would
# take longer than they run; the stages, where they spend their time, are compiled as the program is.
if(GEODESIC_REMESHING_BUILD_TESTS)
  find_package(GTest REQUIRED)
  set(geodesic_remeshing_quick "$<$<AND:$<CONFIG:Release>,$<CXX_COMPILER_ID:GNU,Clang>>:-O1>")
  add_library(geodesic_remeshing_precompiled OBJECT EXCLUDE_FROM_ALL ${stages_folder}/precompiled.cpp)
  target_link_libraries(geodesic_remeshing_precompiled PRIVATE geodesic_remeshing_compiled_stages GTest::gtest)
  target_compile_options(geodesic_remeshing_precompiled PRIVATE ${geodesic_remeshing_quick})
  target_precompile_headers(geodesic_remeshing_precompiled PRIVATE
    <CGAL/Exact_predicates_inexact_constructions_kernel.h> <CGAL/Surface_mesh.h> <gtest/gtest.h> <compiled_stages.h>)
endif()

# geodesic_remeshing_use_precompiled(target): a program with these headers and stages, optimised as the build is
function(geodesic_remeshing_use_precompiled target)
  target_link_libraries(${target} PRIVATE geodesic_remeshing_compiled_stages GTest::gtest) # as the header is compiled
  target_precompile_headers(${target} REUSE_FROM geodesic_remeshing_precompiled)
endfunction()

# geodesic_remeshing_compile_quickly(target): a test or an example
function(geodesic_remeshing_compile_quickly target)
  geodesic_remeshing_use_precompiled(${target})
  target_compile_options(${target} PRIVATE ${geodesic_remeshing_quick})
endfunction()
