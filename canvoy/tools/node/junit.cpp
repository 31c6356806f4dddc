#include "canvoy/tools/node/junit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <pugixml.hpp>
#include <sstream>

#include "canvoy/formats/plain_text.hpp"
#include "canvoy/sim/duration_text.hpp"

namespace canvoy::tools {

namespace {

std::string seconds_text(Duration time) {
  return fmt::format("{:.3f}", in_seconds(time));
}

void append_case(pugi::xml_node& suite, const JunitCase& test) {
  pugi::xml_node node = suite.append_child("testcase");
  node.append_attribute("name") = formats::plain_text(test.name).c_str();
  node.append_attribute("time") = seconds_text(test.time).c_str();
  if (test.is_skipped) node.append_child("skipped");
  if (test.failure.empty()) return;
  node.append_child("failure").append_attribute("message") =
      formats::plain_text(test.failure).c_str();
}

}  // namespace

std::size_t JunitSuite::failed() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(cases, [](const JunitCase& each) { return !each.failure.empty(); }));
}

std::size_t JunitSuite::skipped() const {
  return static_cast<std::size_t>(std::ranges::count_if(cases, &JunitCase::is_skipped));
}

std::string junit_text(const JunitSuite& suite) {
  pugi::xml_document document;
  pugi::xml_node root = document.append_child("testsuite");
  Duration time{};
  for (const JunitCase& each : suite.cases) time += each.time;
  root.append_attribute("name") = formats::plain_text(suite.name).c_str();
  root.append_attribute("tests") = static_cast<unsigned>(suite.cases.size());
  root.append_attribute("failures") = static_cast<unsigned>(suite.failed());
  root.append_attribute("skipped") = static_cast<unsigned>(suite.skipped());
  root.append_attribute("time") = seconds_text(time).c_str();
  for (const JunitCase& each : suite.cases) append_case(root, each);
  std::ostringstream text;
  document.save(text, "  ", pugi::format_default, pugi::encoding_utf8);
  return text.str();
}

}  // namespace canvoy::tools
