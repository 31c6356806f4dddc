// Arbitrary text as the address of a bus: an accepted address is written in full and read back
// unchanged.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "canvoy/can/host/bus_address.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace canvoy::host;
  const Result<BusAddress> address = parse_bus_address({reinterpret_cast<const char*>(data), size});
  if (!address && address.error().what.empty()) std::abort();
  if (!address) return 0;
  const Result<BusAddress> again = parse_bus_address(to_string(*address));
  const bool same = again && again->kind == address->kind &&
                    again->interface == address->interface && again->udp == address->udp &&
                    again->tcp == address->tcp;
  if (!same) std::abort();
  return 0;
}
