#include "canvoy/devices/cia401/io_device.hpp"

#include "canvoy/devices/cia401/kinds.hpp"

namespace canvoy::cia401 {

const DeviceKind io_kind = {.info = IoKind<>::info,
                            .profile = &profile,
                            .forms = only_form<IoKind<>>,
                            .keeping_forms = form_with_storage<IoKind<>>};

}  // namespace canvoy::cia401
