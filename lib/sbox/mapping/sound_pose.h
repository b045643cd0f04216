// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/poses/CPose3D.h>

namespace sbox {

/// Whether the pose is one: finite, and its matrix a rotation, which MRPT reads from files entry by
/// entry without asking.
[[nodiscard]] bool isSound(const mrpt::poses::CPose3D& pose);

}  // namespace sbox
