#include "canvoy/profiles/cia418.hpp"

#include "canvoy/profiles/model/consistency.hpp"

namespace canvoy {

static_assert(is_consistent<cia418::profile>());

}  // namespace canvoy
