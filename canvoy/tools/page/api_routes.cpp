#include "canvoy/tools/page/api_routes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "canvoy/tools/page/refusal.hpp"

namespace canvoy::tools {

namespace {

using Json = nlohmann::ordered_json;

/// Takes the text up to the next slash, or of `count` segments with the slashes between them, and
/// the slash behind it.
std::string_view take_segment(std::string_view& path, std::ptrdiff_t count = 1) {
  std::size_t end = std::min(path.find('/'), path.size());
  for (; count > 1; --count) end = std::min(path.find('/', end + 1), path.size());
  const std::string_view segment = path.substr(0, end);
  path.remove_prefix(std::min(end + 1, path.size()));
  return segment;
}

constexpr std::string_view bus_name = "{bus}";

/// Values for the names in `pattern`; nothing if `path` does not match. The name of a bus may have
/// slashes: `tcp:127.0.0.1:29536/can0`.
std::optional<std::vector<std::pair<std::string_view, std::string_view>>> matched(
    std::string_view pattern, std::string_view path) {
  const auto in_bus = std::ranges::count(path, '/') - std::ranges::count(pattern, '/');
  if (in_bus < 0 || (in_bus > 0 && pattern.find(bus_name) == std::string_view::npos)) {
    return std::nullopt;
  }
  std::vector<std::pair<std::string_view, std::string_view>> values;
  while (!pattern.empty()) {
    const std::string_view wanted = take_segment(pattern);
    const std::string_view given = take_segment(path, wanted == bus_name ? in_bus + 1 : 1);
    if (!wanted.starts_with('{')) {
      if (wanted != given) return std::nullopt;
      continue;
    }
    if (given.empty()) return std::nullopt;
    values.emplace_back(wanted.substr(1, wanted.size() - 2), given);
  }
  return values;
}

const ApiMember* find_member(const ApiRoute& route, std::string_view name) {
  const auto found = std::ranges::find(route.members, name, &ApiMember::name);
  return found == route.members.end() ? nullptr : &*found;
}

/// A non-negative integer in the notation of JSON.
std::optional<std::uint64_t> whole_number(std::string_view text) {
  std::uint64_t number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  const bool is_plain = text.size() == 1 || !text.starts_with('0');
  if (error != std::errc{} || stop != end || !is_plain) return std::nullopt;
  return number;
}

/// The value of a text in the path or the query; unchanged if it is not of its kind.
Json json_of(const ApiMember& member, std::string_view text) {
  if (member.kind == ApiKind::integer) {
    if (const auto number = whole_number(text)) return *number;
  }
  return text;
}

std::string wanted_of(const ApiMember& member) {
  switch (member.kind) {
    case ApiKind::number:
      return fmt::format("a number from {} to {}", member.least, member.most);
    case ApiKind::integer:
      return fmt::format("a whole number from {:.0f} to {:.0f}", member.least, member.most);
    case ApiKind::truth:
      return "true or false";
    case ApiKind::texts:
      return fmt::format("a list of at most {} texts", member.most);
    case ApiKind::text:
      break;
  }
  return member.choices.empty() ? "a text"
                                : fmt::format("one of {}", fmt::join(member.choices, ", "));
}

/// As a double, a number above 2^53 may become its neighbour.
bool is_in_range(const ApiMember& member, const Json& value) {
  if (value.is_number_unsigned()) {
    const auto number = value.get<std::uint64_t>();
    return number <= static_cast<std::uint64_t>(member.most) &&
           static_cast<double>(number) >= member.least;
  }
  const double number = value.get<double>();
  return number >= member.least && number <= member.most;
}

bool is_as_described(const ApiMember& member, const Json& value) {
  const auto is_text = [](const Json& each) { return each.is_string(); };
  switch (member.kind) {
    case ApiKind::number:
      return value.is_number() && is_in_range(member, value);
    case ApiKind::integer:
      return value.is_number() && is_in_range(member, value) &&
             value.get<double>() == std::floor(value.get<double>());
    case ApiKind::truth:
      return value.is_boolean();
    case ApiKind::texts:
      return value.is_array() && static_cast<double>(value.size()) <= member.most &&
             std::ranges::all_of(value, is_text);
    case ApiKind::text:
      break;
  }
  if (!value.is_string()) return false;
  const auto text = value.get<std::string_view>();
  return member.choices.empty() || std::ranges::find(member.choices, text) != member.choices.end();
}

void add_query(Json& arguments, const ApiRoute& route,
               std::span<const std::pair<std::string, std::string>> query) {
  for (const auto& [name, value] : query) {
    if (name == "token") continue;
    const ApiMember* const member = find_member(route, name);
    if (member == nullptr || member->place != ApiPlace::query) {
      throw NotAsDescribed(fmt::format("{}: there is no such parameter", name));
    }
    if (arguments.contains(name)) throw NotAsDescribed(fmt::format("{}: give it once", name));
    arguments[name] = json_of(*member, value);
  }
}

void add_body(Json& arguments, const ApiRoute& route, std::string_view text) {
  const Json body = Json::parse(text, nullptr, false);
  if (!body.is_object()) throw NotAsDescribed("the body is no JSON object");
  for (const auto& [name, value] : body.items()) {
    const ApiMember* const member = find_member(route, name);
    if (member == nullptr || member->place != ApiPlace::body) {
      throw NotAsDescribed(fmt::format("{}: there is no such member", name));
    }
    arguments[name] = value;
  }
}

}  // namespace

ApiMatch find_route(std::string_view method, std::string_view path) {
  for (const ApiRoute& route : api_routes()) {
    if (route.method != method) continue;
    if (auto values = matched(route.path, path)) return {&route, *std::move(values)};
  }
  return {};
}

std::string methods_of(std::string_view path) {
  std::string all;
  for (const std::string_view method : {"GET", "POST"}) {
    if (find_route(method, path).route == nullptr) continue;
    all.append(all.empty() ? "" : ", ").append(method == "GET" ? "GET, HEAD" : method);
  }
  return all;
}

const ApiRoute* find_action(std::string_view name) {
  const auto routes = api_routes();
  const auto found = std::ranges::find_if(routes, [&](const ApiRoute& route) {
    return route.action == ApiAction::act && route.name == name;
  });
  return found == routes.end() ? nullptr : &*found;
}

Json arguments_of(const ApiMatch& match, std::span<const std::pair<std::string, std::string>> query,
                  std::string_view body) {
  const ApiRoute& route = *match.route;
  Json arguments = Json::object();
  for (const auto& [name, value] : match.values) {
    arguments[std::string(name)] = json_of(*find_member(route, name), value);
  }
  add_query(arguments, route, query);
  if (route.method == "POST") add_body(arguments, route, body);
  check_arguments(route, arguments);
  return arguments;
}

void check_arguments(const ApiRoute& route, const Json& arguments,
                     std::span<const std::string_view> envelope) {
  for (const auto& [name, value] : arguments.items()) {
    if (find_member(route, name) != nullptr) continue;
    if (std::ranges::find(envelope, name) != envelope.end()) continue;
    throw NotAsDescribed(fmt::format("{}: there is no such member", name));
  }
  for (const ApiMember& member : route.members) {
    const auto found = arguments.find(member.name);
    if (found == arguments.end() && !member.is_required) continue;
    if (found == arguments.end() || !is_as_described(member, *found)) {
      throw NotAsDescribed(fmt::format("{}: give {}", member.name, wanted_of(member)));
    }
  }
}

}  // namespace canvoy::tools
