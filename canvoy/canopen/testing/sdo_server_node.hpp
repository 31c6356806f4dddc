// A node with an SDO server and domains, for tests of the server at the wire.
//
//     ask("40 00 10 00 00 00 00 00", "43 00 10 00 A2 01 02 00");
//
// For tests only.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "canvoy/canopen/sdo/sdo_server.hpp"
#include "canvoy/canopen/testing/sdo_objects.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy {

class SdoServerNode : public testing::Test {
 protected:
  using Bytes = std::vector<std::uint8_t>;

  SdoServerNode() { wire.boot(); }

  /// Sends a request and checks the answer; both are eight bytes.
  void ask(const std::string& request, const std::string& answer) {
    SCOPED_TRACE(request);
    wire.receive("605#" + request);
    wire.expect({"585#" + answer});
  }
  void ask_in_vain(const std::string& request) {
    SCOPED_TRACE(request);
    wire.receive("605#" + request);
    wire.expect({});
  }
  void expect_alive() { ask("40 00 10 00 00 00 00 00", "43 00 10 00 A2 01 02 00"); }
  Bytes value(std::uint16_t index, std::uint8_t sub = 0) { return value_of(wire.node, index, sub); }

  WireNode wire{sdo_objects(), 5};
  std::array<std::uint8_t, 5000> buffer{};
  SdoServer sut{wire.node, 0, buffer};
  MemoryDomain domain{wire.node, 0x2030};
  MemoryDomain readable{wire.node, 0x2031};
  MemoryDomain writable{wire.node, 0x2032};
};

}  // namespace canvoy
