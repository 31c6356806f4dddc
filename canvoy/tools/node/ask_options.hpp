// Common options of all verbs that send requests: `canvoy VERB BUS [NODE] [OBJECT] ...`.
//
//     Verb& command = app.add_verb("read", "Read objects of a node by SDO");
//     options->add_bus(command);
//     options->add_node(command);
//     options->add_time_out(command);
#pragma once

#include <memory>
#include <string>

#include "canvoy/canopen/protocol/cob_id.hpp"
#include "canvoy/decoder/sheet_profile.hpp"
#include "canvoy/tools/argument/answer_time.hpp"
#include "canvoy/tools/argument/object_argument.hpp"
#include "canvoy/tools/argument/remote_argument.hpp"
#include "canvoy/tools/cli/commands.hpp"
#include "canvoy/tools/cli/verb_help.hpp"
#include "canvoy/tools/session/sessions.hpp"

namespace canvoy::tools {

struct AskOptions {
  std::string bus = {};
  std::string node = {};
  std::string time_out = {};
  ProfileChoice profile = {};
  std::shared_ptr<const decoder::SheetProfile> sheet = {};  ///< of --eds, in `profile`
  bool json = false;
  bool takes_remote = false;  ///< also accepts nodes of a network behind another node
  RemoteOptions remote = {};

  void add_bus(Verb& command);
  void add_node(Verb& command, const char* text = nullptr);
  /// Adds a node that may be in a network behind another one, as 2:7.
  void add_any_node(Verb& command);
  void add_time_out(Verb& command);
  /// `--profile`, or `--eds`.
  void add_profile(Verb& command);
  void add_json(Verb& command);

  /// Throw UsageError if the argument is not valid.
  NodeId node_id() const;
  Duration time_out_of(Duration usual) const;
  AnswerTime answer_time() const { return parse_answer_time(time_out); }
  Session& open(Sessions& sessions) const;

 private:
  void describe(const ProfileChoice& chosen);
  RemotePlace place() const;
};

}  // namespace canvoy::tools
