// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// sbox-merge with the SLAM of MRPT, which sbox-merge hands robots' logs over to.
#include "sbox-merge/command.h"
#include "sbox-merge/run_slams.h"

int main(int argc, char** argv) { return sbox::app::command(argc, argv, sbox::app::runSlams); }
