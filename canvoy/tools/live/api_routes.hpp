// What the page's API has: one table, of which requests are dispatched and checked, and
// /openapi.json is made. What it says of a member is what is accepted.
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

/// Where a member of a request stands.
enum class ApiPlace : std::uint8_t { path, query, body };

enum class ApiKind : std::uint8_t { number, integer, text, truth, texts };

struct ApiMember {
  std::string_view name;
  ApiPlace place = ApiPlace::body;
  ApiKind kind = ApiKind::text;
  std::string_view description{};
  double least = 0;  ///< of numbers
  double most = 0;   ///< of numbers; of texts, how many
  /// Of a text: what it may be; empty: any.
  std::span<const std::string_view> choices{};
  bool is_required = true;
  bool is_true = false;  ///< a truth that is not given
};

/// What is done by a request: all but `act` only looks.
enum class ApiDeed : std::uint8_t {
  act,  ///< LiveSource::act(), by the name of the route
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
  std::string_view name;    ///< the `do` of a WebSocket's message
  std::string_view summary;
  ApiDeed deed = ApiDeed::act;
  std::span<const ApiMember> members{};
  std::string_view answer{};                   ///< its schema, below `components` of /openapi.json
  std::string_view type = "application/json";  ///< of the answer; another one has no schema
  /// Statuses beside those that each request may be answered with.
  std::span<const unsigned> statuses{};
};

std::span<const ApiRoute> api_routes();

struct ApiMatch {
  const ApiRoute* route = nullptr;
  /// Of the path, by name.
  std::vector<std::pair<std::string_view, std::string_view>> values{};
};

/// `path` has to outlive the match. Null: there is no such route.
ApiMatch find_route(std::string_view method, std::string_view path);
/// What Allow has for a path (RFC 9110, 10.2.1): `GET, HEAD`; empty: there is nothing.
std::string methods_of(std::string_view path);
/// One that acts, by name; null: there is none.
const ApiRoute* find_deed(std::string_view name);

/// The members of a request by HTTP, from path, query and body. Throws NotAsDescribed.
nlohmann::ordered_json arguments_of(const ApiMatch& match,
                                    std::span<const std::pair<std::string, std::string>> query,
                                    std::string_view body);
/// Throws NotAsDescribed where a member is missing, is none of the route's, or is not as the table
/// says. `envelope`: members beside those of the route.
void check_arguments(const ApiRoute& route, const nlohmann::ordered_json& arguments,
                     std::span<const std::string_view> envelope = {});

}  // namespace canvoy::tools
