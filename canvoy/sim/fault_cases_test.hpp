// Which faults are tried one by one in a whole world: all; with sanitizers, which make a world four
// times as slow, each fourth. Each kind is tried there too, in pairs: fault_pairs_test.hpp.
#pragma once

#include <cstddef>
#include <vector>

namespace canvoy {

template <class Case, std::size_t count>
std::vector<Case> cases_here(const Case (&cases)[count]) {
#ifdef NDEBUG
  constexpr std::size_t step = 1;
#else
  constexpr std::size_t step = 4;
#endif
  std::vector<Case> here;
  for (std::size_t i = 0; i < count; i += step) here.push_back(cases[i]);
  return here;
}

}  // namespace canvoy
