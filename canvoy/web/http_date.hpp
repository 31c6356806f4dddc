// The date header of HTTP, which gives caches the age of an answer.
//
//     response.set(http::field::date, http_date());  // Sun, 06 Nov 1994 08:49:37 GMT
#pragma once

#include <chrono>
#include <string>

namespace canvoy::web {

/// In English, for any locale (RFC 9110, 5.6.7).
std::string http_date(
    std::chrono::system_clock::time_point when = std::chrono::system_clock::now());

}  // namespace canvoy::web
