#include "canvoy/profiles/cia301.hpp"

#include "canvoy/profiles/model/consistency.hpp"

namespace canvoy {

static_assert(is_consistent<cia301::profile>());

}  // namespace canvoy
