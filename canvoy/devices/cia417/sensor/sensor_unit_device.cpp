#include "canvoy/devices/cia417/sensor/sensor_unit_device.hpp"

#include "canvoy/devices/cia417/kit/kinds.hpp"

namespace canvoy::cia417 {

const DeviceKind sensor_kind = {
    .info = SensorKind<8>::info, .profile = &profile, .forms = only_form<SensorKind<8>>};

}  // namespace canvoy::cia417
