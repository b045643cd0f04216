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
       "Compile folder by folder, with precompiled headers: fast from scratch, slow after a change"
       ${at_once})

# sbox_precompile(TARGET <HEADER>...): reads heavy headers once, not in each file.
function(sbox_precompile target)
  if(SBOX_COMPILE_AT_ONCE)
    target_precompile_headers(${target} PRIVATE ${ARGN})
  endif()
endfunction()

# sbox_compile_by_folder(TARGET): compiles the sources of each folder as one, so that no two in a
# folder may have a private name in common.
function(sbox_compile_by_folder target)
  if(NOT SBOX_COMPILE_AT_ONCE)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  get_target_property(sources ${target} SOURCES)
  foreach(source ${sources})
    get_filename_component(folder "${source}" DIRECTORY)
    string(MAKE_C_IDENTIFIER "folder${folder}" group)
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${group})
  endforeach()
endfunction()
