// A device alone on a cable, for tests.
//
//     DeviceOnCable<CarDriveControllerDevice<>> sut(NodeId{1});
//     sut.start();
//     EXPECT_EQ(sut.ask("40 01 60 00 00 00 00 00"), "4F 01 60 00 01 00 00 00");
#pragma once

#include <cstdio>
#include <string>
#include <string_view>

#include "canvoy/canopen/testing/cable.hpp"

namespace canvoy::cia417 {

/// `device` is constructed with a port and these arguments.
template <class Device>
struct DeviceOnCable {
  template <class... Settings>
  explicit DeviceOnCable(const Settings&... settings) : device(cable.port(0), settings...) {
    cable.connect(0, device.node());
  }

  /// Runs up to NMT state operational, and discards the frames sent until then.
  void start() {
    cable.start_all();
    cable.send("000#01 00");
    cable.run_for(10ms);
    cable.clear();
  }
  /// Answer to an SDO request, without the CAN-ID; empty if there is none.
  std::string ask(std::string_view request) {
    char id[8];
    std::snprintf(id, sizeof id, "%03X#", 0x600U + device.node().id());
    cable.clear();
    cable.send(std::string(id) + std::string(request));
    const std::string answer = cable.last(0x580U + device.node().id());
    return answer.empty() ? answer : answer.substr(4);
  }

  Cable cable;
  Device device;
};

}  // namespace canvoy::cia417
