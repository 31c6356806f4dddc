#include "canvoy/tools/page/api_description.hpp"

#include <array>
#include <nlohmann/json.hpp>
#include <string>

#include "canvoy/tools/page/api_routes.hpp"

namespace canvoy::tools {

namespace {

using Json = nlohmann::ordered_json;

struct Refusal {
  unsigned status;
  const char* name;  ///< under components/responses
  const char* description;
};

constexpr std::array refusals = {
    Refusal{400, "Wrong", "it is not as this description says"},
    Refusal{403, "Refused",
            "no token or a wrong one, another host, the page of another site, or what was not "
            "allowed when the server was started"},
    Refusal{404, "Nothing", "there is nothing of this name"},
    Refusal{409, "NotNow", "it cannot be done to what is looked at, or not now"},
    Refusal{413, "Large", "the body is longer than 64 KiB"},
    Refusal{414, "Long", "the target is longer than 4096 bytes"},
    Refusal{415, "Type", "the body is not said to be application/json"},
    Refusal{422, "Senseless", "it is as this description says, and its words make no sense"},
    Refusal{431, "Head", "the head is longer than 8 KiB"},
    Refusal{502, "Failed", "the node has refused or does not answer, or a file cannot be written"},
    Refusal{503, "Busy",
            "others have not taken their answers: ask again after Retry-After seconds"},
    Refusal{504, "Silence", "there was no answer for 30 s: time may stand still"},
};
constexpr std::array of_all = {400U, 403U, 414U, 431U, 503U};
constexpr std::array of_deeds = {409U, 413U, 415U};

Json response_json(unsigned status) {
  for (const Refusal& each : refusals) {
    if (each.status == status)
      return {{"$ref", std::string("#/components/responses/") + each.name}};
  }
  return {};
}

Json schema_json(const ApiMember& member) {
  Json json;
  switch (member.kind) {
    case ApiKind::number:
      json = {{"type", "number"}, {"minimum", member.least}, {"maximum", member.most}};
      break;
    case ApiKind::integer:
      json = {{"type", "integer"},
              {"minimum", static_cast<std::uint64_t>(member.least)},
              {"maximum", static_cast<std::uint64_t>(member.most)}};
      break;
    case ApiKind::truth:
      json = {{"type", "boolean"}, {"default", member.is_true}};
      break;
    case ApiKind::texts:
      json = {{"type", "array"},
              {"maxItems", static_cast<std::uint64_t>(member.most)},
              {"items", {{"type", "string"}}}};
      break;
    case ApiKind::text:
      json = {{"type", "string"}};
      if (member.place == ApiPlace::path) json["minLength"] = 1;
      if (!member.choices.empty()) json["enum"] = member.choices;
      break;
  }
  return json;
}

Json parameters_json(const ApiRoute& route) {
  Json all = Json::array();
  for (const ApiMember& member : route.members) {
    if (member.place == ApiPlace::body) continue;
    all.push_back({{"name", member.name},
                   {"in", member.place == ApiPlace::path ? "path" : "query"},
                   {"required", member.is_required},
                   {"description", member.description},
                   {"schema", schema_json(member)}});
  }
  return all;
}

Json body_json(const ApiRoute& route) {
  Json properties = Json::object();
  Json required = Json::array();
  for (const ApiMember& member : route.members) {
    if (member.place != ApiPlace::body) continue;
    Json& property = properties[std::string(member.name)] = schema_json(member);
    if (!member.description.empty()) property["description"] = member.description;
    if (member.is_required) required.push_back(member.name);
  }
  const Json schema = {{"type", "object"},
                       {"properties", properties},
                       {"required", required},
                       {"additionalProperties", false}};
  return {{"required", true}, {"content", {{"application/json", {{"schema", schema}}}}}};
}

Json responses_json(const ApiRoute& route) {
  const Json schema = route.answer.empty()
                          ? Json{{"type", "string"}}
                          : Json{{"$ref", "#/components/schemas/" + std::string(route.answer)}};
  Json all = {{"200",
               {{"description", "it is done, or is this"},
                {"content", {{std::string(route.type), {{"schema", schema}}}}}}}};
  const auto add = [&all](std::span<const unsigned> statuses) {
    for (const unsigned status : statuses) all[std::to_string(status)] = response_json(status);
  };
  add(of_all);
  if (route.method == "POST") add(of_deeds);
  add(route.statuses);
  return all;
}

Json paths_json() {
  Json paths = Json::object();
  for (const ApiRoute& route : api_routes()) {
    Json operation = {{"operationId", route.name},
                      {"summary", route.summary},
                      {"responses", responses_json(route)}};
    if (Json parameters = parameters_json(route); !parameters.empty()) {
      operation["parameters"] = std::move(parameters);
    }
    if (route.method == "POST") operation["requestBody"] = body_json(route);
    const char* const method = route.method == "POST" ? "post" : "get";
    paths[std::string(route.path)][method] = std::move(operation);
  }
  return paths;
}

Json components_json() {
  const Json error = {{"schema", {{"$ref", "#/components/schemas/Error"}}}};
  Json responses = Json::object();
  for (const Refusal& each : refusals) {
    responses[each.name] = {{"description", each.description},
                            {"content", {{"application/json", error}}}};
  }
  return {{"securitySchemes",
           {{"bearer",
             {{"type", "http"},
              {"scheme", "bearer"},
              {"description",
               "the token in the address that the command prints, or of $CANVOY_WEB_TOKEN"}}},
            {"token", {{"type", "apiKey"}, {"in", "query"}, {"name", "token"}}}}},
          {"responses", std::move(responses)},
          {"schemas", Json::parse(api_schemas)}};
}

}  // namespace

Json api_description() {
  return {{"openapi", "3.1.0"},
          {"info",
           {{"title", "Canvoy's live page"},
            {"version", "2.0.0"},
            {"license", {{"name", "Apache-2.0"}, {"identifier", "Apache-2.0"}}},
            {"description",
             "Networks, nodes, objects and what happens on them, after the idea of CiA 309-5: "
             "REST, and a WebSocket at /live. JSON is as docs/json.md has it for all commands; "
             "docs/web.md has the messages of the WebSocket. Keys of answers may be added."}}},
          {"servers", Json::array({{{"url", "/"}}})},
          {"security", Json::array({{{"bearer", Json::array()}}, {{"token", Json::array()}}})},
          {"paths", paths_json()},
          {"components", components_json()}};
}

}  // namespace canvoy::tools
