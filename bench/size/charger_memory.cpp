// What a whole CiA 419 charger with one battery takes of RAM: all of it is in the device, values of
// its objects included, but for the stack.
#include "canvoy/devices/cia419/charger_device.hpp"

namespace canvoy {

static_assert(sizeof(cia419::ChargerDevice<>) <= std::size_t{6} * 1024);
/// Not linked: the report looks at its size.
extern const std::array<std::uint8_t, sizeof(cia419::ChargerDevice<>)> charger_memory;
const std::array<std::uint8_t, sizeof(cia419::ChargerDevice<>)> charger_memory{};

}  // namespace canvoy
