// The API of the page in one table, which dispatches and checks requests, and from which
// /openapi.json is made. A member is accepted as the table describes it.
//
//     const ApiMatch match = find_route("POST", "/api/run/speed");
//     if (match.route == nullptr) return not_found();
//     const Json arguments = arguments_of(match, request.target.query, request.body);
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace canvoy::tools {

/// Position of a member in a request.
enum class ApiPlace : std::uint8_t { path, query, body };

enum class ApiKind : std::uint8_t { number, integer, text, truth, texts };

struct ApiMember {
  std::string_view name;
  ApiPlace place = ApiPlace::body;
  ApiKind kind = ApiKind::text;
  std::string_view description{};
  double least = 0;  ///< for numbers
  double most = 0;   ///< for numbers; for texts, their length
  /// Accepted values of a text; empty: any.
  std::span<const std::string_view> choices{};
  bool is_required = true;
  bool is_true = false;  ///< value of a boolean that is not given
};

/// Action of a request; all except `act` only read.
enum class ApiAction : std::uint8_t {
  act,  ///< LiveSource::act(), with the name of the route
  description,
  state,
  networks,
  nodes,
  values,
  events,
  frames,
  run_file,
};

struct ApiRoute {
  std::string_view method;  ///< `GET`, `POST`
  std::string_view path;    ///< `/api/networks/{bus}/nodes/{node}/nmt`
  std::string_view name;    ///< `do` of a WebSocket message
  std::string_view summary;
  ApiAction action = ApiAction::act;
  std::span<const ApiMember> members{};
  std::string_view answer{};                   ///< its schema, under `components` of /openapi.json
  std::string_view type = "application/json";  ///< of the answer; another type has no schema
  /// Statuses beside those of every request.
  std::span<const unsigned> statuses{};
};

std::span<const ApiRoute> api_routes();

struct ApiMatch {
  const ApiRoute* route = nullptr;
  /// Values of the path, by name.
  std::vector<std::pair<std::string_view, std::string_view>> values{};
};

/// Finds a route. `path` must outlive the match. Null: no such route.
ApiMatch find_route(std::string_view method, std::string_view path);
/// Value of Allow for a path: `GET, HEAD`; empty: no such path (RFC 9110, 10.2.1).
std::string methods_of(std::string_view path);
/// The acting route with this name; null: none.
const ApiRoute* find_action(std::string_view name);

/// The members of an HTTP request, from path, query and body. Throws NotAsDescribed.
nlohmann::ordered_json arguments_of(const ApiMatch& match,
                                    std::span<const std::pair<std::string, std::string>> query,
                                    std::string_view body);
/// Throws NotAsDescribed if a member is missing, does not belong to the route, or violates the
/// table. `envelope`: members beside those of the route.
void check_arguments(const ApiRoute& route, const nlohmann::ordered_json& arguments,
                     std::span<const std::string_view> envelope = {});

}  // namespace canvoy::tools
