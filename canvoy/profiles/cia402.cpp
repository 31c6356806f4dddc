#include "canvoy/profiles/cia402.hpp"

#include "canvoy/profiles/model/consistency.hpp"

namespace canvoy {

static_assert(is_consistent<cia402::profile>());

}  // namespace canvoy
