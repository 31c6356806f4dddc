// Only the check: an inconsistent description does not compile.
#include "canvoy/profiles/cia417.hpp"

#include "canvoy/profiles/model/consistency.hpp"

namespace canvoy {

static_assert(is_consistent<cia417::profile>());

}  // namespace canvoy
