// An NMT master for tests at the wire: the contents of 1F80h to 1F89h are set before it starts, the
// test acts as the slaves, and each step is recorded.
//
//     BootNetwork sut;
//     sut.assign(5, 0x0D);
//     sut.start();
//     sut.expect({"77F#00", "000#82 00"});
//     sut.receive("705#00");
//     sut.expect({"605#40 00 10 00 00 00 00 00"});
//
// For tests only.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "canvoy/canopen/dictionary/dictionary_layout.hpp"
#include "canvoy/canopen/manager/boot_manager.hpp"
#include "canvoy/canopen/testing/wire.hpp"

namespace canvoy {

namespace detail {

constexpr EntryRow boot_entries(std::uint8_t first, std::uint8_t last, DataType type,
                                Access access = Access::rw) {
  return {.sub_first = first, .sub_last = last, .type = type, .access = access};
}
constexpr EntryRow boot_count(std::int64_t highest) {
  return {.type = DataType::unsigned8, .access = Access::const_, .initial = highest};
}

inline constexpr auto boot_layout =
    partial(lay_out(std::to_array<ObjectRow>({{.index = 0x1000, .entry_count = 1},
                                              {.index = 0x1016, .entry_count = 2},
                                              {.index = 0x102A, .entry_count = 1},
                                              {.index = 0x1F80, .entry_count = 1},
                                              {.index = 0x1F81, .entry_count = 2},
                                              {.index = 0x1F82, .count = 2, .entry_count = 3},
                                              {.index = 0x1F84, .count = 5, .entry_count = 2},
                                              {.index = 0x1F89, .entry_count = 1},
                                              {.index = 0x1F90, .entry_count = 2},
                                              {.index = 0x1F91, .entry_count = 2}}),
                    std::to_array<EntryRow>({
                        boot_entries(0, 0, DataType::unsigned32, Access::const_),
                        boot_count(127),
                        boot_entries(1, 127, DataType::unsigned32),
                        boot_entries(0, 0, DataType::unsigned16),
                        boot_entries(0, 0, DataType::unsigned32),
                        boot_count(127),
                        boot_entries(1, 127, DataType::unsigned32),
                        boot_count(128),
                        boot_entries(1, 127, DataType::unsigned8),
                        boot_entries(128, 128, DataType::unsigned8, Access::wo),
                        boot_count(127),
                        boot_entries(1, 127, DataType::unsigned32),
                        boot_entries(0, 0, DataType::unsigned32),
                        boot_count(6),
                        boot_entries(1, 6, DataType::unsigned16),
                        boot_count(3),
                        boot_entries(1, 3, DataType::unsigned16),
                    })));

}  // namespace detail

/// Values that objects have after each reset, as if they were stored.
class StoredValues {
 public:
  explicit StoredValues(Node& node) : node_(node) {
    service_.reset = callback<&StoredValues::reset>(*this);
    node.attach(service_);
  }
  void store(std::uint16_t index, std::uint8_t sub, std::uint32_t value) {
    values_.push_back({index, sub, value});
  }

 private:
  struct Value {
    std::uint16_t index;
    std::uint8_t sub;
    std::uint32_t value;
  };
  /// Writes the values, so that services that were reset before are notified.
  void reset(ResetScope) {
    for (const Value& value : values_) {
      const Result<Entry> entry = node_.dictionary().find(value.index, value.sub);
      ASSERT_TRUE(entry);
      std::array<std::uint8_t, 4> bytes{};
      canvoy::store(bytes.data(), value.value);
      EXPECT_EQ(node_.dictionary().write(*entry, std::span(bytes).first(entry->row->capacity),
                                         Source::application),
                AbortCode::none);
    }
  }

  Node& node_;
  Service service_;
  std::vector<Value> values_;
};

/// Text of the steps and events of slaves: `@1000 5 vendor_id`, `@1000 5 failed D found 00000002`.
inline std::string boot_text(const BootReport& report) {
  static constexpr const char* steps[] = {
      "waiting",    "device_type", "vendor_id", "product_code",  "revision_number", "serial_number",
      "node_state", "reset",       "program",   "configuration", "error_control",   "done"};
  static constexpr const char* events[] = {"",       "no_boot_up", "restarted", "retried",
                                           "failed", "booted",     "started",   "lost",
                                           "slowed", "given_up",   "unknown"};
  std::string text = std::to_string(report.slave) + " ";
  if (report.event == BootEvent::step) return text + steps[static_cast<unsigned>(report.step)];
  text += events[static_cast<unsigned>(report.event)];
  const bool ends = report.event == BootEvent::retried || report.event == BootEvent::failed ||
                    report.event == BootEvent::booted || report.event == BootEvent::unknown ||
                    report.event == BootEvent::given_up;
  if (report.event == BootEvent::restarted) {
    text += std::string(" in ") + steps[static_cast<unsigned>(report.step)];
  }
  if (ends && report.outcome.error != BootError::none) {
    text += std::string(" ") + letter(report.outcome.error);
  }
  char number[32];
  if (!report.outcome.end) {
    std::snprintf(number, sizeof number, " %08X",
                  static_cast<unsigned>(report.outcome.end.abort()));
    text += number;
  } else if (report.event == BootEvent::failed && report.expected != report.found) {
    std::snprintf(number, sizeof number, " %08X not %08X", report.found, report.expected);
    text += number;
  }
  return text;
}

/// Node 127, with two slots unless the test sets others.
class BootNetwork : public WireNode {
 public:
  explicit BootNetwork(std::size_t slot_count = 2, const BootManager::Settings& settings = {},
                       NodeId id = 127)
      : WireNode(detail::boot_layout.tables(), id),
        stored(node),
        slots_(node),
        master(node, remotes_),
        commands(node, requests_),
        manager(node, master, commands,
                {records_, std::span<BootSlave>(slots_.all).first(slot_count)}, settings) {
    manager.on_report(callback<&BootNetwork::note>(*this));
    manager.on_network(callback<&BootNetwork::note_network>(*this));
    startup(0x01);
  }

  void startup(std::uint32_t value) { stored.store(0x1F80, 0, value); }
  void assign(NodeId slave, std::uint32_t value) { stored.store(0x1F81, slave, value); }
  /// Sets 1016h: the longest time between heartbeats of this slave in milliseconds.
  void watch(NodeId slave, std::uint32_t ms) {
    stored.store(0x1016, ++watched_, static_cast<std::uint32_t>(slave) << 16 | ms);
  }
  AbortCode write(std::uint16_t index, std::uint8_t sub, std::uint32_t number) {
    std::array<std::uint8_t, 4> bytes{};
    canvoy::store(bytes.data(), number);
    node.advance(now);
    const Result<Entry> entry = node.dictionary().find(index, sub);
    if (!entry) return entry.abort();
    const AbortCode answer =
        node.dictionary().write(*entry, std::span(bytes).first(entry->row->capacity), Source::sdo);
    settle();
    return answer;
  }

  /// Starts the node, up to the reset of all slaves.
  void start() {
    WireNode::start();
    settle();
  }
  /// Answers an upload that is under way, as the slave, with a 32-bit number.
  void answer(NodeId slave, std::uint16_t index, std::uint8_t sub, std::uint32_t value) {
    Frame frame = Frame::data_frame(0x580U + slave, {0x43, 0, 0, 0, 0, 0, 0, 0});
    canvoy::store(&frame.data[1], index);
    frame.data[3] = sub;
    canvoy::store(&frame.data[4], value);
    node.receive(frame, now);
    settle();
  }
  /// Sends the boot-up message of a slave.
  void boot_up(NodeId slave) {
    node.receive(Frame::data_frame(0x700U + slave, {0}), now);
    settle();
  }
  void heartbeat(NodeId slave, std::uint8_t state) {
    node.receive(Frame::data_frame(0x700U + slave, {state}), now);
    settle();
  }
  /// Boots a slave without expected values and without error control.
  void bring_up(NodeId slave) {
    boot_up(slave);
    answer(slave, 0x1000, 0, 0);
  }

  /// Compares the reports since the last call, with times in ms if the test gives them.
  void expect_log(const std::vector<std::string>& expected) {
    std::vector<std::string> actual;
    for (std::size_t i = 0; i < log.size(); ++i) {
      const bool timed = i < expected.size() && expected[i].starts_with('@');
      actual.push_back((timed ? "@" + std::to_string(log[i].ms) + " " : "") + log[i].text);
    }
    EXPECT_EQ(actual, expected);
    log.clear();
  }
  void forget() {
    log.clear();
    sent.clear();
  }

  struct Note {
    long ms;
    std::string text;
  };
  std::vector<Note> log;

 private:
  void note(const BootReport& report) {
    log.push_back({now.time_since_epoch() / 1ms, boot_text(report)});
  }
  void note_network(NetworkBoot state) {
    static constexpr const char* names[] = {"idle", "booting", "failed", "complete"};
    log.push_back({now.time_since_epoch() / 1ms,
                   std::string("network ") + names[static_cast<unsigned>(state)]});
  }

  struct Slots {
    explicit Slots(Node& node)
        : all{BootSlave(node), BootSlave(node), BootSlave(node), BootSlave(node)} {}
    std::array<BootSlave, 4> all;
  };

 public:
  StoredValues stored;

 private:
  Slots slots_;
  std::array<NmtMaster::RemoteNode, 127> remotes_;
  std::array<NmtQueue::Request, 128> requests_{};
  std::array<BootManager::Record, 127> records_{};
  std::uint8_t watched_ = 0;

 public:
  NmtMaster master;
  NmtQueue commands;
  BootManager manager;
};

}  // namespace canvoy
