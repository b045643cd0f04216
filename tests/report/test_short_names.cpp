// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "catch.h"
#include "sbox/report/short_names.h"

using namespace sbox;
using Names = std::vector<std::string>;

TEST_CASE("short names are the stems of the paths") {
  CHECK(shortNames({"maps/r1.gridmap.gz", "../r2.yaml", "r3.v2.png"}) ==
        Names{"r1", "r2", "r3_v2"});
  CHECK(shortNames({"a/MAP.PNG", "b.ppm", "c.RAWLOG.gz", "d.txt"}) ==
        Names{"MAP", "b", "c", "d_txt"});
}

TEST_CASE("short names are safe in file names") {
  CHECK(shortNames({"a b/c d$.yaml", "..", "x/", "r\xc3\xa9\n.png"}) ==
        Names{"c_d_", "__", "map", "r___"});
  CHECK(shortNames({std::string(300, 'x') + ".gridmap"})[0].size() == 60);
}

TEST_CASE("names that collide take their folder, also where they differ in case only") {
  CHECK(shortNames({"a/r1/map.yaml", "./r2/map.png", "r3/MAP.yaml", "hall.yaml"}) ==
        Names{"r1_map", "r2_map", "r3_MAP", "hall"});
}

TEST_CASE("names that collide still are numbered") {
  CHECK(shortNames({"a/r/map.yaml", "b/r/map.yaml", "map.yaml", "../map.yaml"}) ==
        Names{"r_map", "r_map-2", "map", "map-2"});
  CHECK(distinctNames({"m", "m-2", "m", "m"}) == Names{"m", "m-2", "m-3", "m-4"});
}
