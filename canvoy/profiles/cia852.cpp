#include "canvoy/profiles/cia852.hpp"

#include "canvoy/profiles/model/consistency.hpp"

namespace canvoy {

static_assert(is_consistent<cia852::profile>());

}  // namespace canvoy
