#include "canvoy/gateway/request.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace canvoy::gateway::request_test {
namespace {

ErrorCode error_of(std::string_view line) {
  return parse_request(line).error;
}
Request request_of(std::string_view line) {
  const Parsed parsed = parse_request(line);
  EXPECT_EQ(parsed.error, ErrorCode::none) << line;
  return parsed.request;
}
std::vector<std::uint64_t> numbers_of(std::string_view line) {
  return request_of(line).numbers;
}

TEST(GatewayRequest, EmptyLinesAndCommentsAreNothing) {
  for (const char* line : {"", "  ", "\t", "# [1] start", "  # a comment"}) {
    const Parsed parsed = parse_request(line);
    EXPECT_EQ(parsed.error, ErrorCode::none) << line;
    EXPECT_EQ(parsed.request.command, Command::none) << line;
  }
}

TEST(GatewayRequest, ASequenceStandsInBrackets) {
  EXPECT_EQ(parse_request("[1] start").sequence, 1U);
  EXPECT_EQ(parse_request(" [ 0x10 ]start").sequence, 16U);
  EXPECT_EQ(parse_request("[4294967295] start").sequence, 4294967295U);
  for (const char* line : {"start", "1 start", "[] start", "[1 start", "[-1] start", "[x] start",
                           "[4294967296] start", "[01] start", "]1[ start", "\"[1]\" start"}) {
    EXPECT_EQ(error_of(line), ErrorCode::syntax) << line;
    EXPECT_EQ(parse_request(line).sequence, 0U) << line;
  }
}

TEST(GatewayRequest, AnErrorBehindTheSequenceKeepsIt) {
  EXPECT_EQ(parse_request("[7]").sequence, 7U);
  EXPECT_EQ(error_of("[7]"), ErrorCode::syntax);
  EXPECT_EQ(error_of("[7] # nothing"), ErrorCode::syntax);
  EXPECT_EQ(parse_request("[7] frobnicate").sequence, 7U);
}

TEST(GatewayRequest, UnknownCommandsAreNotSupported) {
  for (const char* line : {"[1] frobnicate", "[1] set", "[1] set speed 1", "[1] reset", "[1] rea",
                           "[1] enable", "[1] reset everything", "[1] start[", "[1] \"start\""}) {
    EXPECT_EQ(error_of(line), ErrorCode::not_supported) << line;
  }
}

TEST(GatewayRequest, OneNumberBeforeACommandForNodesIsTheNode) {
  const Request request = request_of("[1] 5 start");
  EXPECT_EQ(request.node, 5U);
  EXPECT_FALSE(request.net);
}

TEST(GatewayRequest, TwoNumbersAreNetworkAndNode) {
  const Request request = request_of("[1] 0x2 0x05 start # go");
  EXPECT_EQ(request.net, 2U);
  EXPECT_EQ(request.node, 5U);
  EXPECT_EQ(error_of("[1] 1 2 3 start"), ErrorCode::syntax);
}

TEST(GatewayRequest, OneNumberBeforeACommandForNetworksIsTheNetwork) {
  const Request request = request_of("[1] 2 lss_store");
  EXPECT_EQ(request.net, 2U);
  EXPECT_FALSE(request.node);
  EXPECT_EQ(error_of("[1] 2 5 lss_store"), ErrorCode::syntax);
}

TEST(GatewayRequest, NoNumberStandsBeforeACommandForTheGateway) {
  EXPECT_EQ(error_of("[1] set network 1"), ErrorCode::none);
  EXPECT_EQ(error_of("[1] 1 set network 1"), ErrorCode::syntax);
  EXPECT_EQ(error_of("[1] 1 set command_timeout 1"), ErrorCode::syntax);
}

TEST(GatewayRequest, NumbersThatAreNoNetworkOrNodeAreRefused) {
  EXPECT_EQ(error_of("[1] 128 start"), ErrorCode::unknown_node);
  EXPECT_EQ(error_of("[1] 1 300 start"), ErrorCode::unknown_node);
  EXPECT_EQ(error_of("[1] 0 5 start"), ErrorCode::unknown_net);
  EXPECT_EQ(error_of("[1] 65536 5 start"), ErrorCode::unknown_net);
  EXPECT_EQ(error_of("[1] 5x start"), ErrorCode::syntax);
  EXPECT_EQ(error_of("[1] 05 start"), ErrorCode::syntax);
}

struct Spelling {
  const char* line;
  Command command;
};
class GatewaySpelling : public testing::TestWithParam<Spelling> {};

TEST_P(GatewaySpelling, IsUnderstood) {
  EXPECT_EQ(request_of(GetParam().line).command, GetParam().command) << GetParam().line;
}
TEST_P(GatewaySpelling, TakesNothingMoreBehindIt) {
  const std::string line = GetParam().line;
  EXPECT_NE(error_of(line + " nonsense"), ErrorCode::none) << line;
}

INSTANTIATE_TEST_SUITE_P(
    AllCommands, GatewaySpelling,
    testing::Values(
        Spelling{"[1] r 0x1000 0", Command::read}, Spelling{"[1] read 0x1000 0 u32", Command::read},
        Spelling{"[1] w 0x1017 0 u16 5", Command::write},
        Spelling{"[1] write 0x1017 0 u16 5", Command::write},
        Spelling{"[1] set sdo_timeout 500", Command::set_sdo_timeout},
        Spelling{"[1] set sdo_block 1", Command::set_sdo_block},
        Spelling{"[1] set rpdo 1 0x182 event 1 u8", Command::set_rpdo},
        Spelling{"[1] set tpdo 1 0x202 event 1 u8", Command::set_tpdo},
        Spelling{"[1] set tpdox 1 0x202 event10 100 1 u8", Command::set_tpdo},
        Spelling{"[1] r p 1", Command::read_pdo}, Spelling{"[1] read pdo 1", Command::read_pdo},
        Spelling{"[1] w p 1 1 5", Command::write_pdo},
        Spelling{"[1] write pdo 1 0", Command::write_pdo}, Spelling{"[1] start", Command::start},
        Spelling{"[1] StOp", Command::stop}, Spelling{"[1] preop", Command::preoperational},
        Spelling{"[1] preoperational", Command::preoperational},
        Spelling{"[1] reset node", Command::reset_node},
        Spelling{"[1] reset comm", Command::reset_communication},
        Spelling{"[1] reset communication", Command::reset_communication},
        Spelling{"[1] enable guarding 100 3", Command::enable_guarding},
        Spelling{"[1] disable guarding", Command::disable_guarding},
        Spelling{"[1] enable heartbeat 100", Command::enable_heartbeat},
        Spelling{"[1] disable heartbeat", Command::disable_heartbeat},
        Spelling{"[1] init 0", Command::init},
        Spelling{"[1] set heartbeat 100", Command::set_heartbeat},
        Spelling{"[1] set id 127", Command::set_id},
        Spelling{"[1] set command_timeout 1000", Command::set_command_timeout},
        Spelling{"[1] set command_size 4096", Command::set_command_size},
        Spelling{"[1] boot_up_indication Enable", Command::boot_up_indication},
        Spelling{"[1] set network 1", Command::set_network},
        Spelling{"[1] set node 5", Command::set_node},
        Spelling{"[1] info version", Command::info_version},
        Spelling{"[1] lss_switch_glob 0", Command::lss_switch_global},
        Spelling{"[1] lss_switch_sel 1 2 3 4", Command::lss_switch_selective},
        Spelling{"[1] lss_set_node 5", Command::lss_set_node},
        Spelling{"[1] lss_conf_bitrate 0 4", Command::lss_configure_bit_rate},
        Spelling{"[1] lss_activate_bitrate 100", Command::lss_activate_bit_rate},
        Spelling{"[1] lss_store", Command::lss_store},
        Spelling{"[1] lss_inquire_addr", Command::lss_inquire_address},
        Spelling{"[1] lss_inquire_addr 0x5D", Command::lss_inquire_address},
        Spelling{"[1] lss_get_node", Command::lss_get_node},
        Spelling{"[1] lss_identity 1 2 3 4 5 6", Command::lss_identity},
        Spelling{"[1] lss_ident_nonconf", Command::lss_identify_unconfigured},
        Spelling{"[1] _lss_fastscan", Command::lss_fastscan},
        Spelling{"[1] _lss_fastscan 0 0 0 0 0 0 0 0", Command::lss_fastscan}));

TEST(GatewayRequest, ArgumentsHaveRanges) {
  for (const char* line : {"[1] set sdo_timeout 0",
                           "[1] set sdo_timeout",
                           "[1] set sdo_timeout 1 2",
                           "[1] set sdo_timeout -1",
                           "[1] set sdo_block 2",
                           "[1] r p 0",
                           "[1] r p 513",
                           "[1] r",
                           "[1] r 0x1000",
                           "[1] r 0x10000 0",
                           "[1] r 0x1000 256",
                           "[1] r 0x1000 0 u7",
                           "[1] w 0x1000 0",
                           "[1] enable guarding 65536 3",
                           "[1] enable guarding 100 256",
                           "[1] enable guarding 100",
                           "[1] enable heartbeat 65536",
                           "[1] init 10",
                           "[1] init",
                           "[1] set id 0",
                           "[1] set id 256",
                           "[1] set node 256",
                           "[1] lss_switch_glob 2",
                           "[1] lss_switch_sel 1 2 3",
                           "[1] lss_set_node 0",
                           "[1] lss_inquire_addr 4",
                           "[1] lss_inquire_addr 0x5E",
                           "[1] boot_up_indication",
                           "[1] boot_up_indication maybe",
                           "[1] _lss_fastscan 0",
                           "[1] _lss_fastscan 1 2",
                           "[1] w p 1",
                           "[1] w p 1 65",
                           "[1] w p 1 2 5",
                           "[1] w p 1 1 -5"}) {
    EXPECT_EQ(error_of(line), ErrorCode::syntax) << line;
  }
}

TEST(GatewayRequest, TheArgumentsAreKeptInTheirOrder) {
  using Numbers = std::vector<std::uint64_t>;
  EXPECT_EQ(numbers_of("[1] lss_identity 1 2 3 4 5 0xFFFFFFFF"),
            (Numbers{1, 2, 3, 4, 5, 0xFFFF'FFFF}));
  EXPECT_EQ(numbers_of("[1] w p 7 3 0x12 0x3456 18446744073709551615"),
            (Numbers{7, 0x12, 0x3456, 18446744073709551615U}));
  EXPECT_EQ(numbers_of("[1] boot_up_indication DISABLE"), Numbers{0});
  EXPECT_EQ(numbers_of("[1] lss_inquire_addr 0x5C"), Numbers{2});
  EXPECT_EQ(numbers_of("[1] lss_inquire_addr 3"), Numbers{3});
}

TEST(GatewayRequest, AnRpdoHasACobIdATypeAndWhatItMaps) {
  const Request request =
      request_of("[1] set rpdo 1 0x182 sync0 3 0x2003 0 u8 u16 0x2005 0x00 r32");
  EXPECT_EQ(request.numbers, std::vector<std::uint64_t>{1});
  EXPECT_EQ(request.pdo,
            (PdoSetup{.cob_id = 0x182,
                      .transmission_type = 0,
                      .mapped = {DataType::unsigned8, DataType::unsigned16, DataType::real32}}));
}

TEST(GatewayRequest, TheTransmissionTypesOfAPdo) {
  const auto setup_of = [](const std::string& type) {
    return request_of("[1] set tpdo 1 0x202 " + type + " 1 u8").pdo;
  };
  EXPECT_EQ(setup_of("rtr").transmission_type, 253);
  EXPECT_EQ(setup_of("event").transmission_type, 255);
  EXPECT_EQ(setup_of("sync0").transmission_type, 0);
  EXPECT_EQ(setup_of("SYNC 240").transmission_type, 240);
  for (const char* type : {"sync241", "sync", "event5", "rtr1", "never", "5"}) {
    EXPECT_EQ(error_of("[1] set tpdo 1 0x202 " + std::string(type) + " 1 u8"), ErrorCode::syntax)
        << type;
  }
}

TEST(GatewayRequest, AnExtendedTpdoHasTimesOrASyncStartValue) {
  const PdoSetup event = request_of("[1] set tpdox 1 0x202 event100 500 1 u8").pdo;
  EXPECT_EQ(event.inhibit_ms, 100);
  EXPECT_EQ(event.event_ms, 500);
  EXPECT_EQ(request_of("[1] set tpdox 1 0x202 event 100 500 1 u8").pdo, event);
  const PdoSetup sync = request_of("[1] set tpdox 1 0x202 sync2 7 1 u8").pdo;
  EXPECT_EQ(sync.transmission_type, 2);
  EXPECT_EQ(sync.sync_start, 7);
  EXPECT_EQ(request_of("[1] set tpdox 1 0x202 rtr 1 u8").pdo.transmission_type, 253);
  for (const char* type : {"event", "event6554 1", "event1 65536", "sync2", "sync2 256"}) {
    EXPECT_EQ(error_of("[1] set tpdox 1 0x202 " + std::string(type) + " 1 u8"), ErrorCode::syntax)
        << type;
  }
}

TEST(GatewayRequest, OnlyTypesOfOneLengthAreMapped) {
  EXPECT_EQ(request_of("[1] set rpdo 1 0x182 event 0").pdo.mapped.size(), 0U);
  for (const char* mapped :
       {"1", "1 vs", "1 hex", "1 0x2000 u8", "2 u8", "1 u8 u8", "65 u8", "x"}) {
    EXPECT_EQ(error_of("[1] set rpdo 1 0x182 event " + std::string(mapped)), ErrorCode::syntax)
        << mapped;
  }
}

TEST(GatewayRequest, EveryBeginningOfALineIsAnswered) {
  const std::string line = "[17] 1 5 write 0x2020 0 vs \"Hello, \"\"World\"\"!\" # comment";
  for (std::size_t length = 0; length <= line.size(); ++length) {
    const Parsed parsed = parse_request(line.substr(0, length));
    if (length >= 4) {
      EXPECT_EQ(parsed.sequence, 17U) << length;
    }
  }
}

TEST(GatewayRequest, EveryByteAnywhereIsRefusedOrUnderstood) {
  const std::string line = "[1] 5 w 0x2020 0 vs \"a\"";
  for (std::size_t place = 0; place < line.size(); ++place) {
    for (int byte = 0; byte < 256; ++byte) {
      std::string changed = line;
      changed[place] = static_cast<char>(byte);
      const Parsed parsed = parse_request(changed);
      EXPECT_TRUE(parsed.error != ErrorCode::none || parsed.request.command == Command::write ||
                  parsed.request.command == Command::none)
          << changed;
    }
  }
}

RC_GTEST_PROP(GatewayRequest, AnyTextIsAnswered, (const std::string& text)) {
  const Parsed parsed = parse_request("[5] " + text);
  RC_ASSERT(parsed.sequence == 5U);
}

}  // namespace
}  // namespace canvoy::gateway::request_test
