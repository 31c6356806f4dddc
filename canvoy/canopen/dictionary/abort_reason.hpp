// What the abort codes of SDO say, for people (CiA 301, 7.2.4.3.17). Linked where it is used.
//
//     client.upload(5, 0x1000, 0, memory, done);    // done: [](SdoClient::Outcome outcome)
//     abort_reason(outcome.abort());                // "SDO time-out"
#pragma once

#include <string_view>

#include "canvoy/canopen/dictionary/abort_code.hpp"

namespace canvoy {

/// "unknown abort code" where it is none of CiA 301.
std::string_view abort_reason(AbortCode code);

}  // namespace canvoy
