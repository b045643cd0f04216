# SPDX-FileCopyrightText: 2026 the sbox-merge authors
# SPDX-License-Identifier: BSD-3-Clause
#
# The project's warnings in one interface target; -Werror behind SBOX_WERROR, which CI sets.
add_library(sbox_warnings INTERFACE)
target_compile_options(sbox_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                       $<$<BOOL:${SBOX_WERROR}>:-Werror>)
