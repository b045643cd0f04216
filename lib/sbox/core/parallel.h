// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

namespace sbox {

/// How many threads that number stands for: itself, or for 0 one a core.
[[nodiscard]] int threadCount(int threads);

/// Calls task(0) .. task(count - 1) on up to `threads` threads (0: one a core), or on fewer where
/// the system starts no more. Each task writes its own result only, so the outcome does not depend
/// on timing. The exception of the task with the lowest index is thrown again once all have ended.
void parallelFor(int count, int threads, const std::function<void(int)>& task);

}  // namespace sbox
