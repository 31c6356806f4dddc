#include "canvoy/tools/run/car_text.hpp"

#include <fmt/format.h>

namespace canvoy::tools {

Told told(const WorldNames& names, const car::NetworkChanged& event) {
  using Kind = cia447::CarEvent::Kind;
  const NodeId node = event.event.node;
  const std::string device = names.device(0, node);
  const auto words = [&](std::string_view name, const std::string& text) {
    Told told{text, {{"event", name}}};
    if (node != 0) told.json["node"] = node;
    return told;
  };
  switch (event.event.kind) {
    case Kind::named:
      return words("named", fmt::format("gateway: {} has its node-ID", device));
    case Kind::refused:
      return words("refused", "gateway: there is no node-ID left");
    case Kind::started:
      return words("started", fmt::format("gateway: {} is started", device));
    case Kind::lost:
      return words("lost", fmt::format("gateway: {} is lost", device));
    case Kind::stranger:
      return words("stranger", fmt::format("gateway: {} is no device of CiA 447", device));
    case Kind::objection:
      return words("objection", fmt::format("gateway: {} objects to sleep", device));
    case Kind::asleep:
      return words("asleep", "the network sleeps");
    case Kind::awake:
      return words("awake", "the network is awake");
  }
  return words("network", "");
}

}  // namespace canvoy::tools
