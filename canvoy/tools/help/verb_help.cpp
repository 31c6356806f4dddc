#include "canvoy/tools/help/verb_help.hpp"

#include <CLI/CLI.hpp>
#include <string>

namespace canvoy::tools {

void add_examples(CLI::App& command, std::string_view examples) {
  command.footer("Examples:\n" + std::string(examples));
}

}  // namespace canvoy::tools
