#include "canvoy/profiles/cia419.hpp"

#include "canvoy/profiles/model/consistency.hpp"

namespace canvoy {

static_assert(is_consistent<cia419::profile>());

}  // namespace canvoy
