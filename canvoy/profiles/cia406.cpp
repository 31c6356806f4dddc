#include "canvoy/profiles/cia406.hpp"

#include "canvoy/profiles/model/consistency.hpp"

namespace canvoy {

static_assert(is_consistent<cia406::profile>());

}  // namespace canvoy
