#include "canvoy/tools/page/api_routes.hpp"

#include <gtest/gtest.h>

#include <array>
#include <nlohmann/json.hpp>

#include "canvoy/tools/page/api_description.hpp"
#include "canvoy/tools/page/refusal.hpp"

namespace canvoy::tools::api_routes_test {
namespace {

using Json = nlohmann::ordered_json;
using Query = std::vector<std::pair<std::string, std::string>>;

Json arguments(std::string_view method, std::string_view path, const Query& query = {},
               std::string_view body = "") {
  const ApiMatch match = find_route(method, path);
  if (match.route == nullptr) return "no route";
  return arguments_of(match, query, body);
}

/// Reason of the refusal; empty: none.
std::string fault(std::string_view method, std::string_view path, const Query& query = {},
                  std::string_view body = "") {
  try {
    arguments(method, path, query, body);
  } catch (const NotAsDescribed& refusal) {
    return refusal.what();
  }
  return {};
}

TEST(ApiRoutes, APathGivesItsNamesTheirValues) {
  EXPECT_EQ(arguments("GET", "/api/networks/lift 1/nodes/0/objects", {{"search", "a&b"}}),
            Json::parse(R"({"bus":"lift 1","node":0,"search":"a&b"})"));
  EXPECT_EQ(arguments("POST", "/api/networks/can0/nodes/127/objects/1018:4/read", {}, "{}"),
            Json::parse(R"({"bus":"can0","node":127,"object":"1018:4"})"));
}

TEST(ApiRoutes, TheNameOfABusMayHaveSlashes) {
  EXPECT_EQ(
      arguments("POST", "/api/networks/tcp:[::1]:29536/can0/nodes/5/objects/1017/read", {}, "{}"),
      Json::parse(R"({"bus":"tcp:[::1]:29536/can0","node":5,"object":"1017"})"));
  EXPECT_EQ(arguments("GET", "/api/networks/a/nodes/1/objects/nodes/1/objects"),
            Json::parse(R"({"bus":"a/nodes/1/objects","node":1})"));
  EXPECT_EQ(arguments("GET", "/api/networks/a/nodes/1/more/objects"), "no route");
}

TEST(ApiRoutes, OnlyWholePathsAreRoutes) {
  for (const char* path :
       {"/", "/api/", "/api/stat", "/api/state/", "//api/state", "/api/run", "/api/run/pause/",
        "/api/networks//nodes/1/objects", "/api/run/seek/more"}) {
    EXPECT_EQ(methods_of(path), "") << path;
  }
}

// RFC 9110, 10.2.1
TEST(ApiRoutes, AllowHasWhatAPathTakes) {
  EXPECT_EQ(methods_of("/api"), "GET, HEAD");
  EXPECT_EQ(methods_of("/api/run/seek"), "POST");
  EXPECT_EQ(methods_of("/api/networks/a/nodes/1/objects/x"), "POST");
  EXPECT_EQ(find_route("GET", "/api/run/seek").route, nullptr);
}

TEST(ApiRoutes, NodesAreWholeNumbersInTheirRange) {
  for (const char* node :
       {"1.0", "-1", "+1", "01", "128", "1e1", "x", " 1", "99999999999999999999"}) {
    const std::string path = std::string("/api/networks/a/nodes/") + node + "/nmt";
    EXPECT_EQ(fault("POST", path, {}, R"({"command":"start"})"),
              "node: give a whole number from 0 to 127")
        << node;
  }
  EXPECT_EQ(fault("POST", "/api/networks/a/nodes/0/nmt", {}, R"({"command":"start"})"), "");
  EXPECT_EQ(fault("POST", "/api/networks/a/nodes/0/objects/1000/read", {}, "{}"),
            "node: give a whole number from 1 to 127");
}

TEST(ApiRoutes, ParametersOfTheQueryAreThoseOfTheTable) {
  EXPECT_EQ(fault("GET", "/api/events", {{"since", "12"}, {"token", "x"}}), "");
  EXPECT_NE(fault("GET", "/api/events", {{"since", "abc"}}), "");
  EXPECT_NE(fault("GET", "/api/events", {{"since", ""}}), "");
  EXPECT_EQ(fault("GET", "/api/events", {{"since", "9007199254740992"}}), "");
  EXPECT_NE(fault("GET", "/api/events", {{"since", "9007199254740993"}}), "");
  EXPECT_EQ(fault("GET", "/api/events", {{"since", "1"}, {"since", "2"}}), "since: give it once");
  EXPECT_EQ(fault("GET", "/api/state", {{"since", "1"}}), "since: there is no such parameter");
  // Members that belong into the path or the body.
  EXPECT_NE(fault("GET", "/api/networks/a/nodes/1/objects", {{"bus", "b"}}), "");
  EXPECT_NE(fault("POST", "/api/run/seek", {{"time", "1"}}, R"({"time":1})"), "");
}

TEST(ApiRoutes, BodiesAreAsTheTableSays) {
  struct Case {
    const char* what;
    const char* body;
    const char* fault;  ///< its start; empty: none
  };
  constexpr std::array cases = {
      Case{"speed", R"({"speed":0})", ""},
      Case{"speed", R"({"speed":1000000})", ""},
      Case{"speed", R"({"speed":-1})", "speed: give a number from 0 to 1000000"},
      Case{"speed", R"({"speed":1000000.5})", "speed:"},
      Case{"speed", R"({"speed":"1"})", "speed:"},
      Case{"speed", R"({"speed":null})", "speed:"},
      Case{"speed", R"({})", "speed:"},
      Case{"speed", R"({"speed":1,"sped":1})", "sped: there is no such member"},
      Case{"speed", R"([])", "the body"},
      Case{"speed", "", "the body"},
      Case{"speed", R"({"speed":1)", "the body"},
      Case{"seek", R"({"time":-0.5})", "time:"},
      Case{"seek", R"({"time":1e300})", "time:"},
      Case{"step", R"({"step_s":-1})", "step_s:"},
      Case{"pause", R"({})", ""},
      Case{"pause", R"({"paused":1})", "paused: give true or false"},
      Case{"visit", R"({"from":1,"to":254})", ""},
      Case{"visit", R"({"from":1,"to":2.5})", "to: give a whole number from 1 to 254"},
      Case{"visit", R"({"from":0,"to":2})", "from:"},
      Case{"restart", R"({"seed":7.0,"faults":[],"keep":true})", ""},
      Case{"restart", R"({"seed":0.5})", "seed:"},
      Case{"restart", R"({"seed":9007199254740992})", ""},  // 2^53: the last exact one of a double
      Case{"restart", R"({"seed":9007199254740993})", "seed:"},
      Case{"restart", R"({"faults":[1]})", "faults: give a list of at most 200 texts"},
      Case{"restart", R"({"faults":"x"})", "faults:"},
      Case{"fault", R"({"fault":"x","duration_s":1})", ""},
      Case{"fault", R"({"fault":"x"})", "duration_s:"},
  };
  for (const Case& each : cases) {
    const std::string path = std::string("/api/run/") + each.what;
    const std::string told = fault("POST", path, {}, each.body);
    EXPECT_TRUE(told.starts_with(each.fault) && told.empty() == (*each.fault == '\0'))
        << each.what << " " << each.body << ": " << told;
  }
  EXPECT_EQ(fault("POST", "/api/networks/a/nodes/1/nmt", {}, R"({"command":"halt"})"),
            "command: give one of start, stop, enter pre-operational, reset node, reset "
            "communication");
}

TEST(ApiRoutes, AMessageOfAWebSocketIsCheckedByTheSameTable) {
  const ApiRoute* const read = find_action("read");
  ASSERT_NE(read, nullptr);
  constexpr std::array<std::string_view, 2> envelope = {"id", "do"};
  const Json asked = Json::parse(R"({"id":1,"do":"read","bus":"a","node":5,"object":"1000"})");
  EXPECT_NO_THROW(check_arguments(*read, asked, envelope));
  EXPECT_THROW(check_arguments(*read, asked), NotAsDescribed);
  EXPECT_EQ(find_action("state"), nullptr) << "it only looks";
  EXPECT_EQ(find_action("no"), nullptr);
}

TEST(ApiRoutes, TheDescriptionHasEachRouteAndEachOfItsMembers) {
  const Json description = api_description();
  std::size_t operations = 0;
  for (const auto& [path, methods] : description["paths"].items()) operations += methods.size();
  EXPECT_EQ(operations, api_routes().size());
  for (const ApiRoute& route : api_routes()) {
    const Json& operation =
        description["paths"][std::string(route.path)][route.method == "GET" ? "get" : "post"];
    ASSERT_TRUE(operation.is_object()) << route.path;
    if (!route.answer.empty()) {
      EXPECT_TRUE(description["components"]["schemas"].contains(std::string(route.answer)));
    }
    for (const auto& [status, response] : operation["responses"].items()) {
      EXPECT_TRUE(response.is_object() && !response.empty()) << route.name << " " << status;
    }
  }
  const Json& speed = description["paths"]["/api/run/speed"]["post"]["requestBody"]["content"]
                                 ["application/json"]["schema"];
  EXPECT_EQ(speed, Json::parse(R"({"type":"object","properties":{"speed":{"type":"number",
      "minimum":0.0,"maximum":1000000.0,"description":"times"}},"required":["speed"],
      "additionalProperties":false})"));
}

}  // namespace
}  // namespace canvoy::tools::api_routes_test
