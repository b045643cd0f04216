// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sbox/merge_result.h"

namespace sbox {

const char* toString(MergeStatus status) {
  switch (status) {
    case MergeStatus::Merged:
      return "merged";
    case MergeStatus::Partly:
      return "partly";
    case MergeStatus::Refused:
      break;
  }
  return "refused";
}

}  // namespace sbox
