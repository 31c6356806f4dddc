#include "canvoy/profiles/cia302.hpp"

#include "canvoy/profiles/model/consistency.hpp"

namespace canvoy {

static_assert(is_consistent<cia302::profile>());

}  // namespace canvoy
