// The canvoy command.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <string>
#include <system_error>

#include "canvoy/formats/plain_text.hpp"
#include "canvoy/tools/ask/ask_verbs.hpp"
#include "canvoy/tools/ask/node_argument.hpp"
#include "canvoy/tools/command_line.hpp"
#include "canvoy/tools/commands.hpp"
#include "canvoy/tools/failure.hpp"
#include "canvoy/tools/look_commands.hpp"
#include "canvoy/tools/terminal_text.hpp"

namespace canvoy::tools {
namespace {

constexpr const char* output_lost = "the output could not be written: is there room on the disk?";

int refuse(const CLI::App& app, const CLI::ParseError& error) {
  fmt::print(stderr, "canvoy: {}\n", refusal(app, error));
  return exit_usage;
}

/// What was printed may still be on its way, to a disk that is full.
int finish_output(int status) {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return status;
  throw Failure(output_lost);
}

int run(int count, char** arguments) {
  CLI::App app("Canvoy: see, simulate, test and drive CANopen networks", "canvoy");
  app.set_version_flag("--version", "canvoy 0.1.0");
  app.require_subcommand(1);
  app.get_formatter()->column_width(34);
  app.fallthrough();
  app.add_option_function<std::string>(
      "--colour,--color", use_colour,
      "everywhere: auto (on a terminal, unless NO_COLOR is set), always or never");
  app.add_option_function<std::string>("--network", use_network_file,
                                       "everywhere: a file of the network, whose names of nodes "
                                       "are understood (default: $CANVOY_NETWORK)");
  Action action;
  Sessions sessions;
  add_run(app, action);
  add_device(app, action);
  add_monitor(app, action);
  add_decode(app, action);
  add_convert_log(app, action);
  add_ask_verbs(app, action, sessions);
  add_script(app, action, sessions);
  add_program(app, action);
  add_boot(app, action);
  add_gateway(app, action);
  add_lss(app, action);
  add_profile(app, action);
  add_eds(app, action);
  add_help_verbs(app, action);
  add_export_table(app, action);
  add_scan(app, action);
  add_clone(app, action);
  add_plot(app, action);
  add_browse(app, action);
  try {
    app.parse(count, arguments);
    return finish_output(action());
  } catch (const CLI::ParseError& error) {
    return error.get_exit_code() == 0 ? app.exit(error) : refuse(app, error);
  } catch (const Failure& failure) {
    // It may quote what stands in a file.
    fmt::print(stderr, "canvoy: {}\n", formats::plain_text(failure.what()));
    return failure.status();
  } catch (const std::system_error&) {
    // What {fmt} throws where it cannot print.
    fmt::print(stderr, "canvoy: {}\n", output_lost);
    return exit_failed;
  }
}

}  // namespace
}  // namespace canvoy::tools

int main(int count, char** arguments) {
  return canvoy::tools::run(count, arguments);
}
