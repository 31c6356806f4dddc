// The step of the boot-up of a slave that decides whether it is reset (CiA 302-2; letters E, F and
// L): it is, unless it has just booted, or is to be kept alive and is operational.
#include <gtest/gtest.h>

#include "canvoy/canopen/testing/boot_network.hpp"

namespace canvoy::boot_slave_reset_test {
namespace {

constexpr std::uint32_t optional_slave = 0x05;
constexpr std::uint32_t kept_alive = 0x15;

/// Slave 5 answers its device type: the step under test follows. Without a boot-up message.
struct ResettingMaster : BootNetwork {
  void identify() {
    start();
    run_until(Time(1s));
    forget();
    answer(5, 0x1000, 0, 0x191);
  }
};

/// The same for a slave that is kept alive: it is asked at once.
struct KeepingMaster : BootNetwork {
  explicit KeepingMaster(std::uint32_t assignment = kept_alive) { assign(5, assignment); }
  void identify() {
    start();
    forget();
    answer(5, 0x1000, 0, 0x191);
  }
};

TEST(BootSlaveReset, is_done_to_a_slave_that_sent_no_boot_up_message) {
  ResettingMaster sut;
  sut.assign(5, optional_slave);
  sut.identify();
  sut.expect({"000#82 05"});
  sut.run_until(Time(1100ms));
  sut.receive("705#00");
  sut.expect({"000#01 05"});
  sut.expect_log({"@1000 5 reset", "@1100 5 error_control", "@1100 5 booted", "@1100 5 started"});
}

TEST(BootSlaveReset, is_not_done_to_a_slave_that_has_just_booted) {
  BootNetwork sut;
  sut.assign(5, optional_slave);
  sut.start();
  sut.forget();
  sut.bring_up(5);
  sut.expect({"605#40 00 10 00 00 00 00 00", "000#01 05"});
}

TEST(BootSlaveReset, is_followed_by_a_question_where_no_boot_up_message_comes) {
  ResettingMaster sut;
  sut.assign(5, optional_slave);
  sut.identify();
  sut.run_until(Time(2s));
  sut.expect({"@1000000 000#82 05", "@2000000 605#40 00 10 00 00 00 00 00"});
  sut.answer(5, 0x1000, 0, 0x191);
  sut.expect({"000#01 05"});
  sut.expect_log({"@1000 5 reset", "@2000 5 no_boot_up", "@2000 5 device_type",
                  "@2000 5 error_control", "@2000 5 booted", "@2000 5 started"});
}

TEST(BootSlaveReset, that_ends_a_slave_leads_to_the_next_attempt) {
  ResettingMaster sut;
  sut.assign(5, optional_slave);
  sut.identify();
  sut.run_until(Time(4s));
  sut.expect_log({"@1000 5 reset", "@2000 5 no_boot_up", "@2000 5 device_type",
                  "@3000 5 retried B 05040000", "@4000 5 device_type"});
}

TEST(BootSlaveReset, gives_the_slave_the_time_that_the_owner_sets) {
  BootNetwork sut(2, {.options = {.boot_up_time_out = 5s}});
  sut.assign(5, optional_slave);
  sut.start();
  sut.forget();
  sut.run_until(Time(5s));
  sut.expect({"@5000000 605#40 00 10 00 00 00 00 00"});
  sut.answer(5, 0x1000, 0, 0x191);
  sut.run_until(Time(10s));
  sut.expect({"@5000000 000#82 05", "@10000000 605#40 00 10 00 00 00 00 00"});
}

TEST(BootSlaveReset, takes_the_heartbeats_of_before_for_no_boot_up) {
  ResettingMaster sut;
  sut.assign(5, optional_slave);
  sut.identify();
  sut.receive("705#05");
  sut.receive("705#7F");
  sut.expect_log({"5 reset"});
}

TEST(BootSlaveReset, spares_an_operational_slave_that_is_kept_alive_by_its_heartbeat) {
  KeepingMaster sut;
  sut.watch(5, 300);
  sut.identify();
  sut.expect({});
  sut.run_until(Time(200ms));
  sut.receive("705#05");
  sut.expect({});
  sut.expect_log({"@0 5 node_state", "@200 5 booted L"});
  EXPECT_EQ(sut.manager.slave_state(5), BootManager::SlaveState::booted);
  EXPECT_EQ(sut.manager.slave_error(5), BootError::already_operational);
}

TEST(BootSlaveReset, is_done_to_a_slave_that_is_kept_alive_but_not_operational) {
  for (const char* heartbeat : {"705#7F", "705#04"}) {
    KeepingMaster sut;
    sut.watch(5, 300);
    sut.identify();
    sut.receive(heartbeat);
    sut.expect({"000#82 05"});
    sut.expect_log({"5 node_state", "5 reset"});
  }
}

TEST(BootSlaveReset, is_not_done_to_a_slave_that_is_kept_alive_and_has_just_booted) {
  KeepingMaster sut;
  sut.watch(5, 300);
  sut.start();
  sut.boot_up(5);
  sut.forget();
  sut.answer(5, 0x1000, 0, 0x191);
  sut.receive("705#7F");
  sut.receive("705#7F");
  sut.expect({"000#01 05"});
  sut.expect_log({"5 node_state", "5 error_control", "5 booted", "5 started"});
}

TEST(BootSlaveReset, needs_a_heartbeat_of_a_slave_that_is_kept_alive) {
  KeepingMaster sut;
  sut.watch(5, 300);
  sut.identify();
  sut.run_until(Time(1h));
  sut.expect({});
  sut.expect_log({"@0 5 node_state", "@300 5 failed E"});
}

TEST(BootSlaveReset, takes_a_heartbeat_in_the_very_last_microsecond) {
  KeepingMaster sut;
  sut.watch(5, 300);
  sut.identify();
  sut.run_until(Time(300ms - 1us));
  sut.receive("705#05");
  sut.expect_log({"5 node_state", "5 booted L"});
}

TEST(BootSlaveReset, asks_for_the_state_by_guarding_where_no_heartbeat_is_known) {
  KeepingMaster sut(0x00C8'0315);  // guard time 200 ms
  sut.identify();
  sut.expect({"705#R1"});
  sut.run_until(Time(20ms));
  sut.receive("705#85");
  sut.expect({});
  sut.expect_log({"@0 5 node_state", "@20 5 booted L"});
}

TEST(BootSlaveReset, needs_an_answer_to_guarding_of_a_slave_that_is_kept_alive) {
  KeepingMaster sut(0x00C8'0315);
  sut.identify();
  sut.run_until(Time(1h));
  sut.expect({"705#R1"});
  sut.expect_log({"@0 5 node_state", "@200 5 failed F"});
}

TEST(BootSlaveReset, follows_what_was_heard_last_where_there_is_no_error_control) {
  KeepingMaster operational;
  operational.start();
  operational.receive("705#05");
  operational.forget();
  operational.answer(5, 0x1000, 0, 0x191);
  operational.expect({});
  operational.expect_log({"5 booted L"});

  KeepingMaster unheard;
  unheard.identify();
  unheard.expect({"000#82 05"});
}

TEST(BootSlaveReset, spares_nobody_when_the_network_begins_unless_one_is_kept_alive) {
  BootNetwork sut;
  sut.assign(4, optional_slave);
  sut.assign(5, kept_alive);
  sut.assign(6, 0x01);
  sut.start();
  sut.expect({"77F#00", "000#82 04", "000#82 06", "605#40 00 10 00 00 00 00 00"});
}

TEST(BootSlaveReset, is_left_to_the_slaves_where_the_owner_wants_it) {
  BootNetwork sut(2, {.options = {.resets_slaves = false}});
  sut.assign(5, optional_slave);
  sut.start();
  sut.expect({"77F#00", "605#40 00 10 00 00 00 00 00"});
  sut.answer(5, 0x1000, 0, 0x191);
  sut.expect({"000#82 05"});
}

}  // namespace
}  // namespace canvoy::boot_slave_reset_test
