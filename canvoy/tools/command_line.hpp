// What is said of a command line that is none.
//
//     fmt::print(stderr, "canvoy: {}\n", refusal(app, error));
#pragma once

#include <string>

namespace CLI {  // NOLINT(readability-identifier-naming): the name that it has
class App;
class ParseError;
}  // namespace CLI

namespace canvoy::tools {

/// What is wrong with a command line that could not be parsed, what may have been meant, and where
/// help is: one line.
std::string refusal(const CLI::App& app, const CLI::ParseError& error);

}  // namespace canvoy::tools
