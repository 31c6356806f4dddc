#include "canvoy/devices/cia418/battery_device.hpp"

#include "canvoy/devices/cia418/kinds.hpp"

namespace canvoy::cia418 {

const DeviceKind battery_kind = {.info = BatteryKind::info,
                                 .profile = &profile,
                                 .forms = only_form<BatteryKind>,
                                 .keeping_forms = form_with_storage<BatteryKind>};

}  // namespace canvoy::cia418
