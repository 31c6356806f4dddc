#include "canvoy/web/access.hpp"

#include <gtest/gtest.h>

namespace canvoy::web::access_test {
namespace {

const AccessRules loopback{.port = 8080, .token = "secret"};

bool passes(const AccessRules& rules, const AccessClaims& claims) {
  return refusal_of(rules, claims).empty();
}

/// Like passes(), but with the token, which no foreign page knows, so that the rest is tested.
bool passes_with_token(AccessRules rules, AccessClaims claims) {
  rules.token = "secret";
  claims.token = "secret";
  return passes(rules, claims);
}

TEST(Access, OnLoopbackTheHostIsANameOfThisMachineWithThePort) {
  for (const char* host : {"127.0.0.1:8080", "localhost:8080", "[::1]:8080"}) {
    EXPECT_TRUE(passes_with_token(loopback, {.host = host})) << host;
  }
  // A foreign name may resolve to 127.0.0.1: DNS rebinding.
  for (const char* host : {"evil.example:8080", "127.0.0.1", "127.0.0.1:8081", "",
                           "localhost:8080.evil.example", "evil.localhost:8080"}) {
    EXPECT_FALSE(passes_with_token(loopback, {.host = host})) << host;
  }
}

TEST(Access, OnLoopbackTheHostMayBeTheAddressThatIsListenedAt) {
  const AccessRules second{.port = 8080, .host = "127.0.0.2"};
  EXPECT_TRUE(
      passes_with_token(second, {.host = "127.0.0.2:8080", .origin = "http://127.0.0.2:8080"}));
  EXPECT_TRUE(passes_with_token(second, {.host = "localhost:8080"}));
  for (const char* host : {"127.0.0.2", "127.0.0.2:8081", "127.0.0.3:8080", "evil.example:8080",
                           "127.0.0.2.evil.example:8080", ":8080"}) {
    EXPECT_FALSE(passes_with_token(second, {.host = host})) << host;
  }
  EXPECT_FALSE(passes_with_token(loopback, {.host = "127.0.0.2:8080"}));
  EXPECT_FALSE(passes_with_token(loopback, {.host = ":8080"}));
}

// RFC 3986, 3.2.2
TEST(Access, CapitalLettersMakeNoOtherHost) {
  EXPECT_TRUE(
      passes_with_token(loopback, {.host = "LocalHost:8080", .origin = "http://localhost:8080"}));
  EXPECT_FALSE(
      passes_with_token(loopback, {.host = "LocalHost:8080", .origin = "HTTP://EVIL.EXAMPLE"}));
}

TEST(Access, AtPort80TheHostMayStandWithoutIt) {
  const AccessRules usual{.port = 80, .host = "127.0.0.2"};
  for (const char* host : {"localhost", "127.0.0.1:80", "127.0.0.2"}) {
    EXPECT_TRUE(passes_with_token(usual, {.host = host})) << host;
  }
  for (const char* host : {"evil.example", "", ":80"}) {
    EXPECT_FALSE(passes_with_token(usual, {.host = host})) << host;
  }
}

TEST(Access, APageOfAnotherOriginIsRefused) {
  EXPECT_TRUE(
      passes_with_token(loopback, {.host = "localhost:8080", .origin = "http://localhost:8080"}));
  for (const char* origin : {"http://evil.example", "https://localhost:8080", "null",
                             "http://localhost:8081", "http://127.0.0.1:8080"}) {
    EXPECT_FALSE(passes_with_token(loopback, {.host = "localhost:8080", .origin = origin}))
        << origin;
  }
}

TEST(Access, WhereOthersReachItATokenIsTold) {
  const AccessRules open{.port = 8080, .is_loopback = false, .token = "secret"};
  EXPECT_TRUE(passes(open, {.host = "10.0.0.7:8080", .token = "secret"}));
  for (const char* token : {"", "Secret", "secret ", "secre"}) {
    EXPECT_FALSE(passes(open, {.host = "10.0.0.7:8080", .token = token})) << token;
  }
  EXPECT_FALSE(passes(open, {.host = "a:1", .origin = "http://b:1", .token = "secret"}));
}

// Other users of this machine can reach its ports.
TEST(Access, OnLoopbackATokenIsTold) {
  EXPECT_TRUE(passes(loopback, {.host = "localhost:8080", .token = "secret"}));
  EXPECT_FALSE(passes(loopback, {.host = "localhost:8080"}));
  EXPECT_FALSE(passes(loopback, {.host = "localhost:8080", .token = "public"}));
}

// Values of Sec-Fetch-Site (Fetch Metadata Request Headers, 2.3). An image of a foreign page
// has no origin.
TEST(Access, APageOfAnotherSiteIsRefused) {
  for (const char* site : {"", "none", "same-origin"}) {
    EXPECT_TRUE(passes_with_token(loopback, {.host = "localhost:8080", .site = site})) << site;
  }
  for (const char* site : {"cross-site", "same-site", "Same-Origin", "other"}) {
    EXPECT_FALSE(passes_with_token(loopback, {.host = "localhost:8080", .site = site})) << site;
  }
}

TEST(Access, TokensAreNotTheSameTwice) {
  EXPECT_EQ(make_token().size(), 32U);
  EXPECT_NE(make_token(), make_token());
}

TEST(Access, CookiesAreFoundByTheirWholeName) {
  EXPECT_EQ(cookie_of("a=1; canvoy-80=x; b=2", "canvoy-80"), "x");
  EXPECT_EQ(cookie_of("xcanvoy-80=1;canvoy-8=2", "canvoy-80"), "");
  EXPECT_EQ(cookie_of("", "a"), "");
  EXPECT_EQ(cookie_of(";;a=", "a"), "");
}

}  // namespace
}  // namespace canvoy::web::access_test
