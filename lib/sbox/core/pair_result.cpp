// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/core/pair_result.h"

namespace sbox {

const char* toString(Verdict verdict) {
  switch (verdict) {
    case Verdict::Accepted:
      return "accepted";
    case Verdict::Ambiguous:
      return "ambiguous";
    case Verdict::Rejected:
      break;
  }
  return "rejected";
}

}  // namespace sbox
