# SPDX-FileCopyrightText: 2026 the sbox-merge authors
# SPDX-License-Identifier: BSD-3-Clause
#
# sbox_precompile(TARGET <HEADER>...): reads heavy headers once, not in each file; that is most of a
# build from scratch. With a compiler cache it would only be in the way, and clang-tidy cannot read
# what GCC precompiled: for that, CMAKE_DISABLE_PRECOMPILE_HEADERS.
function(sbox_precompile target)
  if(NOT CMAKE_CXX_COMPILER_LAUNCHER)
    target_precompile_headers(${target} PRIVATE ${ARGN})
  endif()
endfunction()
