// A call controller on a cable, with the test in place of the panels: records of 6010h in, records
// of 6011h out, without frames around them.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "canvoy/canopen/testing/cable.hpp"
#include "canvoy/devices/cia417/controller_device/call_controller_device.hpp"

namespace canvoy::cia417 {

using Texts = std::vector<std::string>;

/// A derived class connects a device.
class CallControllerCable : public testing::Test {
 protected:
  void start(Duration begins) {
    cable.start_all();
    cable.send("000#01 01");
    cable.run_for(begins);
    cable.clear();
  }
  /// Records sent to panels.
  Texts told() {
    cable.run_for(10ms);
    Texts records;
    for (const Cable::Heard& heard : cable.heard) {
      if (heard.frame.id == 0x400) records.push_back(wire_text(heard.frame).substr(4));
    }
    cable.clear();
    return records;
  }
  /// Panel 16 is in the car, 21 to 70 on the landings.
  Texts answer_to(const std::string& input, const std::string& panel = "495") {
    cable.send(panel + "#" + input);
    return told();
  }

  Cable cable;
};

}  // namespace canvoy::cia417
