#include "canvoy/tools/network/boot_text.hpp"

#include <gtest/gtest.h>

#include <set>

namespace canvoy::tools::boot_text_test {
namespace {

TEST(BootText, HasWordsAndAdviceForEachLetter) {
  std::set<std::string_view> texts;
  for (char letter = 'A'; letter <= 'O'; ++letter) {
    const auto error = static_cast<BootError>(letter);
    EXPECT_FALSE(boot_error_text(error).empty()) << letter;
    EXPECT_FALSE(boot_advice(error).empty()) << letter;
    EXPECT_TRUE(texts.insert(boot_error_text(error)).second) << letter;
  }
  EXPECT_TRUE(boot_error_text(BootError::none).empty());
  EXPECT_TRUE(boot_error_text(static_cast<BootError>('P')).empty());
}

TEST(BootText, HasWordsForEachStepAndEvent) {
  std::set<std::string_view> words;
  for (unsigned step = 0; step <= static_cast<unsigned>(BootStep::done); ++step) {
    EXPECT_FALSE(boot_step_text(static_cast<BootStep>(step)).empty());
    EXPECT_TRUE(words.insert(boot_step_word(static_cast<BootStep>(step))).second);
  }
  for (unsigned event = 0; event <= static_cast<unsigned>(BootEvent::unknown); ++event) {
    EXPECT_TRUE(words.insert(boot_event_word(static_cast<BootEvent>(event))).second);
    EXPECT_FALSE(boot_line({.event = static_cast<BootEvent>(event)}).empty());
  }
  EXPECT_EQ(boot_step_word(BootStep::done), "done");
  EXPECT_EQ(boot_event_word(BootEvent::unknown), "unknown");
  EXPECT_EQ(boot_step_word(BootStep::serial_number), "serial-number");
}

TEST(BootText, TellsWhatWasExpectedAndWhatWasFound) {
  EXPECT_EQ(boot_line({.slave = 5,
                       .event = BootEvent::failed,
                       .step = BootStep::vendor_id,
                       .outcome = {BootError::vendor_id, AbortCode::none},
                       .expected = 0x123,
                       .found = 0x124}),
            "failed, D: another vendor-ID (1018h:01h): expected 00000123h, found 00000124h; "
            "a device of another maker has this node-ID: exchange it, or correct vendor=");
}

TEST(BootText, TellsTheAbortCodeThatIsTheCause) {
  const std::string text =
      boot_line({.slave = 5,
                 .event = BootEvent::failed,
                 .step = BootStep::configuration,
                 .outcome = {BootError::configuration, SdoEnd::by_server(AbortCode::value_range)}});
  EXPECT_EQ(text.substr(0, 61), "failed, J: the download of its configuration failed (06090030");
}

TEST(BootText, TellsASilentSlaveFromOneThatTellsATimeOut) {
  const auto text = [](BootError error, SdoEnd end) {
    return boot_line({.slave = 5,
                      .event = BootEvent::retried,
                      .step = BootStep::device_type,
                      .outcome = {error, end}});
  };
  EXPECT_EQ(text(BootError::no_answer, SdoEnd::no_answer()),
            "B: no answer; the next attempt follows");
  EXPECT_EQ(text(BootError::configuration, SdoEnd::no_answer()),
            "J: the download of its configuration failed (no answer); the next attempt follows");
  EXPECT_EQ(text(BootError::device_type, SdoEnd::by_server(AbortCode::time_out)),
            "C: another device type (1000h) (05040000h: SDO time-out); the next attempt follows");
}

TEST(BootText, TellsWhatBecameOfAConfiguration) {
  using Kind = ConfigurationOutcome::Kind;
  EXPECT_EQ(configuration_line({.kind = Kind::up_to_date}),
            "has the expected configuration: nothing was written");
  EXPECT_EQ(configuration_line({.kind = Kind::downloaded, .written = 1}),
            "is configured: 1 entry written");
  EXPECT_EQ(configuration_line({.kind = Kind::downloaded, .written = 12}),
            "is configured: 12 entries written");
  EXPECT_EQ(configuration_line({.kind = Kind::nothing_known}), "there is no configuration for it");
  EXPECT_EQ(configuration_line({.end = AbortCode::no_data}),
            "has not the expected configuration, and there is none to give it");
  EXPECT_TRUE(configuration_line({.end = AbortCode::length_too_low})
                  .starts_with("its concise DCF cannot be used: 06070013h"));
  EXPECT_EQ(
      configuration_line(
          {.end = SdoEnd::by_server(AbortCode::no_object), .index = 0x2000, .sub = 1, .written = 2})
          .substr(0, 33),
      "2000h:01h was not taken (06020000");
}

TEST(BootText, TellsWhereASlaveRestarted) {
  EXPECT_EQ(boot_line({.event = BootEvent::restarted, .step = BootStep::configuration}),
            "has restarted in the middle of its boot-up, after \"has its configuration checked\": "
            "begins anew");
  EXPECT_EQ(boot_line({.event = BootEvent::slowed, .step = BootStep::configuration, .delay = 2s}),
            "restarts again and again, after \"has its configuration checked\": the next attempt "
            "follows in 2 s");
  EXPECT_EQ(boot_line({.event = BootEvent::given_up, .step = BootStep::configuration}),
            "is given up, as it restarts each time, after \"has its configuration checked\"; look "
            "what its watchdog or supply does then, and switch it off and on");
  EXPECT_EQ(boot_line({.event = BootEvent::restarted, .step = BootStep::done}),
            "has restarted: is booted again");
}

}  // namespace
}  // namespace canvoy::tools::boot_text_test
