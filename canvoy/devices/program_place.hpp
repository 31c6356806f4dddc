// Where a device of the catalogue keeps the program that the network downloads (CiA 302-3, 1F50h):
// offered by its site.
//
//     site.offer(Callback<ProgramPlace()>::to<&Board::program_place>(board));
#pragma once

#include "canvoy/canopen/manager/program_server.hpp"

namespace canvoy {

struct ProgramPlace {
  const Flash* flash = nullptr;  ///< null: there is none, and downloads are refused
  std::uint32_t size = 0;        ///< bytes from address 0 on: whole sectors
  ProgramHooks hooks = {};
};

}  // namespace canvoy
