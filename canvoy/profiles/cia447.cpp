#include "canvoy/profiles/cia447.hpp"

#include "canvoy/profiles/model/consistency.hpp"

namespace canvoy {

static_assert(is_consistent<cia447::profile>());

}  // namespace canvoy
