// RAM of a complete CiA 419 charger with one battery: all of it is in the device, including the
// values of its objects, except for the stack.
#include "canvoy/devices/cia419/charger_device.hpp"

namespace canvoy {

static_assert(sizeof(cia419::ChargerDevice<>) <= std::size_t{6} * 1024);
/// Not linked; the report reads its size.
extern const std::array<std::uint8_t, sizeof(cia419::ChargerDevice<>)> charger_memory;
const std::array<std::uint8_t, sizeof(cia419::ChargerDevice<>)> charger_memory{};

}  // namespace canvoy
