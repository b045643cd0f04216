// SPDX-FileCopyrightText: 2026 the sbox-merge authors
// SPDX-License-Identifier: BSD-3-Clause
#include "catch.h"
#include "sbox/report/json_layout.h"

using namespace sbox;
using Json = nlohmann::ordered_json;

TEST_CASE("short JSON takes one line") {
  const Json json = Json::parse(R"({"b":[1,2.5,null],"a":{"x":true}})");
  CHECK(layOutJson(json) == "{\"b\": [1, 2.5, null], \"a\": {\"x\": true}}\n");
  CHECK(layOutJson(Json::object()) == "{}\n");
}

TEST_CASE("long JSON is broken where needed and means the same") {
  Json json;
  json["short"] = {1, 2, 3};
  for (int i = 0; i < 40; ++i) {
    json["long"].push_back({{"index", i}, {"name", "number " + std::to_string(i)}});
  }
  const std::string text = layOutJson(json);
  CHECK(Json::parse(text) == json);
  CHECK(text.find("\n  \"short\": [1, 2, 3],\n") != std::string::npos);
  CHECK(text.find("\n    {\"index\": 7, \"name\": \"number 7\"},\n") != std::string::npos);
}
