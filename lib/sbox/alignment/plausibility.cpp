// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/alignment/plausibility.h"

#include <cmath>

namespace sbox {

double plausibility(const Overlap& e) {
  if (e.known < 4) {
    return kImplausible;
  }
  const double n = e.known + 1;
  return 0.014 * e.agree - 0.07 * e.conflict + 0.773 * std::sqrt(e.free_free) -
         0.068 * std::log(n) + 23.4 * e.agree / n + 3.9 * e.conflict / n;
}

}  // namespace sbox
