#include "canvoy/devices/cia417/load/load_measuring_device.hpp"

#include "canvoy/devices/cia417/kit/kinds.hpp"

namespace canvoy::cia417 {

const DeviceKind load_kind = {
    .info = LoadKind<>::info, .profile = &profile, .forms = only_form<LoadKind<>>};

}  // namespace canvoy::cia417
