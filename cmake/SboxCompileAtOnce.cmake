# SPDX-FileCopyrightText: 2026 the sbox-merge authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Most who build this build it once, which is fastest where each header and each template is compiled
# for many files together. Those who change it want one file at a time, and so do compiler caches,
# clang-tidy and clangd.
if(CMAKE_CXX_COMPILER_LAUNCHER)
  set(at_once OFF)
else()
  set(at_once ON)
endif()
option(SBOX_COMPILE_AT_ONCE
       "Compile many files as one, with precompiled headers: fast from scratch, slow after a change"
       ${at_once})

# sbox_precompile(TARGET <HEADER>...): reads heavy headers once, not in each file.
function(sbox_precompile target)
  if(SBOX_COMPILE_AT_ONCE)
    target_precompile_headers(${target} PRIVATE ${ARGN})
  endif()
endfunction()

# sbox_compile_in_parts(TARGET MOST): compiles so many parts of its sources, each as one, or fewer
# where the machine has few cores, which compile other targets at the same time. So no two sources
# may have a private name in common.
function(sbox_compile_in_parts target most)
  if(NOT SBOX_COMPILE_AT_ONCE)
    return()
  endif()
  cmake_host_system_information(RESULT cores QUERY NUMBER_OF_LOGICAL_CORES)
  math(EXPR parts "(${cores} + 1) / 2")
  if(parts GREATER most)
    set(parts ${most})
  endif()
  get_target_property(sources ${target} SOURCES)
  list(LENGTH sources count)
  math(EXPR part_size "(${count} + ${parts} - 1) / ${parts}")
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${part_size})
endfunction()
