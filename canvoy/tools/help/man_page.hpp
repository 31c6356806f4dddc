// The help of a verb as a page for man, made from the same options.
//
//     man_page(app, *app.get_subcommand("read"));  // canvoy-read(1)
#pragma once

#include <string>

namespace CLI {  // NOLINT(readability-identifier-naming): the name that it has
class App;
}

namespace canvoy::tools {

/// In the language of man(7). `name` is how the verb is called: `canvoy run charger`.
std::string man_page(const CLI::App& verb, const std::string& name);

}  // namespace canvoy::tools
