#include "canvoy/can/host/socketcand_message.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "canvoy/can/frame_text.hpp"

// The messages follow doc/protocol.md of socketcand, and the output of its state_raw.c.
namespace canvoy::host::socketcand_message_test {
namespace {

std::string text_of(std::string_view message) {
  const std::optional<Frame> frame = parse_socketcand_frame(message);
  return frame ? std::string(FrameText(*frame).view()) : "refused";
}

TEST(SocketcandMessage, AFrameIsSentWithItsLengthAndItsBytesApart) {
  EXPECT_EQ(socketcand_send_message(parse_frame("123#").frame), "< send 123 0 >");
  EXPECT_EQ(socketcand_send_message(parse_frame("1AAAAAAA#01F1").frame),
            "< send 1AAAAAAA 2 01 F1 >");
  EXPECT_EQ(socketcand_send_message(parse_frame("00000123#42").frame), "< send 00000123 1 42 >");
}

TEST(SocketcandMessage, ARemoteFrameHasItsOwnWord) {
  EXPECT_EQ(socketcand_send_message(parse_frame("123#R").frame), "< sendrtr 123 0 >");
  EXPECT_EQ(socketcand_send_message(parse_frame("1AAAAAAA#R2").frame), "< sendrtr 1AAAAAAA 2 >");
}

TEST(SocketcandMessage, AFrameIsReadWithItsBytesTogetherOrApart) {
  EXPECT_EQ(text_of("frame 123 23.424242 11223344"), "123#11223344");
  EXPECT_EQ(text_of("frame 123 23.424242 11 22 33 4"), "123#11223304");
  EXPECT_EQ(text_of("frame 123 23.424242"), "123#");
  EXPECT_EQ(text_of("frame 00000123 1700000000.000001 FF"), "00000123#FF");
  EXPECT_EQ(text_of("rtr 123 23.424242 4"), "123#R4");
  EXPECT_EQ(text_of("rtr 1AAAAAAA 23.424242 0"), "1AAAAAAA#R");
}

TEST(SocketcandMessage, AnErrorFrameIsReadWithItsClass) {
  EXPECT_EQ(text_of("error 040 23.424242"), "20000040#0000000000000000");
}

TEST(SocketcandMessage, WhatIsNoFrameIsRefused) {
  for (const char* message :
       {"", "ok", "hi", "frame", "frame 123", "frame 123 soon 11", "frame 800 1.0 11",
        "frame 20000000 1.0 11", "frame xyz 1.0 11", "frame 123 1.0 112233445566778899",
        "frame 123 1.0 123", "frame 123 1.0 1G", "rtr 123 1.0", "rtr 123 1.0 9", "rtr 123 1.0 1 1",
        "frame -12 1.0 11", "error", "error unknown command", "stat 1 2 3 4"}) {
    EXPECT_EQ(text_of(message), "refused") << message;
  }
}

TEST(SocketcandMessage, MessagesAreCutOutOfAnyPieces) {
  const std::string stream = "< hi >< ok ><frame 123 1.0 11>noise\r\n< ok >";
  for (std::size_t piece = 1; piece <= stream.size(); ++piece) {
    SocketcandMessages messages;
    std::vector<std::string> found;
    for (std::size_t at = 0; at < stream.size(); at += piece) {
      messages.add(std::string_view(stream).substr(at, piece));
      while (const auto message = messages.next()) found.emplace_back(*message);
    }
    EXPECT_EQ(found, (std::vector<std::string>{"hi", "ok", "frame 123 1.0 11", "ok"})) << piece;
  }
}

TEST(SocketcandMessage, OneWithoutAnEndTakesNoMemory) {
  SocketcandMessages messages;
  messages.add("<" + std::string(SocketcandMessages::length_max, 'x'));
  EXPECT_FALSE(messages.next());
  EXPECT_EQ(messages.take_malformed(), 1);
  EXPECT_EQ(messages.take_malformed(), 0);
  messages.add("< ok >");
  EXPECT_EQ(messages.next(), "ok");
}

}  // namespace
}  // namespace canvoy::host::socketcand_message_test
