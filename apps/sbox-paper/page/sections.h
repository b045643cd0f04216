// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
//
// What each experiment found, as a section of the page: our numbers beside the paper's, targets met
// and missed, failures with their pictures. `source` is the command that gives the numbers.
#pragma once

#include <string>
#include <vector>

#include "sbox-paper/experiments/matches.h"
#include "sbox-paper/experiments/offices.h"
#include "sbox-paper/experiments/places.h"
#include "sbox-paper/experiments/rooms.h"
#include "sbox-paper/experiments/success.h"
#include "sbox-paper/page/page.h"

namespace sbox::paper {

/// Figure 8.
void addCoincidenceSection(Page& page, const std::vector<RoomsPair>& pairs,
                           const std::string& source);
/// Table 2 and figure 11.
void addLengthSections(Page& page, const std::vector<RoomsPair>& pairs, const std::string& source);
/// Figure 13.
void addPlacesSection(Page& page, const std::vector<PlaceAnswer>& answers,
                      const std::string& source);
/// Figure 15; `data` says which maps the pairs are.
void addMatchesSection(Page& page, const std::vector<PairMatches>& pairs, const std::string& data,
                       const std::string& source);
/// Table 3; `data` says which maps the pairs are.
void addSuccessSection(Page& page, const SuccessTable& table, const std::string& data,
                       const std::string& source);
/// The random offices.
void addOfficesSection(Page& page, const OfficesResult& offices, const std::string& source);

}  // namespace sbox::paper
