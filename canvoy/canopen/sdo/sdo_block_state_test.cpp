// Every command byte in every state of a block transfer, at server and client, and golden dialogues
// with each of their bits flipped: the answer is right, an abort, or absent, and the node works
// afterwards.
#include <gtest/gtest.h>

#include "canvoy/canopen/sdo/sdo_block_client.hpp"
#include "canvoy/canopen/sdo/sdo_block_server.hpp"
#include "canvoy/canopen/testing/sdo_objects.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy::sdo_block_state_test {
namespace {

using Frames = std::vector<std::string>;

std::string hex(unsigned byte) {
  char text[8];
  std::snprintf(text, sizeof text, "%02X", byte);
  return text;
}

Frames with_id(const std::string& id, Frames frames) {
  for (std::string& frame : frames) frame = id + "#" + frame;
  return frames;
}

std::string flipped(const std::string& message, unsigned bit) {
  Frame frame = wire_frame("605#" + message);
  frame.data.at(bit / 8) ^= static_cast<std::uint8_t>(1U << bit % 8);
  return wire_text(frame).substr(4);
}

// The server

/// Node 5, which requests blocks of 4 segments.
struct Server {
  Server() {
    wire.boot();
    set_value(wire.node, 0x2021, pattern(30));
  }
  void receive(const Frames& requests) {
    for (const std::string& request : requests) wire.receive("605#" + request);
  }
  void expect_alive() {
    wire.run_for(10s);
    EXPECT_FALSE(server.busy());
    wire.sent.clear();
    receive({"40 00 10 00 00 00 00 00"});
    wire.expect({"585#43 00 10 00 A2 01 02 00"});
    receive({"C2 08 20 00 08 00 00 00", "01 01 02 03 04 05 06 07", "82 08 00 00 00 00 00 00",
             "D9 00 00 00 00 00 00 00"});
    wire.expect({"585#A4 08 20 00 04 00 00 00", "585#A2 02 04 00 00 00 00 00",
                 "585#A1 00 00 00 00 00 00 00"});
    wire.run_for(10s);
    wire.expect({});
  }

  WireNode wire{sdo_objects(), 5};
  std::array<std::uint8_t, 64> buffer{};
  SdoServer server{wire.node, 0, buffer};
  SdoBlockServer blocks{server, 4};
};

enum class Waits : std::uint8_t { nothing, segment, end, start, acknowledgement, confirmation };

struct ServerState {
  const char* name;
  Waits waits_for;
  Frames requests;  ///< requests that lead to this state
  unsigned taken;   ///< segments of this block
  const char* multiplexer;
};

const std::vector<ServerState> server_states = {
    {"idle", Waits::nothing, {}, 0, "00 00 00"},
    {"download begun", Waits::segment, {"C0 21 20 00 00 00 00 00"}, 0, "21 20 00"},
    {"download, second segment",
     Waits::segment,
     {"C0 21 20 00 00 00 00 00", "01 01 02 03 04 05 06 07"},
     1,
     "21 20 00"},
    {"download, end",
     Waits::end,
     {"C0 21 20 00 00 00 00 00", "81 01 02 03 04 05 06 07"},
     0,
     "21 20 00"},
    {"upload begun", Waits::start, {"A0 21 20 00 02 00 00 00"}, 0, "21 20 00"},
    {"upload, block sent",
     Waits::acknowledgement,
     {"A0 21 20 00 02 00 00 00", "A3 00 00 00 00 00 00 00"},
     0,
     "21 20 00"},
    {"upload, end",
     Waits::confirmation,
     {"A0 21 20 00 05 00 00 00", "A3 00 00 00 00 00 00 00", "A2 05 05 00 00 00 00 00"},
     0,
     "21 20 00"},
};

/// Answer to a segment with the first byte `command`.
Frames expected_of_block(const ServerState& state, unsigned command) {
  const unsigned number = command & 0x7FU;
  if (command == 0x80) return {};
  if (number == 0 || number > 4) return {"80 21 20 00 03 00 04 05"};
  const unsigned taken = number == state.taken + 1 ? number : state.taken;
  if (number < 4 && command < 0x80) return {};
  return {"A2 " + hex(taken) + " 04 00 00 00 00 00"};
}

/// Answer of the server by CiA 301 to `command` 02 20 00 34 12 00 00.
Frames expected_of_server(const ServerState& state, unsigned command) {
  if (state.waits_for == Waits::segment) return expected_of_block(state, command);
  const Frames refused = {"80 " + std::string(state.multiplexer) + " 01 00 04 05"};
  switch (command >> 5) {
    case 1: {
      const unsigned size = 4 - (command >> 2 & 3U);
      const bool expedited = (command & 2U) != 0;
      const bool sized = (command & 1U) != 0;
      if (sized && (!expedited || size > 2)) return {"80 02 20 00 12 00 07 06"};
      if (sized && size < 2) return {"80 02 20 00 13 00 07 06"};
      return {"60 02 20 00 00 00 00 00"};
    }
    case 2:
      return {"4B 02 20 00 00 00 00 00"};
    case 4:
      return {};
    case 5:
      switch (command & 3U) {
        case 0:  // blocks of 52 segments, but not for up to 18 bytes
          return {"4B 02 20 00 00 00 00 00"};
        case 1:
          return state.waits_for == Waits::confirmation ? Frames{} : refused;
        case 2:  // 2 segments, then 32
          if (state.waits_for == Waits::confirmation) return {};
          if (state.waits_for != Waits::acknowledgement) return refused;
          return {"01 B5 D4 F3 12 31 50 6F", "02 8F AE CD EC 0B 2A 49", "83 69 88 00 00 00 00 00"};
        default:
          if (state.waits_for != Waits::start) return refused;
          return {"01 01 20 3F 5E 7D 9C BB", "02 DB FA 19 38 57 76 95"};
      }
    case 6:
      if ((command & 1U) != 0) {
        if (state.waits_for != Waits::end) return refused;
        return {"A1 00 00 00 00 00 00 00"};
      }
      if ((command & 2U) != 0) return {"80 02 20 00 12 00 07 06"};  // 1234h bytes
      return {"A4 02 20 00 04 00 00 00"};
    default:
      return refused;
  }
}

TEST(SdoBlockServerStates, EveryCommandByteInEveryStateGetsTheAnswerOfCiA301) {
  for (const ServerState& state : server_states) {
    for (unsigned command = 0; command < 256; ++command) {
      SCOPED_TRACE(std::string(state.name) + ", command " + hex(command));
      Server sut;
      sut.receive(state.requests);
      sut.wire.sent.clear();
      sut.receive({hex(command) + " 02 20 00 34 12 00 00"});
      sut.wire.expect(with_id("585", expected_of_server(state, command)));
      sut.expect_alive();
    }
  }
}

const std::vector<Frames> server_dialogues = {
    {"C6 08 20 00 08 00 00 00", "01 01 02 03 04 05 06 07", "82 08 00 00 00 00 00 00",
     "D9 AC 76 00 00 00 00 00"},
    {"A4 21 20 00 7F 00 00 00", "A3 00 00 00 00 00 00 00", "A2 05 7F 00 00 00 00 00",
     "A1 00 00 00 00 00 00 00"},
    {"A4 21 20 00 03 00 00 00", "A3 00 00 00 00 00 00 00", "A2 01 7F 00 00 00 00 00",
     "A2 04 7F 00 00 00 00 00", "A1 00 00 00 00 00 00 00"},
};

TEST(SdoBlockServerStates, AFlippedBitInAnyRequestLeavesAServerThatWorks) {
  for (const Frames& dialogue : server_dialogues) {
    for (std::size_t place = 0; place < dialogue.size(); ++place) {
      for (unsigned bit = 0; bit < 64; ++bit) {
        SCOPED_TRACE(dialogue[place] + ", bit " + std::to_string(bit));
        Server sut;
        Frames requests = dialogue;
        requests[place] = flipped(requests[place], bit);
        sut.receive(requests);
        EXPECT_LE(sut.wire.sent.size(), 20U);
        sut.expect_alive();
        // The written value is the one sent, or none.
        const auto value = value_of(sut.wire.node, 0x2021);
        EXPECT_EQ(value, pattern(30));
      }
    }
  }
}

TEST(SdoBlockServerStates, AFlippedDataBitIsFoundByTheChecksum) {
  for (unsigned segment = 1; segment <= 2; ++segment) {
    for (unsigned bit = 8; bit < (segment == 1 ? 64U : 16U); ++bit) {
      Server sut;
      Frames requests = server_dialogues[0];
      requests[segment] = flipped(requests[segment], bit);
      sut.receive(requests);
      EXPECT_EQ(wire_text(sut.wire.sent.back().frame), "585#80 08 20 00 04 00 04 05");
      EXPECT_EQ(value_of(sut.wire.node, 0x2008), std::vector<std::uint8_t>(8));
    }
  }
}

// The client

/// Node 1 reads and writes 15 bytes at node 5, which is the test.
struct Client {
  explicit Client(bool is_upload) {
    wire.boot();
    client.choose(SdoTransfer::block);
    const auto on_done = SdoClient::Done::to<&Client::done>(*this);
    EXPECT_EQ(is_upload ? client.upload(5, 0x2002, 0, bytes, on_done)
                        : client.download(5, 0x2002, 0, std::span(bytes).first(15), on_done),
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
    client.choose(SdoTransfer::segmented);
    EXPECT_EQ(client.upload(5, 0x2002, 0, bytes, SdoClient::Done::to<&Client::done>(*this)),
              AbortCode::none);
    receive({"4B 02 20 00 34 12 00 00"});
    EXPECT_EQ(outcomes, std::vector{AbortCode::none});
    wire.expect({"605#40 02 20 00 00 00 00 00"});
  }

  WireNode wire{sdo_objects(), 1};
  SdoClient client{wire.node};
  SdoBlockClient blocks{client, {}, 4};
  std::array<std::uint8_t, 40> bytes{};
  std::vector<AbortCode> outcomes;
};

struct ClientState {
  const char* name;
  bool is_upload;
  Waits waits_for;
  Frames answers;
  unsigned taken;
};

const std::vector<ClientState> client_states = {
    {"upload begun", true, Waits::start, {}, 0},
    {"upload, first segment", true, Waits::segment, {"C0 02 20 00 00 00 00 00"}, 0},
    {"upload, second segment",
     true,
     Waits::segment,
     {"C0 02 20 00 00 00 00 00", "01 01 02 03 04 05 06 07"},
     1},
    {"upload, end", true, Waits::end, {"C0 02 20 00 00 00 00 00", "81 01 02 03 04 05 06 07"}, 0},
    {"download begun", false, Waits::start, {}, 0},
    {"download, block sent", false, Waits::acknowledgement, {"A0 02 20 00 7F 00 00 00"}, 0},
    {"download, end",
     false,
     Waits::confirmation,
     {"A0 02 20 00 7F 00 00 00", "A2 03 7F 00 00 00 00 00"},
     0},
};

struct Reaction {
  std::optional<AbortCode> outcome;  ///< none while it waits
  Frames frames;
};

Reaction failed(AbortCode code) {
  Frame frame = wire_frame("605#80 02 20 00 00 00 00 00");
  store(frame.data.data() + 4, static_cast<std::uint32_t>(code));
  return {code, {wire_text(frame).substr(4)}};
}

/// Reaction of a client by CiA 301 to the answer `command` 02 20 00 12 00 00 00.
Reaction expected_of_client(const ClientState& state, unsigned command) {
  const unsigned specifier = command >> 5;
  if (state.waits_for == Waits::segment) {
    const unsigned number = command & 0x7FU;
    if (command == 0x80) return {static_cast<AbortCode>(0x12), {}};
    if (number == 0 || number > 4) return failed(AbortCode::sequence_number);
    const unsigned taken = number == state.taken + 1 ? number : state.taken;
    if (number < 4 && command < 0x80) return {};
    return {std::nullopt, {"A2 " + hex(taken) + " 04 00 00 00 00 00"}};
  }
  if (specifier == 4) return {static_cast<AbortCode>(0x12), {}};
  switch (state.waits_for) {
    case Waits::start:
      if (state.is_upload && specifier == 2) {
        if ((command & 2U) != 0) return {AbortCode::none, {}};
        return {std::nullopt, {"60 00 00 00 00 00 00 00"}};
      }
      if (state.is_upload && specifier == 6 && (command & 1U) == 0) {
        return {std::nullopt, {"A3 00 00 00 00 00 00 00"}};
      }
      if (!state.is_upload && specifier == 5 && (command & 3U) == 0) {
        return {std::nullopt,
                {"01 00 00 00 00 00 00 00", "02 00 00 00 00 00 00 00", "83 00 00 00 00 00 00 00"}};
      }
      return {};
    case Waits::end:
      if (specifier == 6 && (command & 1U) != 0) {
        return {AbortCode::none, {"A1 00 00 00 00 00 00 00"}};
      }
      return failed(AbortCode::command_specifier);
    case Waits::acknowledgement:
      if (specifier == 5 && (command & 3U) == 2) {  // two of three, then 32
        return {std::nullopt, {"81 00 00 00 00 00 00 00"}};
      }
      return failed(AbortCode::command_specifier);
    default:
      if (specifier == 5 && (command & 3U) == 1) return {AbortCode::none, {}};
      if (specifier == 5 && (command & 3U) == 2) return {};
      return failed(AbortCode::command_specifier);
  }
}

TEST(SdoBlockClientStates, EveryCommandByteInEveryStateGetsTheReactionOfCiA301) {
  for (const ClientState& state : client_states) {
    for (unsigned command = 0; command < 256; ++command) {
      SCOPED_TRACE(std::string(state.name) + ", command " + hex(command));
      Client sut(state.is_upload);
      sut.receive(state.answers);
      sut.wire.sent.clear();
      const Reaction expected = expected_of_client(state, command);
      sut.receive({hex(command) + " 02 20 00 12 00 00 00"});
      sut.wire.expect(with_id("605", expected.frames));
      EXPECT_EQ(sut.outcomes,
                expected.outcome ? std::vector{*expected.outcome} : std::vector<AbortCode>{});
      sut.expect_alive();
    }
  }
}

TEST(SdoBlockClientStates, AFlippedBitInAnyAnswerLeavesAClientThatWorks) {
  const std::vector<std::pair<bool, Frames>> golden = {
      {true,
       {"C6 02 20 00 08 00 00 00", "01 01 02 03 04 05 06 07", "82 08 00 00 00 00 00 00",
        "D9 AC 76 00 00 00 00 00"}},
      {false,
       {"A4 02 20 00 02 00 00 00", "A2 02 7F 00 00 00 00 00", "A2 01 7F 00 00 00 00 00",
        "A1 00 00 00 00 00 00 00"}}};
  for (const auto& [is_upload, dialogue] : golden) {
    for (std::size_t place = 0; place < dialogue.size(); ++place) {
      for (unsigned bit = 0; bit < 64; ++bit) {
        SCOPED_TRACE(dialogue[place] + ", bit " + std::to_string(bit));
        Client sut(is_upload);
        Frames answers = dialogue;
        answers[place] = flipped(answers[place], bit);
        sut.receive(answers);
        EXPECT_LE(sut.wire.sent.size(), 20U);
        sut.expect_alive();
      }
    }
  }
}

}  // namespace
}  // namespace canvoy::sdo_block_state_test
