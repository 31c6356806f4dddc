// Access to the page: a token authorizes a request, and the origin headers of browsers exclude
// pages of other sites, since any page may send requests to a port of this machine.
//
//     const AccessRules rules{.port = 8080, .token = make_token()};
//     if (const std::string_view refusal = refusal_of(rules, claims); !refusal.empty()) return 403;
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace canvoy::web {

struct AccessRules {
  std::uint16_t port = 0;
  bool is_loopback = true;  ///< reachable from this machine only
  std::string host{};       ///< address or name at which it listens: `127.0.0.2`
  std::string token{};      ///< required, also on loopback: other users of the machine reach it
};

/// Origin of a request, from its headers.
struct AccessClaims {
  std::string_view host = {};    ///< the Host header
  std::string_view origin = {};  ///< of the requesting page; empty: none
  /// `Sec-Fetch-Site`: relation of the requesting page to this one; empty: no browser.
  std::string_view site = {};
  std::string_view token = {};  ///< from the target, a cookie or an authorization, whichever exists
};

/// Reason for a refusal, in one line; empty: accepted. On loopback the host must be a name of this
/// machine or the listening address, with the port; a foreign name that resolves to it is refused
/// (DNS rebinding). A page of another site is always refused (Fetch Metadata). Names are compared
/// without case.
std::string_view refusal_of(const AccessRules& rules, const AccessClaims& claims);

/// The value of a cookie in the header; empty: missing.
std::string_view cookie_of(std::string_view header, std::string_view name);

/// 128 random bits as hexadecimal digits.
std::string make_token();

}  // namespace canvoy::web
