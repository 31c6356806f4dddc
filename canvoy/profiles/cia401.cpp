#include "canvoy/profiles/cia401.hpp"

#include "canvoy/profiles/model/consistency.hpp"

namespace canvoy {

static_assert(is_consistent<cia401::profile>());

}  // namespace canvoy
