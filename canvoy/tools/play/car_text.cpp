#include "canvoy/tools/play/car_text.hpp"

#include <nlohmann/json.hpp>

#include "canvoy/tools/device/car/car_words.hpp"

namespace canvoy::tools {

Told told(const WorldNames& names, const car::NetworkChanged& event) {
  using Kind = cia447::CarEvent::Kind;
  const NodeId node = event.event.node;
  const std::string device = names.device(0, node);
  const auto words = [&](std::string_view name) {
    const bool is_of_all = event.event.kind == Kind::asleep || event.event.kind == Kind::awake;
    const std::string text = car_event_words(event.event.kind, device);
    Told told{is_of_all ? text : "gateway: " + text, {{"event", name}}};
    if (node != 0) told.json()["node"] = node;
    return told;
  };
  switch (event.event.kind) {
    case Kind::named:
      return words("named");
    case Kind::refused:
      return words("refused");
    case Kind::started:
      return words("started");
    case Kind::lost:
      return words("lost");
    case Kind::stranger:
      return words("stranger");
    case Kind::objection:
      return words("objection");
    case Kind::asleep:
      return words("asleep");
    case Kind::awake:
      return words("awake");
  }
  return words("network");
}

}  // namespace canvoy::tools
