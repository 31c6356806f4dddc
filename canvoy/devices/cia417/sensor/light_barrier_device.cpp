#include "canvoy/devices/cia417/sensor/light_barrier_device.hpp"

#include "canvoy/devices/cia417/kit/kinds.hpp"
#include "canvoy/devices/cia417/kit/lift_forms.hpp"

namespace canvoy::cia417 {

const DeviceKind light_barrier_kind = {.info = LightBarrierKind<>::info,
                                       .profile = &profile,
                                       .forms = forms_of_doors<LightBarrierKind>};

}  // namespace canvoy::cia417
