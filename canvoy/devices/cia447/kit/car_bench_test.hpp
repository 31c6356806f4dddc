// A device of CiA 447 alone on a cable, for wire tests. Its node-ID is 5, so that node 2 sends
// requests on 254h and gets answers on 1D4h (facts 2.2).
#pragma once

#include <string>

#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/cia447/kit/car_device.hpp"

namespace canvoy::cia447 {

class CarBench {
 public:
  /// The units find what `prepare` offers at the environment.
  template <class Prepare>
  CarBench(std::span<const CarUnit* const> units, Prepare prepare) {
    prepare(environment);
    device_.emplace(units, cable.port(0), 5, environment);
    cable.connect(0, device_->node());
    cable.start_all();
    cable.send("000#01 05");
  }
  explicit CarBench(std::span<const CarUnit* const> units) : CarBench(units, [](Environment&) {}) {}

  CarDevice& device() { return *device_; }
  Node& node() { return device_->node(); }

  /// The answer to an SDO request on the default channel: the frame's data.
  std::string ask(const std::string& request) { return ask_on(0x605, 0x585, request); }
  /// The answer to an SDO request of a client on its mesh channel.
  std::string ask_as(unsigned client, const std::string& request) {
    return ask_on(sdo_request(client, 5), sdo_response(client, 5), request);
  }

  Cable cable;
  Environment environment;

 private:
  std::string ask_on(std::uint32_t request_id, std::uint32_t response_id,
                     const std::string& request) {
    char id[8];
    std::snprintf(id, sizeof id, "%03X", static_cast<unsigned>(request_id));
    cable.clear();
    cable.send(std::string(id) + "#" + request);
    const std::string answer = cable.last(response_id);
    return answer.substr(answer.find('#') + 1);
  }

  std::optional<CarDevice> device_;
};

}  // namespace canvoy::cia447
