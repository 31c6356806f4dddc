#include "canvoy/tools/page/json_difference.hpp"

#include <nlohmann/json.hpp>

namespace canvoy::tools {

nlohmann::ordered_json json_difference(const nlohmann::ordered_json& before,
                                       const nlohmann::ordered_json& after) {
  auto patch = nlohmann::ordered_json::object();
  for (const auto& [key, value] : before.items()) {
    if (!after.contains(key)) patch[key] = nullptr;
  }
  for (const auto& [key, value] : after.items()) {
    const auto old = before.find(key);
    if (old != before.end() && *old == value) continue;
    const bool are_objects = old != before.end() && old->is_object() && value.is_object();
    patch[key] = are_objects ? json_difference(*old, value) : value;
  }
  return patch;
}

}  // namespace canvoy::tools
