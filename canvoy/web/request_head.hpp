// What the head of a request has to hold before anything of it is believed (RFC 9112, RFC 6455).
//
//     const HeadCounts counts{.hosts = 2};
//     if (const std::string_view fault = fault_of(counts); !fault.empty()) return 400;
#pragma once

#include <cstddef>
#include <string_view>

namespace canvoy::web {

/// How often a field stands in the head: a second one would be read by one program and not by the
/// next.
struct HeadCounts {
  bool is_1_1 = true;  ///< HTTP/1.1, which demands a Host
  std::size_t hosts = 0;
  std::size_t origins = 0;
  std::size_t sites = 0;  ///< Sec-Fetch-Site
  std::size_t authorizations = 0;
};

/// Why the request is none, in one line (RFC 9112, 3.2: one Host); empty: nothing is wrong.
std::string_view fault_of(const HeadCounts& counts);

/// Whether it is 16 bytes in base64, as Sec-WebSocket-Key has to be (RFC 6455, 4.2.1).
bool is_socket_key(std::string_view text);

/// Whether Content-Type is application/json, with any parameters (RFC 9110, 8.3.1).
bool is_json(std::string_view type);

/// Whether Accept-Encoding has gzip, with any weight but 0 (RFC 9110, 12.5.3).
bool accepts_gzip(std::string_view accepted);

}  // namespace canvoy::web
