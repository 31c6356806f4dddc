// Properties of PDOs, for any choice of mappings, values and times.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <map>

#include "canvoy/canopen/testing/mpdo_node.hpp"

namespace canvoy::pdo_property_test {
namespace {

using enum AbortCode;

/// The first PDO prepares the fast path of the next ones.
std::string zeros(std::size_t length) {
  std::string text;
  for (std::size_t i = 0; i < length; ++i) text += "00";
  return text;
}

struct Mappable {
  std::uint16_t index;
  std::uint8_t sub;
  unsigned bits;
};

/// All mappable types, with their lengths in CiA 301 and CiA 447.
std::vector<Mappable> all_mappable() {
  std::vector<Mappable> all;
  const auto add = [&](std::uint16_t index, unsigned sub, unsigned bits) {
    all.push_back({index, static_cast<std::uint8_t>(sub), bits});
  };
  for (unsigned sub = 1; sub <= 16; ++sub) add(0x2000, sub, 8);
  for (unsigned sub = 1; sub <= 8; ++sub) add(0x2010, sub, 16);
  for (unsigned sub = 1; sub <= 4; ++sub) add(0x2020, sub, 32);
  for (unsigned sub = 1; sub <= 64; ++sub) add(0x2030, sub, 1);
  unsigned sub = 1;
  for (unsigned bits = 2; bits <= 31; ++bits) {
    if (bits % 8 != 0) add(0x2040, sub++, bits);
  }
  const std::vector<unsigned> other = {8, 24, 24, 40, 48, 56, 64, 32, 64, 48, 16, 56};
  for (unsigned i = 0; i < other.size(); ++i) add(0x2050, i + 1, other[i]);
  return all;
}

/// Draws any set of them that fits into 64 bits; small ones are preferred, so that many fit.
std::vector<Mappable> any_mapping() {
  const std::vector<Mappable> all = all_mappable();
  std::vector<Mappable> chosen;
  unsigned bits = 0;
  const auto picks = *rc::gen::container<std::vector<std::size_t>>(
      64, rc::gen::inRange<std::size_t>(0, all.size()));
  for (const std::size_t pick : picks) {
    if (bits + all[pick].bits > 64) continue;
    bits += all[pick].bits;
    chosen.push_back(all[pick]);
  }
  return chosen;
}

std::vector<std::uint32_t> records_of(const std::vector<Mappable>& mapping) {
  std::vector<std::uint32_t> records;
  for (const Mappable& m : mapping) {
    records.push_back((std::uint32_t{m.index} << 16) | (std::uint32_t{m.sub} << 8) | m.bits);
  }
  return records;
}

std::vector<bool> bits_of(const std::vector<std::uint8_t>& bytes) {
  std::vector<bool> bits;
  for (const std::uint8_t byte : bytes) {
    for (unsigned bit = 0; bit < 8; ++bit) bits.push_back((byte & (1U << bit)) != 0);
  }
  return bits;
}

std::string hex(const std::vector<std::uint8_t>& bytes) {
  std::string text;
  for (const std::uint8_t byte : bytes) {
    char digits[4];
    std::snprintf(digits, sizeof digits, "%02X", byte);
    text += (text.empty() ? "" : " ") + std::string(digits);
  }
  return text;
}

std::size_t length_of(const std::vector<Mappable>& mapping) {
  std::size_t bits = 0;
  for (const Mappable& m : mapping) bits += m.bits;
  return (bits + 7) / 8;
}

RC_GTEST_PROP(PdoProperty, AnRpdoIsTakenApartBitByBit, ()) {
  const std::vector<Mappable> mapping = any_mapping();
  const auto data = *rc::gen::container<std::vector<std::uint8_t>>(
      length_of(mapping), rc::gen::arbitrary<std::uint8_t>());
  PdoNode node;
  node.map_rpdo(1, 0x205, 255, records_of(mapping));
  node.operate();
  node.receive("205#" + zeros(data.size()));
  node.receive("205#" + hex(data));

  std::map<std::pair<unsigned, unsigned>, std::uint64_t> expected;
  const std::vector<bool> bits = bits_of(data);
  std::size_t position = 0;
  for (const Mappable& m : mapping) {
    std::uint64_t value = 0;
    for (unsigned bit = 0; bit < m.bits; ++bit, ++position) {
      if (bits[position]) value |= std::uint64_t{1} << bit;
    }
    expected[{m.index, m.sub}] = value;
  }
  for (const Mappable& m : all_mappable()) {
    RC_ASSERT(node.number(m.index, m.sub) == (expected[{m.index, m.sub}]));
  }
  RC_ASSERT(node.errors().empty());
}

RC_GTEST_PROP(PdoProperty, ATpdoIsPutTogetherBitByBit, ()) {
  const std::vector<Mappable> mapping = any_mapping();
  PdoNode node;
  std::vector<bool> bits;
  std::map<std::pair<unsigned, unsigned>, std::uint64_t> values;
  for (const Mappable& m : mapping) {
    if (!values.contains({m.index, m.sub})) {
      const auto random = *rc::gen::arbitrary<std::uint64_t>();
      const std::uint64_t value = m.bits == 64 ? random : random % (std::uint64_t{1} << m.bits);
      values[{m.index, m.sub}] = value;
      node.set(m.index, m.sub, value);
    }
    for (unsigned bit = 0; bit < m.bits; ++bit) {
      bits.push_back((values[{m.index, m.sub}] >> bit & 1) != 0);
    }
  }
  std::vector<std::uint8_t> expected(length_of(mapping));
  for (std::size_t bit = 0; bit < bits.size(); ++bit) {
    if (bits[bit]) expected[bit / 8] = static_cast<std::uint8_t>(expected[bit / 8] | 1U << bit % 8);
  }
  node.map_tpdo(1, 0x185, 255, records_of(mapping));
  node.operate();
  node.expect({});
  RC_ASSERT(node.tpdos.trigger(1) == !mapping.empty());
  if (mapping.empty()) return;
  RC_ASSERT(node.sent.size() == 1U);
  RC_ASSERT(wire_text(node.sent[0].frame) == "185#" + hex(expected));
}

/// The consumer's final values are those of the producer, whatever the mapping.
RC_GTEST_PROP(PdoProperty, ValuesTravelFromATpdoToAnRpdoOfAnotherNode, ()) {
  const std::vector<Mappable> mapping = any_mapping();
  RC_PRE(!mapping.empty());
  PdoNode producer;
  PdoNode consumer;
  producer.map_tpdo(1, 0x185, 255, records_of(mapping));
  consumer.map_rpdo(1, 0x185, 255, records_of(mapping));
  producer.operate();
  consumer.operate();
  for (int round = 0; round < 4; ++round) {
    for (const Mappable& m : mapping) {
      const auto random = *rc::gen::arbitrary<std::uint64_t>();
      producer.set(m.index, m.sub, m.bits == 64 ? random : random % (std::uint64_t{1} << m.bits));
    }
    for (const auto& sent : producer.sent) consumer.receive(wire_text(sent.frame));
    producer.sent.clear();
    for (const Mappable& m : mapping) {
      RC_ASSERT(consumer.number(m.index, m.sub) == producer.number(m.index, m.sub));
    }
  }
  RC_ASSERT(consumer.errors().empty());
}

struct Step {
  Duration pause;
  unsigned value;
};
std::vector<Step> any_steps() {
  const auto pauses = *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 30'000));
  std::vector<Step> steps;
  for (const int pause : pauses) steps.push_back({Duration(pause), *rc::gen::inRange(0U, 4U)});
  return steps;
}
void require_distance(const std::vector<WireNode::Sent>& sent, Duration inhibit_time) {
  for (std::size_t i = 1; i < sent.size(); ++i) {
    RC_ASSERT(sent[i].at - sent[i - 1].at >= inhibit_time);
  }
}

RC_GTEST_PROP(PdoProperty, ATpdoKeepsItsInhibitTimeAndEndsWithTheLastValue, ()) {
  const unsigned inhibit_time = *rc::gen::inRange(0U, 200U);
  const unsigned event_timer = *rc::gen::element(0U, 0U, 1U, 7U, 30U);
  PdoNode node;
  RC_ASSERT(node.write(0x1800, 3, inhibit_time) == none);
  RC_ASSERT(node.write(0x1800, 5, event_timer) == none);
  node.map_tpdo(1, 0x4000'0185, 255, {0x2010'01'10});
  node.operate();
  unsigned changes = 0;
  for (const Step& step : any_steps()) {
    node.run_for(step.pause);
    if (node.number(0x2010, 1) != step.value) ++changes;
    node.set(0x2010, 1, step.value);
    if (*rc::gen::inRange(0, 8) == 0) RC_ASSERT(node.tpdos.trigger(1));
  }
  node.run_for(100us * inhibit_time);
  require_distance(node.sent, 100us * inhibit_time);
  if (changes == 0) return;
  RC_ASSERT(!node.sent.empty());
  RC_ASSERT(load<std::uint16_t>(node.sent.back().frame.data.data()) == node.number(0x2010, 1));
}

RC_GTEST_PROP(PdoProperty, AScannerKeepsItsInhibitTimeAndEndsWithTheLastValueOfEachObject, ()) {
  const unsigned inhibit_time = *rc::gen::inRange(0U, 200U);
  MpdoNode producer;
  MpdoNode consumer(Tpdos::AtStart::wait_for_event, 10);
  RC_ASSERT(producer.write(0x1800, 3, inhibit_time) == none);
  producer.fill_list(0x1FA0, {0x08'2010'01});
  producer.use_tpdo(1, 0x185, 0xFE);
  producer.operate();
  consumer.fill_list(0x1FD0, {0x08'2010'01'2010'01'05});
  consumer.use_rpdo(1, 0x185, 0xFE);
  consumer.operate();
  for (const Step& step : any_steps()) {
    producer.run_for(step.pause);
    producer.set(0x2010, static_cast<std::uint8_t>(*rc::gen::inRange(1, 9)), step.value);
  }
  producer.run_for(8 * 100us * inhibit_time);
  require_distance(producer.sent, 100us * inhibit_time);
  for (const auto& sent : producer.sent) consumer.receive(wire_text(sent.frame));
  for (std::uint8_t sub = 1; sub <= 8; ++sub) {
    RC_ASSERT(consumer.number(0x2010, sub) == producer.number(0x2010, sub));
  }
}

}  // namespace
}  // namespace canvoy::pdo_property_test
