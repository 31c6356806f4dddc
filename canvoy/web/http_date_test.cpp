#include "canvoy/web/http_date.hpp"

#include <gtest/gtest.h>

namespace canvoy::web::http_date_test {
namespace {

// Example of RFC 9110, 5.6.7: 784111777 s after the start of 1970.
TEST(HttpDate, IsThatOfTheExample) {
  const std::chrono::system_clock::time_point when{std::chrono::seconds(784111777)};
  EXPECT_EQ(http_date(when), "Sun, 06 Nov 1994 08:49:37 GMT");
}

}  // namespace
}  // namespace canvoy::web::http_date_test
