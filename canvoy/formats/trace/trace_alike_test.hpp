// Two logs of one frame that must give the same result: one as tools write it, for the fast path,
// and one with a tab, for the tolerant path.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "canvoy/formats/trace/trace.hpp"

namespace canvoy::formats {

inline void expect_read_alike(const std::string& quick, const std::string& careful) {
  auto first = TraceReader::of(quick);
  auto second = TraceReader::of(careful);
  TraceFrame a;
  TraceFrame b;
  const TraceRead read = first->next(a);
  ASSERT_EQ(read, second->next(b)) << quick;
  if (read != TraceRead::frame) return;
  ASSERT_EQ(a.frame, b.frame) << quick;
  ASSERT_EQ(a.time, b.time) << quick;
  ASSERT_EQ(a.channel, b.channel) << quick;
  ASSERT_EQ(a.direction, b.direction) << quick;
}

}  // namespace canvoy::formats
