// Every command byte in every state of server and client, and golden dialogues with each of their
// bits flipped: the answer is right, an abort, or absent, and the node works afterwards.
#include <gtest/gtest.h>

#include "canvoy/canopen/sdo/sdo_client.hpp"
#include "canvoy/canopen/sdo/sdo_server.hpp"
#include "canvoy/canopen/testing/sdo_objects.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy::sdo_state_test {
namespace {

using Bytes = std::vector<std::uint8_t>;
using Frames = std::vector<std::string>;

std::string hex(unsigned byte) {
  char text[8];
  std::snprintf(text, sizeof text, "%02X", byte);
  return text;
}

/// Node 5 with a server, with the minimum for a test of one request.
struct Server {
  Server() {
    wire.boot();
    set_value(wire.node, 0x2021, pattern(30));
  }
  void receive(const Frames& requests) {
    for (const std::string& request : requests) wire.receive("605#" + request);
  }
  void expect_alive() {
    wire.sent.clear();
    receive({"40 00 10 00 00 00 00 00"});
    wire.expect({"585#43 00 10 00 A2 01 02 00"});
    receive({"21 08 20 00 08 00 00 00", "00 01 02 03 04 05 06 07", "1D 08 00 00 00 00 00 00"});
    wire.expect({"585#60 08 20 00 00 00 00 00", "585#20 00 00 00 00 00 00 00",
                 "585#30 00 00 00 00 00 00 00"});
    wire.run_for(10s);
    wire.expect({});
  }

  WireNode wire{sdo_objects(), 5};
  std::array<std::uint8_t, 64> buffer{};
  SdoServer server{wire.node, 0, buffer};
};

struct ServerState {
  const char* name;
  Frames requests;  ///< requests that lead to this state
  /// Required toggle bit of the next segment of a download; -1: none is expected.
  int download_toggle;
  int upload_toggle;        ///< like download_toggle, but for an upload
  const char* multiplexer;  ///< in an abort
};

const std::vector<ServerState> server_states = {
    {"idle", {}, -1, -1, "00 00 00"},
    {"download", {"20 21 20 00 00 00 00 00"}, 0x00, -1, "21 20 00"},
    {"download, second segment",
     {"20 21 20 00 00 00 00 00", "00 01 02 03 04 05 06 07"},
     0x10,
     -1,
     "21 20 00"},
    {"upload", {"40 21 20 00 00 00 00 00"}, -1, 0x00, "21 20 00"},
    {"upload, second segment",
     {"40 21 20 00 00 00 00 00", "60 00 00 00 00 00 00 00"},
     -1,
     0x10,
     "21 20 00"},
};

/// Answer of the server by CiA 301 to a request with `command` and the multiplexer 2002h:00h; a
/// segment's data is then 02 20 00 34 12 00 00.
Frames expected_of_server(const ServerState& state, unsigned command) {
  const std::string aborted = "585#80 " + std::string(state.multiplexer);
  const std::string specifier = " 01 00 04 05";
  const int toggle = static_cast<int>(command & 0x10U);
  switch (command >> 5) {
    case 0:
      if (state.download_toggle < 0) return {aborted + specifier};
      if (state.download_toggle != toggle) return {aborted + " 00 00 03 05"};
      return {"585#" + hex(0x20U | static_cast<unsigned>(toggle)) + " 00 00 00 00 00 00 00"};
    case 1: {
      const bool expedited = (command & 2U) != 0;
      const bool sized = (command & 1U) != 0;
      const unsigned size = 4 - (command >> 2 & 3U);
      if (!expedited && sized) return {"585#80 02 20 00 12 00 07 06"};  // 1234h bytes
      if (expedited && sized && size > 2) return {"585#80 02 20 00 12 00 07 06"};
      if (expedited && sized && size < 2) return {"585#80 02 20 00 13 00 07 06"};
      return {"585#60 02 20 00 00 00 00 00"};
    }
    case 2:
      return {"585#4B 02 20 00 00 00 00 00"};
    case 3:
      if (state.upload_toggle < 0) return {aborted + specifier};
      if (state.upload_toggle != toggle) return {aborted + " 00 00 03 05"};
      return {toggle == 0 ? "585#00 01 20 3F 5E 7D 9C BB" : "585#10 DB FA 19 38 57 76 95"};
    case 4:
      return {};
    case 5:
      return {((command & 3U) == 0 ? "585#80 02 20 00" : aborted) + specifier};
    case 6:
      return {((command & 1U) == 0 ? "585#80 02 20 00" : aborted) + specifier};
    default:
      return {aborted + specifier};
  }
}

TEST(SdoServerStates, EveryCommandByteInEveryStateGetsTheAnswerOfCiA301) {
  for (const ServerState& state : server_states) {
    for (unsigned command = 0; command < 256; ++command) {
      SCOPED_TRACE(std::string(state.name) + ", command " + hex(command));
      Server sut;
      sut.receive(state.requests);
      sut.wire.sent.clear();
      sut.receive({hex(command) + " 02 20 00 34 12 00 00"});
      sut.wire.expect(expected_of_server(state, command));
      sut.expect_alive();
    }
  }
}

TEST(SdoServerStates, EveryPairOfCommandBytesLeavesAServerThatWorks) {
  Server sut;
  for (unsigned first = 0; first < 256; ++first) {
    for (unsigned second = 0; second < 256; second += 3) {
      sut.receive({hex(first) + " 21 20 00 09 00 00 00", hex(second) + " 21 20 00 09 00 00 00"});
      ASSERT_LE(sut.wire.sent.size(), 2U);
      for (const auto& sent : sut.wire.sent) EXPECT_EQ(sent.frame.length, 8);
      sut.wire.sent.clear();
    }
  }
  sut.expect_alive();
}

/// Requests and answers, written from CiA 301, 7.2.4.3.
struct Dialogue {
  const char* name;
  Frames requests;
  Frames answers;
};

const std::vector<Dialogue> dialogues = {
    {"expedited upload", {"40 00 10 00 00 00 00 00"}, {"43 00 10 00 A2 01 02 00"}},
    {"expedited download", {"2B 02 20 00 34 12 00 00"}, {"60 02 20 00 00 00 00 00"}},
    {"upload in segments",
     {"40 13 20 00 00 00 00 00", "60 00 00 00 00 00 00 00", "70 00 00 00 00 00 00 00"},
     {"41 13 20 00 0B 00 00 00", "00 43 61 6E 76 6F 79 20", "17 6E 6F 64 65 00 00 00"}},
    {"download in segments",
     {"21 08 20 00 08 00 00 00", "00 01 02 03 04 05 06 07", "1D 08 00 00 00 00 00 00"},
     {"60 08 20 00 00 00 00 00", "20 00 00 00 00 00 00 00", "30 00 00 00 00 00 00 00"}},
    {"abort", {"21 08 20 00 08 00 00 00", "80 08 20 00 00 00 00 08"}, {"60 08 20 00 00 00 00 00"}},
};

Frames with_id(const std::string& id, Frames frames) {
  for (std::string& frame : frames) frame = id + "#" + frame;
  return frames;
}

std::string flipped(const std::string& message, unsigned bit) {
  Frame frame = wire_frame("605#" + message);
  frame.data.at(bit / 8) ^= static_cast<std::uint8_t>(1U << bit % 8);
  return wire_text(frame).substr(4);
}

TEST(SdoServerStates, GoldenDialogues) {
  for (const Dialogue& dialogue : dialogues) {
    SCOPED_TRACE(dialogue.name);
    Server sut;
    sut.receive(dialogue.requests);
    sut.wire.expect(with_id("585", dialogue.answers));
    sut.expect_alive();
  }
}

TEST(SdoServerStates, AFlippedBitInAnyRequestLeavesAServerThatWorks) {
  for (const Dialogue& dialogue : dialogues) {
    for (std::size_t place = 0; place < dialogue.requests.size(); ++place) {
      for (unsigned bit = 0; bit < 64; ++bit) {
        SCOPED_TRACE(dialogue.name + (", bit " + std::to_string(bit)) + " of request " +
                     std::to_string(place));
        Server sut;
        Frames requests = dialogue.requests;
        requests[place] = flipped(requests[place], bit);
        for (std::size_t i = 0; i < requests.size(); ++i) {
          sut.receive({requests[i]});
          // One answer to each request, none to an abort.
          EXPECT_EQ(sut.wire.sent.size(),
                    wire_frame("605#" + requests[i]).data[0] >> 5 == 4 ? 0U : 1U);
          sut.wire.sent.clear();
        }
        sut.expect_alive();
      }
    }
  }
}

/// Bits that CiA 301 reserves: a request has the same meaning with any of them set.
TEST(SdoServerStates, AFlippedReservedBitChangesNothing) {
  const std::vector<std::pair<std::size_t, std::vector<unsigned>>> reserved = {
      {0, {0, 1, 2, 3, 4, 32, 63}},  // upload: bits 4 to 0, data
      {1, {4, 48, 63}},              // expedited download: bit 4, unused data
  };
  for (const auto& [which, bits] : reserved) {
    for (const unsigned bit : bits) {
      SCOPED_TRACE(dialogues[which].name + (", bit " + std::to_string(bit)));
      Server sut;
      sut.receive({flipped(dialogues[which].requests[0], bit)});
      sut.wire.expect(with_id("585", dialogues[which].answers));
    }
  }
}

/// Node 1 is the client of node 5, which is the test.
struct Client {
  Client() { wire.boot(); }

  void upload() {
    EXPECT_EQ(client.upload(5, 0x2002, 0, bytes, SdoClient::Done::to<&Client::done>(*this)),
              AbortCode::none);
  }
  void download(std::size_t size) {
    EXPECT_EQ(client.download(5, 0x2002, 0, std::span(bytes).first(size),
                              SdoClient::Done::to<&Client::done>(*this)),
              AbortCode::none);
  }
  void done(SdoClient::Outcome result) { outcomes.push_back(result.abort()); }
  void receive(const Frames& answers) {
    for (const std::string& answer : answers) wire.receive("585#" + answer);
  }
  void expect_alive() {
    wire.run_for(10s);
    EXPECT_FALSE(client.busy());
    EXPECT_EQ(outcomes.size(), 1U);
    outcomes.clear();
    wire.sent.clear();
    upload();
    receive({"4B 02 20 00 34 12 00 00"});
    EXPECT_EQ(outcomes, std::vector{AbortCode::none});
    wire.expect({"605#40 02 20 00 00 00 00 00"});
  }

  WireNode wire{sdo_objects(), 1};
  SdoClient client{wire.node};
  std::array<std::uint8_t, 40> bytes{};
  std::vector<AbortCode> outcomes;
};

struct ClientState {
  const char* name;
  bool is_upload;
  std::size_t size;  ///< of a download
  Frames answers;    ///< answers that lead to this state
  int toggle;        ///< of the expected segment; -1: the answer to the initiate is expected
};

const std::vector<ClientState> client_states = {
    {"upload initiated", true, 0, {}, -1},
    {"upload", true, 0, {"40 02 20 00 00 00 00 00"}, 0x00},
    {"upload, second segment",
     true,
     0,
     {"40 02 20 00 00 00 00 00", "00 01 02 03 04 05 06 07"},
     0x10},
    {"expedited download initiated", false, 2, {}, -1},
    {"download initiated", false, 15, {}, -1},
    {"download", false, 15, {"60 02 20 00 00 00 00 00"}, 0x00},
    {"download, second segment",
     false,
     15,
     {"60 02 20 00 00 00 00 00", "20 00 00 00 00 00 00 00"},
     0x10},
    {"download, last segment",
     false,
     15,
     {"60 02 20 00 00 00 00 00", "20 00 00 00 00 00 00 00", "30 00 00 00 00 00 00 00"},
     0x00},
};

struct Reaction {
  std::optional<AbortCode> outcome;  ///< none while it waits
  Frames frames;
};

Reaction failed(AbortCode code) {
  Frame frame = wire_frame("605#80 02 20 00 00 00 00 00");
  store(frame.data.data() + 4, static_cast<std::uint32_t>(code));
  return {code, {wire_text(frame)}};
}

/// Reaction of a client by CiA 301 to an answer with `command`, the multiplexer 2002h:00h and the
/// value 12h; a segment's data is then 02 20 00 12 00 00 00.
Reaction expected_of_client(const ClientState& state, unsigned command) {
  const unsigned specifier = command >> 5;
  const int toggle = static_cast<int>(command & 0x10U);
  if (specifier == 4) return {static_cast<AbortCode>(0x12), {}};
  if (state.toggle < 0) {
    if (specifier == 2 && state.is_upload) {
      if ((command & 2U) != 0) return {AbortCode::none, {}};
      return {std::nullopt, {"605#60 00 00 00 00 00 00 00"}};
    }
    if (specifier == 3 && !state.is_upload) {
      if (state.size <= 4) return {AbortCode::none, {}};
      return {std::nullopt, {"605#00 00 00 00 00 00 00 00"}};
    }
    return {};
  }
  if (specifier == 2 || specifier == 3) return {};
  if (specifier != (state.is_upload ? 0U : 1U)) return failed(AbortCode::command_specifier);
  if (toggle != state.toggle) return failed(AbortCode::toggle_bit);
  const std::string next = hex(static_cast<unsigned>(toggle) ^ 0x10U);
  if (state.is_upload) {
    if ((command & 1U) != 0) return {AbortCode::none, {}};
    return {std::nullopt,
            {"605#" + hex(static_cast<unsigned>(toggle) ^ 0x70U) + " 00 00 00 00 00 00 00"}};
  }
  if (state.answers.size() == 3) return {AbortCode::none, {}};
  // 15 bytes: two full segments, and one with one byte.
  return {
      std::nullopt,
      {"605#" + (toggle == 0 ? std::string("10") : std::string("0D")) + " 00 00 00 00 00 00 00"}};
}

TEST(SdoClientStates, EveryCommandByteInEveryStateGetsTheReactionOfCiA301) {
  for (const ClientState& state : client_states) {
    for (unsigned command = 0; command < 256; ++command) {
      SCOPED_TRACE(std::string(state.name) + ", command " + hex(command));
      Client sut;
      state.is_upload ? sut.upload() : sut.download(state.size);
      sut.receive(state.answers);
      sut.wire.sent.clear();
      const Reaction expected = expected_of_client(state, command);
      Frames frames = expected.frames;
      sut.receive({hex(command) + " 02 20 00 12 00 00 00"});
      sut.wire.expect(frames);
      EXPECT_EQ(sut.outcomes,
                expected.outcome ? std::vector{*expected.outcome} : std::vector<AbortCode>{});
      EXPECT_EQ(sut.client.busy(), !expected.outcome);
      sut.expect_alive();
    }
  }
}

struct ClientDialogue {
  const char* name;
  std::size_t size;  ///< of a download; 0: an upload
  Frames answers;
};

TEST(SdoClientStates, AFlippedBitInAnyAnswerLeavesAClientThatWorks) {
  const std::vector<ClientDialogue> golden = {
      {"expedited upload", 0, {"4B 02 20 00 34 12 00 00"}},
      {"upload in segments",
       0,
       {"41 02 20 00 0B 00 00 00", "00 43 61 6E 76 6F 79 20", "17 6E 6F 64 65 00 00 00"}},
      {"expedited download", 2, {"60 02 20 00 00 00 00 00"}},
      {"download in segments",
       8,
       {"60 02 20 00 00 00 00 00", "20 00 00 00 00 00 00 00", "30 00 00 00 00 00 00 00"}},
      {"abort", 0, {"80 02 20 00 00 00 02 06"}},
  };
  for (const ClientDialogue& dialogue : golden) {
    for (std::size_t place = 0; place < dialogue.answers.size(); ++place) {
      for (unsigned bit = 0; bit < 64; ++bit) {
        SCOPED_TRACE(dialogue.name + (", bit " + std::to_string(bit)) + " of answer " +
                     std::to_string(place));
        Client sut;
        dialogue.size == 0 ? sut.upload() : sut.download(dialogue.size);
        Frames answers = dialogue.answers;
        answers[place] = flipped(answers[place], bit);
        sut.receive(answers);
        sut.expect_alive();
      }
    }
  }
}

}  // namespace
}  // namespace canvoy::sdo_state_test
