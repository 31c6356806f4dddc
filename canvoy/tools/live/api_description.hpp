// The description of the page's API: OpenAPI 3.1, made of the table that requests are checked by.
//
//     done({.body = api_description().dump()});
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string_view>

namespace canvoy::tools {

/// What `/openapi.json` says.
nlohmann::ordered_json api_description();

/// JSON Schema (2020-12) of each answer, by its name: a JSON object.
extern const std::string_view api_schemas;

}  // namespace canvoy::tools
