// Words for PDOs that were not decoded, since no node has told its profile.
//
//     unknown_pdos_text(unknown, network, {.fate = "shown as bytes"});
//     // no node has told its profile (1000h): 17 PDOs are shown as bytes; they look like ...
#pragma once

#include <string>
#include <string_view>

#include "canvoy/decoder/unknown_pdos.hpp"

namespace canvoy::text {

/// How the frames are told.
struct UnknownPdosWords {
  std::string_view fate = "not decoded";  ///< what became of the frames: `are ...`
  std::string_view bus = {};              ///< for the option of this bus alone; empty: of all
  bool is_counted = true;                 ///< with the number of frames, which changes on a bus
  /// Nothing where no profile explains them: for a caller who tells of unknown nodes itself.
  bool only_with_guess = false;
};

/// One line, without a full stop; empty if there are no such frames.
std::string unknown_pdos_text(decoder::UnknownPdos& unknown, const decoder::Network& network,
                              const UnknownPdosWords& words);

}  // namespace canvoy::text
