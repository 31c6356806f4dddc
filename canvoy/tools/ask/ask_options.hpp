// What all verbs that ask and tell have in common on the command line:
// `canvoy VERB BUS [NODE] [OBJECT] ...`.
//
//     Verb& command = app.add_verb("read", "Read objects of a node by SDO");
//     options->add_bus(command);
//     options->add_node(command);
//     options->add_time_out(command);
#pragma once

#include <string>

#include "canvoy/canopen/cob_id.hpp"
#include "canvoy/tools/ask/remote_argument.hpp"
#include "canvoy/tools/ask/sessions.hpp"
#include "canvoy/tools/commands.hpp"
#include "canvoy/tools/help/verb_help.hpp"

namespace canvoy::tools {

struct AskOptions {
  std::string bus = {};
  std::string node = {};
  std::string time_out = {};
  unsigned profile = 0;
  bool json = false;
  bool takes_remote = false;  ///< nodes of a network behind another, too
  RemoteOptions remote = {};

  void add_bus(Verb& command);
  void add_node(Verb& command, const char* text = nullptr);
  /// The same for who asks nodes of networks behind another as well, as 2:7.
  void add_any_node(Verb& command);
  void add_time_out(Verb& command);
  void add_profile(Verb& command);
  void add_json(Verb& command);

  /// Throw UsageError where what was said is none.
  NodeId node_id() const;
  Duration time_out_of(Duration usual) const;
  Session& open(Sessions& sessions) const;

 private:
  RemotePlace place() const;
};

}  // namespace canvoy::tools
