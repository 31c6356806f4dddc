// Access to the page: a token admits a request, and what a browser says of it with each request
// keeps out pages of others, since any page may send requests to a port of this machine.
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
  bool is_loopback = true;  ///< only this machine reaches it
  std::string host{};       ///< where it listens: `127.0.0.2`; one of its names
  std::string token{};      ///< has to be given, on loopback too: other users reach it
};

/// What a request says of where it comes from.
struct AccessClaims {
  std::string_view host = {};    ///< the header of this name
  std::string_view origin = {};  ///< of the page that asks; empty: no page does
  /// `Sec-Fetch-Site`: the relation of the page that asks to this one; empty: no browser asks
  std::string_view site = {};
  std::string_view token = {};  ///< of the target, a cookie or an authorization, whichever is there
};

/// Why it is refused, in one line; empty: it is not. On loopback the host has to be a name of this
/// machine or the address that is listened at, with the port: a foreign name that leads here (DNS
/// rebinding) is not. A page of another site is refused whatever else it knows (Fetch Metadata).
/// Names are the same in capital letters.
std::string_view refusal_of(const AccessRules& rules, const AccessClaims& claims);

/// The value of a cookie in the header of this name; empty: it is not there.
std::string_view cookie_of(std::string_view header, std::string_view name);

/// 128 bits that nobody can guess, as hexadecimal digits.
std::string make_token();

}  // namespace canvoy::web
