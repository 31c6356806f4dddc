// The help of a verb as a page for man, made from the same options.
//
//     man_page(app, read);  // canvoy-read(1)
#pragma once

#include <string>

#include "canvoy/tools/cli/verb.hpp"

namespace canvoy::tools {

/// In the language of man(7). `name` is how the verb is called: `canvoy run charger`.
std::string man_page(const Verb& verb, const std::string& name);

}  // namespace canvoy::tools
