// Makes a man page from the help of a verb, with the same options.
//
//     man_page(app, read);  // canvoy-read(1)
#pragma once

#include <string>

#include "canvoy/tools/cli/verb.hpp"

namespace canvoy::tools {

/// Returns man(7) source. `name` is the full name of the verb: `canvoy run charger`.
std::string man_page(const Verb& verb, const std::string& name);

}  // namespace canvoy::tools
