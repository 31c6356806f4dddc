#include "canvoy/profiles/cia407.hpp"

#include "canvoy/profiles/model/consistency.hpp"

namespace canvoy {

static_assert(is_consistent<cia407::profile>());

}  // namespace canvoy
