// The difference between two JSON values as a merge patch: merging it into the first value gives
// the second (RFC 7386). An object with a null cannot be expressed that way; it is sent whole.
//
//     Json patch = json_difference(before, after);
//     before.merge_patch(patch);  // is after
#pragma once

#include <nlohmann/json_fwd.hpp>

namespace canvoy::tools {

/// The difference between two objects; empty if they are equal. Nulls inside are sent as they are:
/// merging removes the member, and a missing member reads as null.
nlohmann::ordered_json json_difference(const nlohmann::ordered_json& before,
                                       const nlohmann::ordered_json& after);

}  // namespace canvoy::tools
