// What the help of all verbs has in common.
//
//     command.add_option("bus", options.bus, bus_text)->required();
//     add_examples(command, "  canvoy sync can0\n  canvoy sync can0 --every 20ms");
#pragma once

#include <string_view>

namespace CLI {  // NOLINT(readability-identifier-naming): the name that it has
class App;
}

namespace canvoy::tools {

/// What a bus may be.
inline constexpr const char* bus_text =
    "can0, udp:239.74.163.2:43113, or tcp:HOST:PORT/can0 of a socketcand";

/// Of each example a line, below the options. tests/cli/help_test.py runs them all.
void add_examples(CLI::App& command, std::string_view examples);

}  // namespace canvoy::tools
