// Texts of the SDO abort codes, for people; linked only if used (CiA 301, 7.2.4.3.17).
//
//     client.upload(5, 0x1000, 0, memory, done);    // done: [](SdoClient::Outcome outcome)
//     abort_reason(outcome.abort());                // "SDO time-out"
#pragma once

#include <string_view>

#include "canvoy/canopen/protocol/abort_code.hpp"

namespace canvoy {

/// Text of an abort code; "unknown abort code" for a code outside CiA 301.
std::string_view abort_reason(AbortCode code);

}  // namespace canvoy
