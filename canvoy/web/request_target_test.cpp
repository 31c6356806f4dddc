#include "canvoy/web/request_target.hpp"

#include <gtest/gtest.h>

namespace canvoy::web::request_target_test {
namespace {

TEST(RequestTarget, IsAPathAndItsQuery) {
  const auto target =
      parse_target("/api/networks/sim0/nodes/5/objects?search=battery%20v&x=a+b&&y");
  ASSERT_TRUE(target);
  EXPECT_EQ(target->path, "/api/networks/sim0/nodes/5/objects");
  EXPECT_EQ(target->value("search"), "battery v");
  EXPECT_EQ(target->value("x"), "a b");
  EXPECT_EQ(target->value("y"), "");
  EXPECT_FALSE(target->value("z"));
}

// Two hexadecimal digits after each percent sign; + is a plus in a path (RFC 3986, 2.1).
TEST(RequestTarget, PercentSignsAreOfBytes) {
  EXPECT_EQ(parse_target("/a%2Fb+%e2%82%ac")->path, "/a/b+\xE2\x82\xAC");
  for (const char* text : {"/%", "/%4", "/%G1", "/?a=%", "/?%zz=1"}) {
    EXPECT_FALSE(parse_target(text)) << text;
  }
}

TEST(RequestTarget, NothingGoesUpOrIsHidden) {
  for (const char* text :
       {"", "*", "http://", "http:///a", "https://a/", "http://a?b", "http://a/../b", "/..",
        "/../etc", "/a/../b", "/%2e%2e/x", "/a b", "/a\x01", "/a%00b", "/\xC3\xA9"}) {
    EXPECT_FALSE(parse_target(text)) << text;
  }
  EXPECT_TRUE(parse_target("/..a/b..c"));
}

// A server accepts it, and its host takes precedence (RFC 9112, 3.2.2).
TEST(RequestTarget, MayBeInAbsoluteForm) {
  const auto target = parse_target("http://127.0.0.1:8080/api/nodes?x=1");
  ASSERT_TRUE(target);
  EXPECT_EQ(target->host, "127.0.0.1:8080");
  EXPECT_EQ(target->path, "/api/nodes");
  EXPECT_EQ(target->value("x"), "1");
  EXPECT_EQ(parse_target("http://a")->path, "/");
  EXPECT_EQ(parse_target("/http://a")->host, "");
}

TEST(RequestTarget, HasAnEnd) {
  EXPECT_TRUE(parse_target("/" + std::string(target_length_max - 1, 'a')));
  EXPECT_FALSE(parse_target("/" + std::string(target_length_max, 'a')));
}

}  // namespace
}  // namespace canvoy::web::request_target_test
