#include "canvoy/canopen/dictionary/dictionary.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "canvoy/canopen/testing/held_dictionary.hpp"

namespace canvoy::dictionary_hook_test {
namespace {

// Hooks

/// A hook that records its calls, and refuses on request.
struct Recorder {
  Recorder(Dictionary& dictionary, std::uint16_t first, std::uint16_t last,
           std::vector<std::string>& calls, std::string by)
      : log(calls), name(std::move(by)) {
    hook.first = first;
    hook.last = last;
    hook.before_read = Callback<AbortCode(const Entry&)>::to<&Recorder::before_read>(*this);
    hook.before_write = Callback<AbortCode(
        const Entry&, std::span<const std::uint8_t>)>::to<&Recorder::before_write>(*this);
    hook.after_write = Callback<void(const Entry&, Source)>::to<&Recorder::after_write>(*this);
    dictionary.attach(hook);
  }
  void note(const char* what, const Entry& entry) {
    char text[64];
    std::snprintf(text, sizeof text, "%s %s %04X:%u", name.c_str(), what, entry.index, entry.sub);
    log.emplace_back(text);
  }
  AbortCode before_read(const Entry& entry) {
    note("reads", entry);
    return answer;
  }
  AbortCode before_write(const Entry& entry, std::span<const std::uint8_t> value) {
    note("checks", entry);
    seen.assign(value.begin(), value.end());
    return answer;
  }
  void after_write(const Entry& entry, Source by) {
    note("wrote", entry);
    source = by;
  }

  Hook hook;
  std::vector<std::string>& log;
  std::string name;
  AbortCode answer = AbortCode::none;
  Source source = Source::application;
  Bytes seen;
};

using Log = std::vector<std::string>;

TEST(DictionaryHook, IsCalledBeforeAReadAndAroundAWrite) {
  Held sut(shapes.tables());
  Log log;
  Recorder hook(sut.dictionary, 0x1018, 0x1018, log, "a");
  EXPECT_EQ(sut.read(0x1018, 1), (Bytes{0, 0, 0, 0}));
  EXPECT_EQ(sut.write(0x1018, 1, {1, 2, 3, 4}, Source::pdo), AbortCode::none);
  EXPECT_EQ(log, (Log{"a reads 1018:1", "a checks 1018:1", "a wrote 1018:1"}));
  EXPECT_EQ(hook.seen, (Bytes{1, 2, 3, 4}));
  EXPECT_EQ(hook.source, Source::pdo);
}

TEST(DictionaryHook, IsCalledForItsRangeWithinARowOfObjectsOnly) {
  Held sut(shapes.tables());
  Log log;
  Recorder hook(sut.dictionary, 0x6105, 0x6106, log, "a");
  for (std::uint16_t index = 0x6104; index <= 0x6107; ++index) sut.write(index, 9, {1});
  sut.write(0x6000, 1, {1, 2});
  sut.write(0xFFFF, 0, {1});
  EXPECT_EQ(log, (Log{"a checks 6105:9", "a wrote 6105:9", "a checks 6106:9", "a wrote 6106:9"}));
}

/// More than a row keeps by itself, and fewer again.
TEST(DictionaryHook, TheLastOneComesFirstHoweverManyThereAre) {
  Held sut(shapes.tables());
  Log log, expected;
  std::vector<std::unique_ptr<Recorder>> hooks;
  for (char name = 'a'; name <= 'f'; ++name) {
    hooks.push_back(
        std::make_unique<Recorder>(sut.dictionary, 0x1018, 0x1018, log, std::string(1, name)));
    expected.insert(expected.begin(), std::string(1, name) + " reads 1018:1");
    log.clear();
    sut.read(0x1018, 1);
    EXPECT_EQ(log, expected);
  }
  for (const std::size_t gone : {3U, 0U, 4U, 1U}) {
    sut.dictionary.detach(hooks[gone]->hook);
    std::erase(expected, hooks[gone]->name + " reads 1018:1");
    log.clear();
    sut.read(0x1018, 1);
    EXPECT_EQ(log, expected);
  }
}

TEST(DictionaryHook, OneThatIsAttachedByAnotherHasNoPartInTheAccessUnderWay) {
  Held sut(shapes.tables());
  Log log;
  Recorder first(sut.dictionary, 0x1018, 0x1018, log, "a");
  Recorder second(sut.dictionary, 0x1018, 0x1018, log, "b");
  std::unique_ptr<Recorder> third;
  auto attach = [&](const Entry&) {
    log.emplace_back("attaches");
    if (third == nullptr) {
      third = std::make_unique<Recorder>(sut.dictionary, 0x1018, 0x1018, log, "c");
    }
    return AbortCode::none;
  };
  second.hook.before_read = Callback<AbortCode(const Entry&)>::of(attach);
  sut.read(0x1018, 1);
  EXPECT_EQ(log, (Log{"attaches", "a reads 1018:1"}));
}

TEST(DictionaryHook, IsCalledForItsRangeOnly) {
  Held sut(shapes.tables());
  Log log;
  Recorder hook(sut.dictionary, 0x6105, 0x6106, log, "a");
  EXPECT_EQ(sut.write(0x6000, 1, {1, 2}), AbortCode::none);
  EXPECT_EQ(sut.read(0x1018, 1), (Bytes{0, 0, 0, 0}));
  EXPECT_EQ(log, Log{});
  EXPECT_EQ(sut.write(0x6106, 9, {1}), AbortCode::none);
  EXPECT_EQ(log, (Log{"a checks 6106:9", "a wrote 6106:9"}));
}

TEST(DictionaryHook, MayRefuseAReadOrAWriteWhichThenChangesNothing) {
  Held sut(shapes.tables());
  Log log;
  Recorder hook(sut.dictionary, 0x1018, 0x1018, log, "a");
  sut.write(0x1018, 1, {1, 2, 3, 4});
  log.clear();
  hook.answer = AbortCode::device_state;
  EXPECT_EQ(sut.write(0x1018, 1, {5, 6, 7, 8}), AbortCode::device_state);
  EXPECT_EQ(sut.read(0x1018, 1), Bytes{});
  EXPECT_EQ(sut.abort, AbortCode::device_state);
  EXPECT_EQ(log, (Log{"a checks 1018:1", "a reads 1018:1"})) << "after_write is not called";
  hook.answer = AbortCode::none;
  EXPECT_EQ(sut.read(0x1018, 1), (Bytes{1, 2, 3, 4}));
}

TEST(DictionaryHook, IsNotAskedWhenAccessLengthOrRangeForbidTheWrite) {
  Held sut(shapes.tables());
  Log log;
  Recorder hook(sut.dictionary, 0x0000, 0xFFFF, log, "a");
  EXPECT_EQ(sut.write(0x1018, 0, {1}), AbortCode::read_only);
  EXPECT_EQ(sut.write(0x1018, 1, {1}), AbortCode::length_too_low);
  EXPECT_EQ(sut.write(0x1018, 2, {1}), AbortCode::no_sub_index);
  EXPECT_EQ(log, Log{});
}

TEST(DictionaryHook, StandsBesideOthersOnOneObjectAndTheLastAttachedComesFirst) {
  Held sut(shapes.tables());
  Log log;
  Recorder a(sut.dictionary, 0x1018, 0x1018, log, "a");
  Recorder b(sut.dictionary, 0x1000, 0x1FFF, log, "b");
  EXPECT_EQ(sut.write(0x1018, 1, {1, 2, 3, 4}), AbortCode::none);
  EXPECT_EQ(log, (Log{"b checks 1018:1", "a checks 1018:1", "b wrote 1018:1", "a wrote 1018:1"}));
  log.clear();
  b.answer = AbortCode::local_control;
  EXPECT_EQ(sut.write(0x1018, 1, {5, 6, 7, 8}), AbortCode::local_control);
  EXPECT_EQ(log, (Log{"b checks 1018:1"})) << "the first refusal is the answer";
}

TEST(DictionaryHook, IsNotCalledForWhatTheDeviceItselfSets) {
  Held sut(shapes.tables());
  Log log;
  Recorder hook(sut.dictionary, 0x0000, 0xFFFF, log, "a");
  sut.dictionary.set_number(0x1018, 1, 7);
  sut.dictionary.set(sut.entry(0x1018, 3), Bytes{1, 2});
  sut.dictionary.restore_defaults(0, 0xFFFF, 1);
  EXPECT_EQ(log, Log{});
}

TEST(DictionaryHook, MayRefreshAValueBeforeItIsRead) {
  struct Clock {
    AbortCode tick(const Entry& entry) {
      dictionary.set(entry, bytes_of(++count, 4));
      return AbortCode::none;
    }
    Dictionary& dictionary;
    std::uint32_t count = 0;
  };
  Held sut(shapes.tables());
  Clock clock{sut.dictionary};
  Hook hook{.first = 0x1018, .last = 0x1018};
  hook.before_read = Callback<AbortCode(const Entry&)>::to<&Clock::tick>(clock);
  sut.dictionary.attach(hook);
  EXPECT_EQ(sut.read(0x1018, 1), (Bytes{1, 0, 0, 0}));
  EXPECT_EQ(sut.read(0x1018, 1), (Bytes{2, 0, 0, 0}));
}

TEST(DictionaryHook, IsAskedNoMoreOnceItIsDetached) {
  Held sut(shapes.tables());
  Log log;
  Recorder a(sut.dictionary, 0x1018, 0x1018, log, "a");
  Recorder b(sut.dictionary, 0x1018, 0x1018, log, "b");
  Recorder c(sut.dictionary, 0x1018, 0x1018, log, "c");
  sut.dictionary.detach(b.hook);
  EXPECT_EQ(sut.write(0x1018, 1, {1, 2, 3, 4}), AbortCode::none);
  EXPECT_EQ(log, (Log{"c checks 1018:1", "a checks 1018:1", "c wrote 1018:1", "a wrote 1018:1"}));
  log.clear();
  sut.dictionary.detach(c.hook);
  sut.dictionary.detach(a.hook);
  sut.dictionary.detach(a.hook);  // not attached
  EXPECT_EQ(sut.write(0x1018, 1, {1, 2, 3, 4}), AbortCode::none);
  EXPECT_EQ(log, Log{});
  sut.dictionary.attach(b.hook);
  Recorder d(sut.dictionary, 0x1018, 0x1018, log, "d");
  EXPECT_EQ(sut.write(0x1018, 1, {1, 2, 3, 4}), AbortCode::none);
  EXPECT_EQ(log, (Log{"d checks 1018:1", "b checks 1018:1", "d wrote 1018:1", "b wrote 1018:1"}));
}

TEST(DictionaryHook, IsCountedAsARevision) {
  Held sut(shapes.tables());
  const std::uint32_t before = sut.dictionary.revision();
  Hook hook{.first = 0x1018, .last = 0x1018};
  sut.dictionary.attach(hook);
  EXPECT_NE(sut.dictionary.revision(), before);
}

TEST(DictionaryHook, IsToldAloneByAnnounce) {
  Held sut(shapes.tables());
  Log log;
  Recorder hook(sut.dictionary, 0x1018, 0x1018, log, "a");
  sut.dictionary.announce(sut.entry(0x1018, 1), Source::pdo);
  sut.dictionary.announce(sut.entry(0x6000, 1), Source::pdo);
  EXPECT_EQ(log, (Log{"a wrote 1018:1"}));
}

// Domains

constexpr auto domains = lay_out(std::to_array<ObjectRow>({{.index = 0x1F50, .entry_count = 2}}),
                                 std::to_array<EntryRow>({{.access = Access::const_, .initial = 1},
                                                          {.sub_first = 1,
                                                           .sub_last = 1,
                                                           .type = DataType::domain,
                                                           .access = Access::rw,
                                                           .capacity = 99}}));

TEST(DictionaryDomain, TakesNoMemoryAndHasNoValueOfItsOwn) {
  EXPECT_EQ(domains.tables().value_bytes, 1U);
  Held sut(domains.tables());
  sut.read(0x1F50, 1);
  EXPECT_EQ(sut.abort, AbortCode::unsupported_access);
  EXPECT_FALSE(sut.dictionary.set_number(0x1F50, 1, 5));
  EXPECT_EQ(sut.dictionary.domain(sut.entry(0x1F50, 1)), nullptr);
}

TEST(DictionaryDomain, IsServedByTheHookThatCarriesIt) {
  Held sut(domains.tables());
  const Domain domain{};
  Hook other{.first = 0x1F50, .last = 0x1F50};
  Hook hook{.first = 0x1F50, .last = 0x1F50, .domain = &domain};
  Hook elsewhere{.first = 0x1F51, .last = 0x1F51, .domain = &domain};
  sut.dictionary.attach(hook);
  sut.dictionary.attach(other);
  sut.dictionary.attach(elsewhere);
  EXPECT_EQ(sut.dictionary.domain(sut.entry(0x1F50, 1)), &domain);
}

}  // namespace
}  // namespace canvoy::dictionary_hook_test
