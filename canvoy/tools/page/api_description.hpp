// The OpenAPI 3.1 description of the API of the page, made from the table that checks requests.
//
//     done({.body = api_description().dump()});
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string_view>

namespace canvoy::tools {

/// Content of `/openapi.json`.
nlohmann::ordered_json api_description();

/// JSON Schema (2020-12) of each answer, by name: a JSON object.
extern const std::string_view api_schemas;

}  // namespace canvoy::tools
