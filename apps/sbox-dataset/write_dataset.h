// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "sbox-dataset/run.h"

namespace sbox::dataset {

/// Maps every run and writes into a folder, which is made if it is not there: NAME.gridmap.gz and
/// the picture NAME.png for each, and pairs.json with the truth of each two runs that saw a common
/// place; two of different places are a negative pair. Throws std::runtime_error naming the file or
/// folder that cannot be written.
void writeDataset(const std::string& folder, const std::vector<NamedRun>& runs,
                  const MappingOptions& mapping = {});

}  // namespace sbox::dataset
