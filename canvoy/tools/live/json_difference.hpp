// What is different between two JSON values, as a merge patch (RFC 7386): the second one is the
// first one merged with it. An object that has a null cannot be told so; it is told whole.
//
//     Json patch = json_difference(before, after);
//     before.merge_patch(patch);  // is after
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace canvoy::tools {

/// Of two objects; empty where they are the same. Nulls within are told as they are: who merges
/// loses the member, and asks for a member that is not there gets null.
nlohmann::ordered_json json_difference(const nlohmann::ordered_json& before,
                                       const nlohmann::ordered_json& after);

}  // namespace canvoy::tools
