// Results for CI servers: one test suite in the XML of JUnit.
//
//     junit_text({.name = "acceptance.canvoy", .cases = {{.name = "line 1: nmt 10 start"}}});
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "canvoy/can/time.hpp"

namespace canvoy::tools {

struct JunitCase {
  std::string name;
  Duration time{};
  std::string failure = {};  ///< empty: passed
  bool is_skipped = false;
};

struct JunitSuite {
  std::string name;
  std::vector<JunitCase> cases = {};

  std::size_t failed() const;
  std::size_t skipped() const;
  bool has_failed() const { return failed() != 0; }
};

std::string junit_text(const JunitSuite& suite);

}  // namespace canvoy::tools
