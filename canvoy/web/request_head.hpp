// Checks of the head of a request before it is used (RFC 9112, RFC 6455).
//
//     const HeadCounts counts{.hosts = 2};
//     if (const std::string_view fault = fault_of(counts); !fault.empty()) return 400;
#pragma once

#include <cstddef>
#include <string_view>

namespace canvoy::web {

/// Number of occurrences of fields in the head: programs disagree on which of two they use.
struct HeadCounts {
  bool is_1_1 = true;  ///< HTTP/1.1, which requires Host
  std::size_t hosts = 0;
  std::size_t origins = 0;
  std::size_t sites = 0;  ///< Sec-Fetch-Site
  std::size_t authorizations = 0;
  std::size_t types = 0;        ///< Content-Type
  std::size_t socket_keys = 0;  ///< Sec-WebSocket-Key
  std::string_view coding{};    ///< Transfer-Encoding
};

/// Reason why the request is invalid, in one line; empty: valid (RFC 9112, 3.2: one Host; 6.3:
/// a body whose last coding is not chunked has no certain end; other codings are not undone).
std::string_view fault_of(const HeadCounts& counts);

/// True if the text is 16 bytes in base64, as required of Sec-WebSocket-Key (RFC 6455, 4.2.1).
bool is_socket_key(std::string_view text);

/// True if Content-Type is application/json, with any parameters (RFC 9110, 8.3.1).
bool is_json(std::string_view type);

/// True if Accept-Encoding has gzip, with a weight other than 0 (RFC 9110, 12.5.3).
bool accepts_gzip(std::string_view accepted);

}  // namespace canvoy::web
