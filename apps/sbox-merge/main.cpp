// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// sbox-merge: joins the occupancy grid maps of several robots into one.
#include "sbox-merge/command.h"
#include "sbox-merge/hand_logs_over.h"

int main(int argc, char** argv) { return sbox::app::command(argc, argv, sbox::app::handLogsOver); }
