// Nothing but the check: a description that cannot be true does not compile.
#include "canvoy/profiles/cia417.hpp"

#include "canvoy/profiles/consistency.hpp"

namespace canvoy {

static_assert(is_consistent<cia417::profile>());

}  // namespace canvoy
